/** The session's clock as a page knows it: by asking, and halving how long the answer took. */

const KEPT = 20_000;
/** ms for which an answer is believed, so that two clocks have no time to drift apart. */

export class ServerClock {
  /** ms by which `now` may be wrong: half of the quickest question and answer. */
  within = Infinity;
  private ahead = 0;
  private learnt = 0;

  /** Take an answer: what was asked at `asked` ms of the page met the server at `at` s of its clock. */
  learn(asked: number, at: number): void {
    const now = performance.now();
    const within = (now - asked) / 2;
    if (within > this.within && now - this.learnt < KEPT) return;
    [this.within, this.learnt] = [within, now];
    this.ahead = 1000 * at - (asked + now) / 2;
  }

  /** ms of the session's clock. */
  get now(): number {
    return performance.now() + this.ahead;
  }
}
