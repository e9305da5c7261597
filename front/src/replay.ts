/** Replay: stored trials, scrubbed and played, one or two in step. */

import { clock, make } from "./words";
import { collisionsAt, linesAt, Record, targetAt, type Film } from "./film";
import { Plots } from "./plots";
import { Rays } from "./rays";
import { Scanned } from "./sensed";
import { Stage, VIEWS, VIEW_NAMES, type View } from "./stage";

const SPEEDS = [0.25, 0.5, 1, 2, 4, 8];
const FINE = new URLSearchParams(location.hash.slice(1)).has("fine");
/** Asked for where a picture counts more than speed. */
const LOOK_ROUND = 1.2;
/** s over which the following camera evens out the robot's heading. */

/** One trial on the page. */
class Reel {
  readonly element: HTMLElement;
  readonly record: Record;
  readonly stage: Stage;
  readonly plots: Plots;
  private readonly message = make("p", { class: "message", role: "status" });
  private readonly count = make("output", { class: "collisions" });
  readonly scanned = new Scanned();
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
    this.scanned.group.visible = false;
    this.stage.onRobot(this.scanned.group);
    const [x, y] = [this.record.of("x"), this.record.of("y")];
    x.forEach((at, i) => this.stage.trail.add(at, y[i]!));
    const hits = film.events.filter(([, kind]) => kind === "collision");
    this.stage.mark(hits.map(([t]) => {
      const at = this.record.at(t);
      return [at.x, at.y];
    }));
    this.heading = evened(this.record, LOOK_ROUND);
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
    if (this.rays && this.scanned.group.visible) this.scanned.show(this.rays.hits(moment));
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

/** What plays: one time for all reels. */
class Player {
  playing = false;
  t = 0;
  private speed = 1;
  private drawnAt = 0;
  private slow = 0;
  private readonly play = make("button", { type: "button", class: "play" });
  private readonly scrub: HTMLInputElement;
  private readonly time = make("output", { class: "time" });
  private readonly views = new Map<View, HTMLInputElement>();
  private readonly events: [HTMLButtonElement, number][] = [];
  readonly controls: HTMLElement;

  constructor(private readonly reels: Reel[], private readonly end: number) {
    this.scrub = make("input", {
      type: "range", min: "0", max: String(end), step: "0.05", value: "0", "aria-label": "Time, s",
    });
    this.controls = this.build();
    this.pause();
  }

  seek(t: number): void {
    this.t = Math.min(Math.max(t, 0), this.end);
    this.scrub.value = String(this.t);
    this.scrub.setAttribute("aria-valuetext", clock(this.t));
    this.time.textContent = `${clock(this.t)} / ${clock(this.end)}`;
    for (const reel of this.reels) reel.show(Math.min(this.t, reel.record.end));
    for (const [button, at] of this.events) button.classList.toggle("past", at <= this.t);
  }

  look(view: View): void {
    for (const reel of this.reels) reel.stage.view = view;
    this.views.get(view)!.checked = true;
    this.seek(this.t);
  }

  pause(): void {
    this.playing = false;
    this.play.textContent = "Play";
  }

  start(): void {
    if (this.t >= this.end) this.seek(0);
    this.playing = true;
    this.play.textContent = "Pause";
    this.drawnAt = performance.now();
    requestAnimationFrame((now) => this.tick(now));
  }

  /** Answer a key; tells whether it meant anything. */
  key(key: string): boolean {
    const steps: { [key: string]: number } = { ArrowLeft: -1, ArrowRight: 1, ",": -0.05, ".": 0.05 };
    if (key === " " || key === "k") (this.playing ? this.pause() : this.start());
    else if (key in steps) this.seek(this.t + steps[key]!);
    else if (key === "Home") this.seek(0);
    else if (key === "End") this.seek(this.end);
    else if (key === "[" || key === "]") this.event(key === "]" ? 1 : -1);
    else if (["1", "2", "3"].includes(key)) this.look(VIEWS[Number(key) - 1]!);
    else return false;
    return true;
  }

  private event(towards: 1 | -1): void {
    const times = this.events.map(([, at]) => at).sort((a, b) => towards * (a - b));
    const next = times.find((at) => towards * (at - this.t) > 0.01);
    if (next !== undefined) this.seek(next);
  }

  private tick(now: number): void {
    if (!this.playing) return;
    const gone = (now - this.drawnAt) / 1000;
    this.drawnAt = now;
    this.ease(gone);
    this.seek(this.t + gone * this.speed);
    if (this.t >= this.end) this.pause();
    else requestAnimationFrame((next) => this.tick(next));
  }

