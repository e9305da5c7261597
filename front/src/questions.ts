/** One question of an instrument, by what an answer to it can be. */

import { pad } from "./pad";
import type { Pages } from "./sentences";
import { fill, make } from "./words";

interface Asked { name: string; question: string; required: boolean }
export type Item = Asked & (
  | { kind: "likert"; scale: { lowest: number; highest: number; anchors: { value: number; label: string }[] } }
  | { kind: "choice"; options: { name: string; text: string }[] }
  | { kind: "number"; unit: string; whole: boolean; lowest: number | null; highest: number | null }
  | { kind: "text" }
);

const LONGEST = 2000;
const FAULT = "fault";
/** Element in which the page says what is wrong with an answer. */

export interface Kept { value: string; keep: (value: string) => void; withPad: boolean }

/** Draw a question with the answer that it has so far. */
export function drawn(item: Item, words: Pages, kept: Kept): HTMLElement {
  const legend = make("legend", {}, item.question);
  const optional = item.required ? [] : [make("p", { class: "hint" }, words.survey.optional)];
  if (item.kind === "likert" || item.kind === "choice") {
    const tiles = optionsOf(item).map(([value, ...text]) => tile(item.name, value, text, kept));
    if (!item.required) tiles.push(tile(item.name, "", [words.survey.no_answer], kept));
    return make("fieldset", { class: `asks_${item.kind}`, "aria-describedby": FAULT }, legend, ...optional, make("div", { class: "tiles" }, ...tiles));
  }
  const field = fieldOf(item, kept);
  const unit = item.kind === "number" && item.unit ? [make("span", { class: "unit" }, item.unit)] : [];
  const letters = kept.withPad ? [pad(field, words.controls, item.kind === "number")] : [];
  return make("fieldset", { class: item.kind }, legend, ...optional, make("div", { class: "field" }, field, ...unit), ...letters);
}

/** Say what is wrong with an answer; "" when nothing is. */
export function faultOf(item: Item, value: string, { survey }: Pages): string {
  if (value.trim() === "") return item.required ? survey.answer_needed : "";
  if (item.kind !== "number") return "";
  const number = numberIn(value);
  if (!Number.isFinite(number)) return survey.number_needed;
  if (item.whole && !Number.isInteger(number)) return survey.whole_number_needed;
  if (item.lowest !== null && number < item.lowest) return fill(survey.at_least, { lowest: item.lowest });
  if (item.highest !== null && number > item.highest) return fill(survey.at_most, { highest: item.highest });
  return "";
}

/** Turn what was written into what is stored. */
export function answerOf(item: Item, value: string): string | number | null {
  if (value.trim() === "") return null;
  if (item.kind === "number" || item.kind === "likert") return numberIn(value);
  return value;
}

function numberIn(value: string): number {
  return Number(value.trim().replace(",", "."));
}

function optionsOf(item: Item & { kind: "likert" | "choice" }): [value: string, ...text: string[]][] {
  if (item.kind === "choice") return item.options.map(({ name, text }) => [name, text]);
  const { lowest, highest, anchors } = item.scale;
  return Array.from({ length: highest - lowest + 1 }, (_, i) => {
    const value = lowest + i;
    const anchor = anchors.find((one) => one.value === value);
    return [`${value}`, `${value}`, ...(anchor ? [anchor.label] : [])];
  });
}

function tile(name: string, value: string, text: string[], { value: chosen, keep }: Kept): HTMLElement {
  const box = make("input", { type: "radio", name, value });
  box.checked = value !== "" && value === chosen;
  box.addEventListener("change", () => keep(value));
  return make("label", { class: "tile" }, box, ...text.map((one) => make("span", {}, one)));
}

function fieldOf(item: Item, { value, keep }: Kept): HTMLInputElement | HTMLTextAreaElement {
  const named = { "aria-label": item.question, "aria-describedby": FAULT, maxlength: `${LONGEST}`, autocomplete: "off" };
  const field = item.kind === "number"
    ? make("input", { type: "text", inputmode: "decimal", ...named })
    : make("textarea", { rows: "4", ...named });
  field.value = value;
  field.addEventListener("input", () => keep(field.value));
  return field;
}
