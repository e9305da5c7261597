/** How well each part of a live trial does: a number, and whether to look at it. */

import type { Lag, Reading } from "./live";
import { make } from "./words";

const AGED = 100;
const LAGGING = 100;
const LAGGING_AT_WORST = 250;
/** ms above which somebody should look (ours). */

/** What the page itself knows of the participant's screen and of the connection. */
export function measured(lag: Lag | null, age: number): Reading[] {
  const screen: Reading[] = lag ? [
    { name: "screen lag, median", value: lag.median_ms, unit: "ms", ok: lag.median_ms <= LAGGING },
    { name: "screen lag, p99", value: lag.p99_ms, unit: "ms", ok: lag.p99_ms <= LAGGING_AT_WORST },
    { name: "frames shown", value: lag.frames, unit: "", ok: true },
  ] : [{ name: "frames shown", value: 0, unit: "", ok: false }];
  return [...screen, { name: "age of the last state", value: age, unit: "ms", ok: age <= AGED }];
}

export class Health {
  readonly element: HTMLElement;
  private readonly body = make("tbody");
  private rows: [name: string, value: HTMLElement, state: HTMLElement][] = [];

  constructor() {
    const heads = ["What", "Now", "State"].map((name) => make("th", { scope: "col" }, name));
    this.element = make("div", {}, make("h2", {}, "Health"),
      make("table", { class: "health" }, make("thead", {}, make("tr", {}, ...heads)), this.body));
  }

  show(readings: Reading[]): void {
    const names = readings.map(({ name }) => name);
    if (names.join() !== this.rows.map(([name]) => name).join()) this.layOut(names);
    readings.forEach(({ value, unit, ok }, i) => {
      const [, figure, state] = this.rows[i]!;
      const digits = Number.isInteger(value) ? 0 : 1;
      figure.textContent = `${value.toFixed(digits)} ${unit}`.trim();
      const word = ok ? "ok" : "look";
      if (state.textContent === word) return;
      state.textContent = word;
      state.className = word;
    });
  }

  private layOut(names: string[]): void {
    this.rows = names.map((name) => [name, make("td", { class: "number" }), make("td")]);
    this.body.replaceChildren(...this.rows.map(([name, value, state]) => make("tr", {},
      make("th", { scope: "row" }, name), value, state)));
  }
}
