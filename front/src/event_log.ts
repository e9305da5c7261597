/** What happened in a trial so far, the latest first; each state brings the last few events. */

import { clock, make } from "./words";

type Event = [t: number, kind: string, detail: string];

export class EventLog {
  readonly element: HTMLElement;
  private readonly list = make("ol", { class: "events" });
  private trial = 0;
  private newest = "";
  private known: string[] = [];

  constructor() {
    this.element = make("div", {}, make("h2", {}, "What happened"), this.list);
  }

  show(trial: number, events: Event[]): void {
    const written = events.map((event) => JSON.stringify(event));
    const newest = `${trial} ${written.join()}`;
    if (newest === this.newest) return;
    this.newest = newest;
    if (trial !== this.trial) {
      this.trial = trial;
      this.known = [];
      this.list.replaceChildren();
    }
    events.forEach(([t, kind, detail], i) => {
      if (this.known.includes(written[i]!)) return;
      this.known.push(written[i]!);
      this.list.prepend(make("li", {},
        make("span", { class: "time" }, clock(t)), ` ${kind.replaceAll("_", " ")} `,
        make("span", { class: "detail" }, detail)));
    });
  }
}
