/** Quantities over time on one canvas, under a cursor. */

import { CLEARANCE, COLLISION, FORCE_X, FORCE_Y, TORQUE_LEFT } from "./colours";
import type { Film, Record } from "./film";

interface Panel { title: string; lines: [series: string, name: string, colour: string][]; zero: boolean }

const PANELS: Panel[] = [
  { title: "force at the hand, N", lines: [["fx", "forward", FORCE_X], ["fy", "left", FORCE_Y]], zero: false },
  { title: "torque, N·m", lines: [["tau", "counter-clockwise", TORQUE_LEFT]], zero: false },
  { title: "clearance, m", lines: [["clearance", "to the nearest wall", CLEARANCE]], zero: true },
];
const BY_PROCESSOR: CanvasRenderingContext2DSettings = { willReadFrequently: true };
/** A few lines are no work for a graphics card, which has the world to make ready meanwhile. */
const LEFT = 46;
const RIGHT = 10;
const HEAD = 17;
const FOOT = 18;

export class Plots {
  private readonly drawn = document.createElement("canvas");
  private cursor = 0;
  private wide = 0;

  constructor(
    readonly canvas: HTMLCanvasElement, private readonly film: Film,
    private readonly record: Record, private readonly end: number,
  ) {
    new ResizeObserver(() => this.redraw()).observe(canvas);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.redraw());
  }

  /** The time under a place on the screen. */
  timeAt(clientX: number): number {
    const box = this.canvas.getBoundingClientRect();
    const part = (clientX - box.left - LEFT) / (box.width - LEFT - RIGHT);
    return Math.min(Math.max(part, 0), 1) * this.end;
  }

  show(t: number): void {
    this.cursor = t;
    const pen = this.canvas.getContext("2d", BY_PROCESSOR)!;
    pen.setTransform(1, 0, 0, 1, 0, 0);
    pen.clearRect(0, 0, this.canvas.width, this.canvas.height);
    if (this.drawn.width) pen.drawImage(this.drawn, 0, 0);
    pen.scale(devicePixelRatio, devicePixelRatio);
    const x = this.x(t);
    pen.strokeStyle = this.ink("--ink");
    pen.lineWidth = 1.25;
    pen.beginPath();
    pen.moveTo(x, 0);
    pen.lineTo(x, this.canvas.clientHeight - FOOT + 4);
    pen.stroke();
  }

  private x(t: number): number {
    return LEFT + (t / this.end) * (this.wide - LEFT - RIGHT);
  }

  private ink(name: string): string {
    return getComputedStyle(this.canvas).getPropertyValue(name);
  }

  private redraw(): void {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (!width || !height) return;
    this.wide = width; // once: thousands of samples ask for it
    for (const one of [this.canvas, this.drawn]) {
      one.width = width * devicePixelRatio;
      one.height = height * devicePixelRatio;
    }
    const pen = this.drawn.getContext("2d", BY_PROCESSOR)!;
    pen.scale(devicePixelRatio, devicePixelRatio);
    pen.font = `12px ${getComputedStyle(this.canvas).fontFamily}`;
    const tall = (height - FOOT) / PANELS.length;
    PANELS.forEach((panel, i) => this.panel(pen, panel, i * tall, tall));
    this.times(pen, height);
    this.show(this.cursor);
  }

  private panel(pen: CanvasRenderingContext2D, panel: Panel, top: number, tall: number): void {
    const [low, high] = this.range(panel);
    const [upper, lower] = [top + HEAD, top + tall - 5];
    const y = (value: number): number => lower - ((value - low) / (high - low)) * (lower - upper);
    pen.textBaseline = "middle";
    pen.fillStyle = this.ink("--muted");
    pen.textAlign = "right";
    pen.strokeStyle = this.ink("--line");
    pen.lineWidth = 1;
    for (const tick of panel.zero ? [0, high] : [low, 0, high]) {
      pen.fillText(`${+tick.toPrecision(2)}`, LEFT - 6, y(tick));
      pen.beginPath();
      pen.moveTo(LEFT, y(tick));
      pen.lineTo(this.canvas.clientWidth - RIGHT, y(tick));
      pen.stroke();
    }
    this.ticks(pen, upper, lower);
    let x = LEFT;
    pen.textAlign = "left";
    pen.fillStyle = this.ink("--muted");
    pen.fillText(panel.title, x, top + HEAD / 2);
    x += pen.measureText(panel.title).width + 16;
    for (const [series, name, colour] of panel.lines) {
      pen.fillStyle = colour;
      pen.fillRect(x, top + HEAD / 2 - 1.5, 14, 3);
      pen.fillStyle = this.ink("--muted");
      pen.fillText(name, x + 19, top + HEAD / 2);
      x += pen.measureText(name).width + 34;
      this.line(pen, this.record.of(series), y, colour);
    }
  }

  /** A line through the lowest and highest value of each pixel. */
  private line(
    pen: CanvasRenderingContext2D, values: Float32Array, y: (value: number) => number, colour: string,
  ): void {
    pen.strokeStyle = colour;
    pen.lineWidth = 1.4;
    pen.lineJoin = "round";
    pen.beginPath();
    let [column, low, high] = [-1, 0, 0];
    const flush = (): void => {
      if (column < 0) return;
      pen.lineTo(column, y(low));
      if (high !== low) pen.lineTo(column, y(high));
    };
    values.forEach((value, i) => {
      if (!Number.isFinite(value)) return;
      const at = Math.round(this.x(this.record.t[i]!));
      if (at === column) {
        [low, high] = [Math.min(low, value), Math.max(high, value)];
        return;
      }
      flush();
      [column, low, high] = [at, value, value];
    });
    flush();
    pen.stroke();
  }

  /** Collisions as ticks. */
  private ticks(pen: CanvasRenderingContext2D, upper: number, lower: number): void {
    pen.fillStyle = COLLISION;
    for (const [t, kind] of this.film.events) {
      if (kind !== "collision") continue;
      pen.globalAlpha = 0.35;
      pen.fillRect(this.x(t) - 0.75, upper, 1.5, lower - upper);
      pen.globalAlpha = 1;
    }
  }

  private times(pen: CanvasRenderingContext2D, height: number): void {
    const step = [1, 2, 5, 10, 20, 30, 60, 120, 300].find((one) => this.end / one < 11) ?? 600;
    pen.fillStyle = this.ink("--muted");
    pen.textAlign = "center";
    for (let t = 0; t <= this.end; t += step) {
      const label = t + step > this.end ? `${t} s` : `${t}`;
      pen.fillText(label, this.x(t), height - FOOT / 2 + 2);
    }
  }

  private range(panel: Panel): [number, number] {
    let most = 0;
    for (const [series] of panel.lines) {
      for (const value of this.record.of(series)) {
        if (Number.isFinite(value)) most = Math.max(most, Math.abs(value));
      }
    }
    most = rounded(panel.zero ? Math.min(most, 1) : most) || 1;
    return [panel.zero ? 0 : -most, most];
  }
}

/** The next number above of those that read well. */
function rounded(value: number): number {
  if (value <= 0) return 0;
  const decade = 10 ** Math.floor(Math.log10(value));
  return decade * ([1, 1.5, 2, 3, 5, 7.5, 10].find((step) => step * decade >= value) ?? 10);
}
