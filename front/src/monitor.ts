/** The experimenter's monitor: the plan with rays and boundary, numbers, what happens, what comes. */

import {
  BufferGeometry, Float32BufferAttribute, Group, LineBasicMaterial, LineLoop, LineSegments, Points,
  PointsMaterial,
} from "three";
import { FORCE_X, FORCE_Y, TORQUE_LEFT } from "./colours";
import { Live, momentOf, type LiveSetting, type State } from "./live";
import { Stage, VIEWS, type View } from "./stage";
import { clock, make } from "./words";

const RAY = "#7fb8e6";
const RAY_AHEAD = "#1f9d55";
const AHEAD = 0.6;
/** rad to either side that the thesis draws as the front sector (rays 52 to 76 of 128). */
const CAPACITY = 40_000;
const BARS: [name: string, title: string, unit: string, most: number, colour: string][] = [
  ["fx", "Force forward", "N", 13.5, FORCE_X],
  ["fy", "Force left", "N", 13.5, FORCE_Y],
  ["tau", "Torque", "N·m", 4.4, TORQUE_LEFT],
  ["stick_x", "Stick forward", "m", 0.1, "var(--muted)"],
  ["stick_y", "Stick left", "m", 0.1, "var(--muted)"],
  ["stick_theta", "Stick twist", "rad", 1.6, "var(--muted)"],
];
const VIEW_NAMES: { [view in View]: string } = { follow: "Follow", plan: "Plan", first: "First person" };

/** The scan as the thesis draws it, and the line inside which walls push. */
class Sensed {
  readonly group = new Group();
  private readonly rays = new LineSegments(new BufferGeometry(), new LineBasicMaterial({ vertexColors: true }));
  private readonly ends = new Points(new BufferGeometry(), new PointsMaterial({ color: "#b0102a", size: 5, sizeAttenuation: false }));

  constructor(boundary: [number, number][]) {
    const line = new BufferGeometry();
    line.setAttribute("position", places(boundary));
    this.group.add(new LineLoop(line, new LineBasicMaterial({ color: "#7a4b00" })), this.rays, this.ends);
    this.group.position.z = 0.3;
    for (const one of [this.rays, this.ends]) one.frustumCulled = false;
  }

  show(hits: [number, number][]): void {
    const segments = hits.flatMap((hit): [number, number][] => [[0, 0], hit]);
    const tints = hits.flatMap(([x, y]) => {
      const tint = Math.abs(Math.atan2(y, x)) < AHEAD ? RAY_AHEAD : RAY;
      const parts = [1, 3, 5].map((at) => parseInt(tint.slice(at, at + 2), 16) / 255);
      return [...parts, ...parts];
    });
    this.rays.geometry.setAttribute("position", places(segments));
    this.rays.geometry.setAttribute("color", new Float32BufferAttribute(tints, 3));
    this.ends.geometry.setAttribute("position", places(hits));
  }
}

