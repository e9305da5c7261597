/** Where in the protocol a live trial is, what comes next, and how long that will take. */

import type { LiveSetting, State } from "./live";
import { clock, make } from "./words";

const AHEAD = 3;
/** Trials to come that are named. */

/** s that are still to be expected of a visit: what is left of this trial, and all that follows. */
export function remaining(setting: LiveSetting, state: State): number {
  const running = state.status === "running" ? Math.max(0, setting.expected_s - state.t) : 0;
  return setting.coming.reduce((sum, { expected_s }) => sum + setting.pause_s + expected_s, running);
}

/** One trial in words: the masked label says less than the name. */
export function named({ label, masked }: LiveSetting): string {
  return masked ? `label ${label}` : label;
}

export class Progress {
  readonly element: HTMLElement;
  private readonly list = make("ol", { class: "coming" });
  private readonly none = make("p", { class: "none" }, "Nothing more in this visit.");

  constructor() {
    this.element = make("div", {}, make("h2", {}, "What comes next"), this.list, this.none);
    this.element.hidden = true;
  }

  open(setting: LiveSetting): void {
    this.element.hidden = false;
    const next = setting.coming.slice(0, AHEAD);
    this.list.replaceChildren(...next.map(({ place, kind, label, route, expected_s }) => make("li", {},
      make("span", { class: "time" }, `${place} of ${setting.places}`),
      ` ${[label === "" ? "to be chosen" : named({ ...setting, label }), route, kind].join(" · ")} `,
      make("span", { class: "detail" }, clock(expected_s)))));
    this.none.hidden = next.length > 0;
  }

  close(): void {
    this.element.hidden = true;
  }
}
