/** What plays a replay: its controls, its keys, what happened. */

import { entrance } from "./immersive";
import type { Reel } from "./reel";
import { VIEWS, VIEW_NAMES, type View } from "./stage";
import { clock, make } from "./words";

const SPEEDS = [0.25, 0.5, 1, 2, 4, 8];

/** One time for all reels. */
export class Player {
  playing = false;
  t = 0;
  private speed = 1;
  private drawnAt = 0;
  private immersed = false;
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
    if (key === " " || key === "k") this.toggle();
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
    if (!this.playing || this.immersed) return;
    this.ease((now - this.drawnAt) / 1000);
    this.advance(now);
    if (this.playing) requestAnimationFrame((next) => this.tick(next));
  }

  /** Go on to where a running trial is now; a paused one is drawn again. */
  private advance(now: number): void {
    const gone = Math.max(0, (now - this.drawnAt) / 1000);
    this.drawnAt = now;
    this.seek(this.t + (this.playing ? gone * this.speed : 0));
    if (this.t >= this.end) this.pause();
  }

  private toggle(): void {
    if (this.playing) this.pause();
    else this.start();
  }

  /** Draw fewer pixels once thirty frames have each taken over a twentieth of a second. */
  private ease(gone: number): void {
    this.slow = gone > 0.05 ? this.slow + 1 : 0;
    if (this.slow === 30) for (const reel of this.reels) reel.stage.coarsen(0.6);
  }

  private build(): HTMLElement {
    this.play.addEventListener("click", () => this.toggle());
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
      for (const reel of this.reels) reel.scan(on);
    });
    const full = make("button", { type: "button" }, "Full screen");
    full.addEventListener("click", () => void document.documentElement.requestFullscreen());
    return make("div", { class: "controls" },
      make("div", { class: "row" }, this.play, this.scrub, this.time),
      make("div", { class: "row" }, this.cameras(), make("label", {}, "Speed ", speed),
        make("label", {}, arrows, " Force arrows"), make("label", {}, rays, " Rays"), full, this.headset()));
  }

  /** The way in with a headset, to the first of the trials. */
  private headset(): HTMLElement {
    return entrance({
      stage: this.reels[0]!.stage,
      frame: (now) => {
        this.immersed = true;
        this.advance(now);
      },
      pressed: () => this.toggle(),
      left: () => {
        this.immersed = false;
        if (this.playing) this.start();
      },
    });
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