function places(points: [number, number][]): Float32BufferAttribute {
  return new Float32BufferAttribute(points.flatMap(([x, y]) => [x, y, 0]), 3);
}

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
  private readonly heading = make("p", { class: "where", role: "status" }, "No trial is running.");
  private readonly message = make("p", { class: "message" });
  private readonly log = make("ol", { class: "events" });
  private readonly numbers = {
    time: new Figure("Time"), left: new Figure("Expected to last"), target: new Figure("Target"),
    collisions: new Figure("Collisions"), speed: new Figure("Speed"), late: new Figure("Late steps"),
    lag: new Figure("Screen lag"), frames: new Figure("Frames shown"), next: new Figure("Next label"),
  };
  private readonly bars = new Map<string, [HTMLElement, HTMLElement]>();
  private readonly live: Live;
  private view: View = "plan";
  private stage: Stage | null = null;
  private sensed: Sensed | null = null;
  private setting: LiveSetting | null = null;
  private drawn = 0;
  private logged = "";

  constructor() {
    this.message.hidden = true;
    const numbers = make("dl", { class: "numbers" }, ...Object.values(this.numbers).map((one) => one.row));
    this.element = make("main", { class: "monitor" },
      make("header", {}, make("h1", {}, document.title), this.heading),
      make("div", { class: "seen" }, this.canvas, this.message),
      make("aside", { class: "log", tabindex: "0", "aria-label": "Numbers and events" },
        numbers, this.wrench(), this.cameras(),
        make("div", {}, make("h2", {}, "What happened"), this.log)));
    this.live = new Live((setting) => this.open(setting));
    Object.assign(window, { monitor: this });
  }

  start(): void {
    requestAnimationFrame(() => this.frame());
  }

  private open(setting: LiveSetting): void {
    this.stage?.close();
    this.stage = new Stage(this.canvas, setting, CAPACITY, false);
    this.stage.view = this.view;
    this.sensed = new Sensed(setting.boundary);
    this.stage.onRobot(this.sensed.group);
    this.setting = setting;
    void this.stage.prepare();
  }

  private where(): string {
    const setting = this.setting;
    if (!this.live.state || !setting) return "No trial is running.";
    return `Trial ${setting.trial} · ${setting.participant} · label ${setting.label} · `
      + `${setting.route} · ${setting.place} of ${setting.places}`;
  }

  private frame(): void {
    requestAnimationFrame(() => this.frame());
    const state = this.live.state;
    const where = this.live.lost ? "The connection to the session is lost." : this.where();
    if (this.heading.textContent !== where) this.heading.textContent = where;
    if (!state || this.setting?.trial !== state.trial || this.drawn === state.made) return;
    this.drawn = state.made;
    const moment = momentOf(state);
    this.stage?.trail.add(moment.x, moment.y);
    this.sensed?.show(state.hits);
    this.stage?.draw(moment, state.target);
    this.tell(state, this.setting);
  }

  private tell(state: State, setting: LiveSetting): void {
    const { numbers, live } = this;
    const value = (name: string): number => state.values[name] ?? 0;
    numbers.time.set(state.status === "running" ? clock(state.t) : `${clock(state.t)}, ${state.status}`);
    numbers.left.set(`${clock(setting.expected_s)} (${clock(Math.max(0, setting.expected_s - state.t))} left)`);
    numbers.target.set(state.target ?? "none");
    numbers.collisions.set(`${state.collisions}`);
    numbers.speed.set(`${Math.hypot(value("vx"), value("vy")).toFixed(2)} m/s`);
    numbers.late.set(`${state.late}`);
    numbers.lag.set(live.lag ? `${live.lag.median_ms.toFixed(0)} ms, p99 ${live.lag.p99_ms.toFixed(0)} ms` : "no screen");
    numbers.frames.set(`${live.lag?.frames ?? 0}`);
    numbers.next.set(setting.following || "none");
    for (const [name, , unit, most] of BARS) {
      const [bar, text] = this.bars.get(name)!;
      const part = Math.max(-1, Math.min(1, value(name) / most));
      bar.style.left = `${50 + Math.min(part, 0) * 50}%`;
      bar.style.width = `${Math.abs(part) * 50}%`;
      text.textContent = `${value(name).toFixed(2)} ${unit}`;
    }
    const lines = state.lines.join("\n");
    if (this.message.textContent !== lines) this.message.textContent = lines;
    this.message.hidden = lines === "";
    this.list(state);
  }

  private list(state: State): void {
    const known = JSON.stringify(state.events);
    if (known === this.logged) return;
    this.logged = known;
    this.log.replaceChildren(...[...state.events].reverse().map(([t, kind, detail]) => make("li", {},
      make("span", { class: "time" }, clock(t)), ` ${kind.replaceAll("_", " ")} `,
      make("span", { class: "detail" }, detail))));
  }

  private wrench(): HTMLElement {
    const rows = BARS.map(([name, title, , , colour]) => {
      const bar = make("span", { class: "bar", style: `background: ${colour}` });
      const text = make("span", { class: "figure" }, "–");
      this.bars.set(name, [bar, text]);
      return make("li", {}, make("span", {}, title), make("span", { class: "track" }, bar), text);
    });
    return make("div", {}, make("h2", {}, "Wrench and stick"), make("ul", { class: "bars" }, ...rows));
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
