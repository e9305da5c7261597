/** Which keys are held, for a session whose device is the keyboard. */

const REPEAT_MS = 100;
const WRITTEN_IN = "input[type=text], textarea";

export class Keys {
  private readonly held = new Set<string>();
  private repeating = 0;

  constructor(private readonly send: (codes: string[]) => void) {
    addEventListener("keydown", (event) => {
      if (event.repeat || (event.target as Element).matches?.(WRITTEN_IN)) return;
      this.held.add(event.code);
      this.tell();
    });
    addEventListener("keyup", (event) => {
      if (this.held.delete(event.code)) this.tell();
    });
    addEventListener("blur", () => this.release());
    document.addEventListener("visibilitychange", () => this.release());
  }

  private release(): void {
    if (!this.held.size) return;
    this.held.clear();
    this.tell();
  }

  private tell(): void {
    clearInterval(this.repeating);
    this.send([...this.held]);
    if (this.held.size) this.repeating = window.setInterval(() => this.send([...this.held]), REPEAT_MS);
  }
}
