/** Choices of a page that are lit one after the other and taken, without pointer or keyboard. */

const CHOICES = "button:enabled, input[type=radio]:enabled, input[type=checkbox]:enabled";
const ROW = "[data-row]";
/** A row of letters is one choice until it is taken; then its letters are. */

export class Choices {
  private lit: HTMLElement | null = null;
  private row: HTMLElement | null = null;

  constructor(private readonly root: HTMLElement) {}

  /** Light the choice that is so many places on; beyond the end it begins again. */
  move(by: number): void {
    const all = this.all();
    if (!all.length) return;
    const at = this.lit ? all.indexOf(this.lit) : -1;
    const next = at < 0 ? (by > 0 ? 0 : all.length - 1) : at + by;
    if (this.row && (next < 0 || next >= all.length)) {
      this.leaveRow();
      return;
    }
    this.light(all[(next + all.length) % all.length]!);
  }

  /** Take what is lit. */
  take(): void {
    const taken = this.lit;
    if (!taken || !this.all().includes(taken)) return;
    if (taken.matches(ROW)) {
      this.row = taken;
      this.light(this.all()[0]!);
      return;
    }
    if (this.row) this.leaveRow();
    taken.click();
  }

  /** Another page has come: begin with its first choice. */
  forget(): void {
    this.lit?.classList.remove("lit");
    this.lit = this.row = null;
  }

  private leaveRow(): void {
    const row = this.row!;
    this.row = null;
    this.light(row);
  }

  private light(choice: HTMLElement): void {
    this.lit?.classList.remove("lit");
    this.lit = choice;
    choice.classList.add("lit");
    choice.focus();
    choice.scrollIntoView({ block: "nearest" });
  }

  private all(): HTMLElement[] {
    if (this.row && !this.row.isConnected) this.row = null;
    const within = this.row;
    const found = [...(within ?? this.root).querySelectorAll<HTMLElement>(`${CHOICES}, ${ROW}`)];
    return found.filter((one) => one.getClientRects().length > 0 && (within !== null || !one.parentElement!.closest(ROW)));
  }
}
