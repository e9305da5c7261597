/** One switch for everything: choices are lit at a pace, any key or touch takes the lit one. */

import type { Choices } from "./choices";

const BOUNCE_MS = 250;
/** A switch that is pressed again so soon was pressed once. */

export interface Scanning { one_switch: boolean; pace: number }

export class Switch {
  private next = 0;
  private pressedAt = -Infinity;

  constructor(private readonly choices: Choices, private readonly pace: number) {
    for (const kind of ["keydown", "keyup", "keypress", "pointerdown", "mousedown", "click"]) {
      addEventListener(kind, (event) => this.hear(event), { capture: true });
    }
  }

  /** To be called at every frame. */
  scan(now: number): void {
    if (now < this.next) return;
    this.next = now + 1000 * this.pace;
    this.choices.move(1);
  }

  private hear(event: Event): void {
    if (!event.isTrusted) return;
    event.preventDefault();
    event.stopImmediatePropagation();
    const pressed = event.type === "pointerdown" || (event instanceof KeyboardEvent && event.type === "keydown" && !event.repeat);
    if (!pressed || event.timeStamp - this.pressedAt < BOUNCE_MS) return;
    this.pressedAt = event.timeStamp;
    this.next = performance.now() + 1000 * this.pace;
    this.choices.take();
  }
}
