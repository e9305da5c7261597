/** One trial of a replay: its world, its words, its plots. */

import { make } from "./words";
import { collisionsAt, linesAt, Record, targetAt, type Film } from "./film";
import { Plots } from "./plots";
import { Rays } from "./rays";
import { Scanned } from "./sensed";
import { Stage } from "./stage";

const FINE = new URLSearchParams(location.hash.slice(1)).has("fine");
/** Asked for where a picture counts more than speed. */
const LOOK_ROUND = 1.2;
/** s over which the following camera evens out the robot's heading. */

/** One trial on the page. */
export class Reel {
  readonly element: HTMLElement;
  readonly record: Record;
  readonly stage: Stage;
  readonly plots: Plots;
  private readonly message = make("p", { class: "message", role: "status" });
  private readonly count = make("output", { class: "collisions" });
  private scanned: Scanned | null = null;
  private readonly rays: Rays | null;
  private readonly heading: Float32Array;

  constructor(readonly film: Film, end: number) {
    this.record = new Record(film);
    const scene = make("canvas", { class: "scene", "aria-label": described(film), role: "img" });
    const plot = make("canvas", {
      class: "plots", role: "img",
      "aria-label": "Force, torque and clearance over time; collisions are marked",
    });
    const time = film.duration_s === null ? film.status : `${film.duration_s.toFixed(1)} s`;
    this.element = make("section", { class: "reel" },
      make("header", {},
        make("h2", {}, `Trial ${film.trial}`),
        make("p", {}, [film.participant, film.masked ? `label ${film.condition}` : film.condition, film.route, time].join(" · ")),
        ...(film.virtual ? [make("p", { class: "mark" }, "virtual participant")] : [])),
      make("div", { class: "seen" }, scene, this.message, this.count),
      plot);
    this.stage = new Stage(scene, film, this.record.t.length, FINE);
    this.plots = new Plots(plot, film, this.record, end);
    this.rays = film.sight && new Rays(film.sight, film.scene);
    const [x, y] = [this.record.of("x"), this.record.of("y")];
    x.forEach((at, i) => this.stage.trail.add(at, y[i]!));
    const hits = film.events.filter(([, kind]) => kind === "collision");
    this.stage.mark(hits.map(([t]) => {
      const at = this.record.at(t);
      return [at.x, at.y];
    }));
    this.heading = evened(this.record, LOOK_ROUND);
  }

  /** Draw the sensor's rays, or no longer; made only when wanted, as pages open sooner without. */
  scan(on: boolean): void {
    if (on && !this.scanned) {
      this.scanned = new Scanned();
      this.stage.onRobot(this.scanned.group);
    }
    if (this.scanned) this.scanned.group.visible = on;
  }

  show(t: number): void {
    const moment = this.record.at(t);
    const place = this.record.count(t);
    this.stage.trail.reveal(place - 1);
    const lines = linesAt(this.film, t);
    const text = lines.join("\n");
    if (this.message.innerText !== text) this.message.innerText = text;
    this.message.hidden = text === "";
    const count = collisionsAt(this.film, t);
    this.count.textContent = count === 1 ? "1 collision" : `${count} collisions`;
    const at = Math.min(place, this.heading.length - 1);
    const before = Math.max(at - 1, 0);
    const span = this.record.t[at]! - this.record.t[before]! || 1;
    const part = Math.min(Math.max((t - this.record.t[before]!) / span, 0), 1);
    const heading = this.heading[before]! * (1 - part) + this.heading[at]! * part;
    if (this.rays && this.scanned?.group.visible) this.scanned.show(this.rays.hits(moment));
    this.stage.draw(moment, targetAt(this.film, t), heading);
    this.plots.show(t);
  }
}

function described(film: Film): string {
  return `The robot in its world during trial ${film.trial}`;
}

/** The heading, averaged over a window, so that the camera does not shake. */
function evened(record: Record, window: number): Float32Array {
  const theta = record.of("theta");
  const step = record.end / Math.max(record.t.length - 1, 1) || 1;
  const reach = Math.round(window / 2 / step);
  const sums = new Float64Array(theta.length + 1);
  theta.forEach((value, i) => { sums[i + 1] = sums[i]! + value; });
  return theta.map((_, i) => {
    const [from, to] = [Math.max(0, i - reach), Math.min(theta.length, i + reach + 1)];
    return (sums[to]! - sums[from]!) / (to - from);
  });
}
