/** Wrench and stick, axis by axis, as bars about their middle. */

import { FORCE_X, FORCE_Y, TORQUE_LEFT } from "./colours";
import { make } from "./words";

interface Axis { name: string; title: string; unit: string; most: number; colour: string }

const AXES: Axis[] = [
  { name: "fx", title: "Force forward", unit: "N", most: 13.5, colour: FORCE_X },
  { name: "fy", title: "Force left", unit: "N", most: 13.5, colour: FORCE_Y },
  { name: "tau", title: "Torque", unit: "N·m", most: 4.4, colour: TORQUE_LEFT },
  { name: "stick_x", title: "Stick forward", unit: "m", most: 0.1, colour: "var(--muted)" },
  { name: "stick_y", title: "Stick left", unit: "m", most: 0.1, colour: "var(--muted)" },
  { name: "stick_theta", title: "Stick twist", unit: "rad", most: 1.6, colour: "var(--muted)" },
];

export class Bars {
  readonly element: HTMLElement;
  private readonly rows = AXES.map((axis) => {
    const bar = make("span", { class: "bar", style: `background: ${axis.colour}` });
    const text = make("span", { class: "figure" }, "–");
    const row = make("li", {}, make("span", {}, axis.title), make("span", { class: "track" }, bar), text);
    return { axis, bar, text, row };
  });

  constructor() {
    this.element = make("div", {}, make("h2", {}, "Wrench and stick"),
      make("ul", { class: "bars" }, ...this.rows.map(({ row }) => row)));
  }

  /** Without values every axis rests. */
  show(value: ((channel: string) => number) | null): void {
    for (const { axis, bar, text } of this.rows) {
      const now = value ? value(axis.name) : 0;
      const part = Math.max(-1, Math.min(1, now / axis.most));
      bar.style.left = `${50 + Math.min(part, 0) * 50}%`;
      bar.style.width = `${Math.abs(part) * 50}%`;
      text.textContent = value ? `${now.toFixed(2)} ${axis.unit}` : "–";
    }
  }
}
