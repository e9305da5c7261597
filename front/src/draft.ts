/** What was written on a page so far: a page that is loaded again has it still. */

const PREFIX = "omnistudy draft ";

export class Draft {
  step = 0;
  private values: { [name: string]: string } = {};

  constructor(private readonly mark: string) {
    const kept = sessionStorage.getItem(PREFIX + mark);
    if (kept) Object.assign(this, JSON.parse(kept) as object);
    for (const key of Object.keys(sessionStorage)) {
      if (key.startsWith(PREFIX) && key !== PREFIX + mark) sessionStorage.removeItem(key);
    }
  }

  value(name: string): string {
    return this.values[name] ?? "";
  }

  keep(name: string, value: string): void {
    this.values[name] = value;
    this.store();
  }

  goTo(step: number): void {
    this.step = step;
    this.store();
  }

  /** Leave nothing behind once it was handed in. */
  forget(): void {
    sessionStorage.removeItem(PREFIX + this.mark);
  }

  private store(): void {
    sessionStorage.setItem(PREFIX + this.mark, JSON.stringify({ step: this.step, values: this.values }));
  }
}
