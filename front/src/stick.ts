/** The stick as a pointer: a push goes to the next choice, a twist or a push that is held takes it. */

import type { Choices } from "./choices";

const CENTRE = 0.25;
const PUSHED = 0.6;
/** Parts of the stick's travel within which it rests, and from which it is pushed. */
const HELD_MS = 1500;

export type Push = [x: number, y: number, theta: number];

export class StickPointer {
  private ready = false;
  private pushedAt = 0;

  constructor(private readonly choices: Choices) {}

  /** Another page has come: what the stick does now was not meant for it. */
  forget(): void {
    this.ready = false;
    this.pushedAt = 0;
  }

  follow([x, y, theta]: Push, now: number): void {
    if (Math.max(Math.abs(x), Math.abs(y), Math.abs(theta)) < CENTRE) {
      this.ready = true;
      this.pushedAt = 0;
    } else if (this.ready && Math.abs(theta) > PUSHED) {
      this.ready = false;
      this.choices.take();
    } else if (this.ready && Math.max(Math.abs(x), Math.abs(y)) > PUSHED) {
      this.ready = false;
      this.pushedAt = now;
      const most = Math.abs(x) > Math.abs(y) ? x : y;
      this.choices.move(most > 0 ? -1 : 1);
    } else if (this.pushedAt && now - this.pushedAt > HELD_MS) {
      this.pushedAt = 0;
      this.choices.take();
    }
  }
}