  /** Draw fewer pixels once thirty frames have each taken over a twentieth of a second. */
  private ease(gone: number): void {
    this.slow = gone > 0.05 ? this.slow + 1 : 0;
    if (this.slow === 30) for (const reel of this.reels) reel.stage.coarsen(0.6);
  }

  private build(): HTMLElement {
    this.play.addEventListener("click", () => (this.playing ? this.pause() : this.start()));
    this.scrub.addEventListener("input", () => this.seek(Number(this.scrub.value)));
    for (const { plots } of this.reels) {
      const go = (event: PointerEvent): void => {
        if (event.buttons) this.seek(plots.timeAt(event.clientX));
      };
      plots.canvas.addEventListener("pointerdown", go);
      plots.canvas.addEventListener("pointermove", go);
    }
    const speed = make("select", { "aria-label": "Speed" },
      ...SPEEDS.map((one) => make("option", { value: String(one) }, `${one}×`)));
    speed.value = "1";
    speed.addEventListener("change", () => { this.speed = Number(speed.value); });
    const arrows = this.option(true, (on) => {
      for (const { stage } of this.reels) stage.forces.group.visible = on;
    });
    const rays = this.option(false, (on) => {
      for (const { scanned } of this.reels) scanned.group.visible = on;
    });
    const full = make("button", { type: "button" }, "Full screen");
    full.addEventListener("click", () => void document.documentElement.requestFullscreen());
    return make("div", { class: "controls" },
      make("div", { class: "row" }, this.play, this.scrub, this.time),
      make("div", { class: "row" }, this.cameras(), make("label", {}, "Speed ", speed),
        make("label", {}, arrows, " Force arrows"), make("label", {}, rays, " Rays"), full));
  }

  private option(on: boolean, choose: (on: boolean) => void): HTMLInputElement {
    const box = make("input", { type: "checkbox" });
    box.checked = on;
    box.addEventListener("change", () => {
      choose(box.checked);
      this.seek(this.t);
    });
    return box;
  }

  private cameras(): HTMLElement {
    const group = make("fieldset", { class: "choice" }, make("legend", {}, "Camera"));
    for (const view of VIEWS) {
      const radio = make("input", { type: "radio", name: "camera", value: view });
      radio.addEventListener("change", () => this.look(view));
      this.views.set(view, radio);
      group.append(make("label", {}, radio, make("span", {}, VIEW_NAMES[view])));
    }
    return group;
  }

  /** What happened, as buttons that lead there. */
  log(): HTMLElement {
    const lists = this.reels.map(({ film }) => {
      const list = make("ol", { class: "events" });
      for (const [t, kind, detail] of film.events) {
        if (kind.startsWith("message")) continue;
        const button = make("button", { type: "button" },
          make("span", { class: "time" }, clock(t)), ` ${kind.replaceAll("_", " ")} `,
          make("span", { class: "detail" }, detail));
        button.addEventListener("click", () => this.seek(t));
        this.events.push([button, t]);
        list.append(make("li", {}, button));
      }
      return make("div", {}, make("h3", {}, `What happened in trial ${film.trial}`), list);
    });
    return make("aside", { class: "log" }, ...lists,
      make("p", { class: "keys" },
        "Keys: space plays, ← → go a second, , . a sample, [ ] to events, 1 2 3 choose the camera."));
  }
}

export function replay(films: Film[]): void {
  const end = Math.max(...films.map((film) => film.end));
  const reels = films.map((film) => new Reel(film, end));
  const player = new Player(reels, end);
  const main = make("main", { class: reels.length > 1 ? "replay two" : "replay" },
    make("h1", {}, document.title),
    make("div", { class: "reels" }, ...reels.map((reel) => reel.element)),
    player.controls, player.log());
  document.body.append(main);
  document.addEventListener("keydown", (event) => {
    const inside = event.target as HTMLElement;
    const typed = inside.matches("select, input[type=radio]") || (inside.matches("button, input") && event.key === " ");
    if (!typed && !event.ctrlKey && !event.metaKey && !event.altKey && player.key(event.key)) event.preventDefault();
  });
  const wish = new URLSearchParams(location.hash.slice(1));
  main.classList.toggle("bare", wish.has("bare"));
  player.look(VIEWS.find((view) => view === wish.get("camera")) ?? "follow");
  player.seek(Number(wish.get("t")) || 0);
  void Promise.all(reels.map((reel) => reel.stage.prepare())).then(() => {
    Object.assign(window, { replay: { seek: (t: number) => player.seek(t), end, player } });
  });
}
