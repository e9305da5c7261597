/** The experimenter's monitor: the plan with rays and boundary, numbers, what happens, what comes. */

import { Bars } from "./bars";
import { EventLog } from "./event_log";
import { Health, measured } from "./health";
import { Live, momentOf, type Dialogue, type LiveSetting, type State } from "./live";
import { named, Progress, remaining } from "./progress";
import { layer, Scanned } from "./sensed";
import { NoWebGL, Stage, VIEWS, VIEW_NAMES, type View } from "./stage";
import { clock, make, NO_WEBGL } from "./words";

const CAPACITY = 40_000;
const IDLE = "No trial is running.";
const BETWEEN: { [page in Dialogue["page"]]: string } = {
  instruct: "The participant reads the instructions.",
  rest: "The participant rests.",
  countdown: "The next trial begins.",
  consent: "The participant reads the consent form.",
  survey: "The participant answers questions.",
  thank: "The participant is thanked.",
};

/** One number with its name. */
class Figure {
  readonly row: HTMLElement;
  private readonly value = make("dd", {}, "–");

  constructor(name: string) {
    this.row = make("div", {}, make("dt", {}, name), this.value);
  }

  set(text: string): void {
    if (this.value.textContent !== text) this.value.textContent = text;
  }
}

export function monitor(): void {
  const page = new MonitorPage();
  document.body.append(page.element);
  page.start();
}

class MonitorPage {
  readonly element: HTMLElement;
  private readonly canvas = make("canvas", { class: "scene", role: "img", "aria-label": "Plan of the world with robot, path, rays and boundary" });
  private readonly heading = make("p", { class: "where", role: "status" }, IDLE);
  private readonly message = make("p", { class: "message" });
  private readonly idle = make("p", { class: "idle" },
    "What is driven appears here by itself, once a session runs with its pages: ",
    make("code", {}, "omnistudy session run STUDY --live"));
  private readonly numbers = {
    time: new Figure("Time"), left: new Figure("Trial, left"), session: new Figure("Visit, left"),
    target: new Figure("Target"), collisions: new Figure("Collisions"), speed: new Figure("Speed"),
  };
  private readonly bars = new Bars();
  private readonly health = new Health();
  private readonly progress = new Progress();
  private readonly log = new EventLog();
  private readonly live: Live;
  private readonly scanned = new Scanned();
  private view: View = "plan";
  private stage: Stage | null = null;
  private setting: LiveSetting | null = null;
  private drawn = 0;

  constructor() {
    this.message.hidden = true;
    const numbers = make("dl", { class: "numbers" }, ...Object.values(this.numbers).map((one) => one.row));
    this.element = make("main", { class: "monitor" },
      make("header", {}, make("h1", {}, document.title), this.heading, make("a", { href: "/" }, "All trials")),
      make("div", { class: "seen" }, this.canvas, this.message, this.idle),
      make("section", { class: "story", tabindex: "0", "aria-label": "What happened and what comes next" },
        this.log.element, this.progress.element),
      make("aside", { class: "log", tabindex: "0", "aria-label": "Numbers and camera" },
        numbers, this.bars.element, this.health.element, this.cameras()));
    this.live = new Live((setting) => this.open(setting));
    Object.assign(window, { monitor: this });
  }

  start(): void {
    requestAnimationFrame(() => this.frame());
  }

  private open(setting: LiveSetting): void {
    this.setting = setting;
    this.progress.open(setting);
    this.stage?.close();
    try {
      this.stage = new Stage(this.canvas, setting, CAPACITY, false);
    } catch (fault) {
      if (!(fault instanceof NoWebGL)) throw fault;
      this.canvas.replaceWith(make("div", { class: "said" }, make("h2", {}, NO_WEBGL.title), NO_WEBGL.text));
      return;
    }
    this.stage.view = this.view;
    this.stage.onRobot(this.scanned.group);
    if (setting.boundary.length) this.stage.onRobot(layer(setting.boundary));
    void this.stage.prepare();
  }

  private where(running: boolean): string {
    const setting = this.setting;
    if (this.live.lost) return "The connection to the session is lost.";
    if (this.live.dialogue) return BETWEEN[this.live.dialogue.page];
    if (!running || !setting) return IDLE;
    return `Trial ${setting.trial} · ${setting.participant} · ${named(setting)} · ${setting.route} · `
      + `visit ${setting.visit}, ${setting.kind} ${setting.place} of ${setting.places}`;
  }

  private frame(): void {
    requestAnimationFrame(() => this.frame());
    const state = this.live.state;
    const known = state !== null && this.setting?.trial === state.trial;
    const where = this.where(known);
    if (this.heading.textContent !== where) this.heading.textContent = where;
    this.idle.hidden = state !== null || this.live.dialogue !== null;
    if (!state) this.rest();
    const pause = this.live.dialogue?.remaining ?? 0;
    if (!state) this.numbers.time.set(pause > 0 ? `pause, ${clock(pause)} left` : "–");
    if (!state || !known) return;
    const running = state.status === "running";
    const age = running ? Math.max(0, this.live.clock.now - 1000 * state.made) : 0;
    this.health.show([...state.health, ...measured(this.live.lag, age)]);
    if (this.drawn === state.made) return;
    this.drawn = state.made;
    const moment = momentOf(state, this.setting!);
    this.stage?.trail.add(moment.x, moment.y);
    this.scanned.show(state.rays);
    this.stage?.draw(moment, state.target);
    this.tell(state, this.setting!);
  }

  private tell(state: State, setting: LiveSetting): void {
    const { numbers } = this;
    const value = (name: string): number => state.values[name] ?? 0;
    const left = Math.max(0, setting.expected_s - state.t);
    const running = state.status === "running";
    numbers.time.set(running ? clock(state.t) : `${clock(state.t)}, ${state.status}`);
    numbers.left.set(running ? `${clock(left)} of ${clock(setting.expected_s)}` : "–");
    numbers.session.set(clock(remaining(setting, state)));
    numbers.target.set(state.target ?? "none");
    numbers.collisions.set(`${state.collisions}`);
    numbers.speed.set(`${Math.hypot(value("vx"), value("vy")).toFixed(2)} m/s`);
    this.bars.show(value);
    const lines = state.lines.join("\n");
    if (this.message.textContent !== lines) this.message.textContent = lines;
    this.message.hidden = lines === "";
    this.log.show(state.trial, state.events);
  }

  /** Show that nothing runs: old numbers would pass for new ones. */
  private rest(): void {
    if (this.drawn === 0) return;
    this.drawn = 0;
    for (const figure of Object.values(this.numbers)) figure.set("–");
    this.bars.show(null);
    this.health.show([]);
    this.progress.close();
    this.message.hidden = true;
    this.setting = null;
  }

  private cameras(): HTMLElement {
    const group = make("fieldset", { class: "choice" }, make("legend", {}, "Camera"));
    for (const view of VIEWS) {
      const radio = make("input", { type: "radio", name: "camera", value: view });
      radio.checked = view === this.view;
      radio.addEventListener("change", () => {
        this.view = view;
        if (this.stage) this.stage.view = view;
      });
      group.append(make("label", {}, radio, make("span", {}, VIEW_NAMES[view])));
    }
    return group;
  }
}
