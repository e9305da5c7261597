/** Letters and digits to be written with one switch or with the stick, row by row. */

import type { Pages } from "./sentences";
import { button } from "./sheet";
import { make } from "./words";

const DIGITS = ["012", "345", "678", "9.-"];

export function pad(
  field: HTMLInputElement | HTMLTextAreaElement, words: Pages["controls"], digits: boolean,
): HTMLElement {
  const write = (change: (text: string) => string): void => {
    field.value = change(field.value);
    field.dispatchEvent(new Event("input"));
  };
  const rows = (digits ? DIGITS : words.letters).map((letters) => make(
    "div", { "data-row": "", tabindex: "-1" },
    ...[...letters].map((letter) => button(letter, () => write((text) => text + letter))),
  ));
  const space = digits ? [] : [button(words.space, () => write((text) => `${text} `))];
  const erase = button(words.delete, () => write((text) => text.slice(0, -1)));
  return make("div", { class: "pad", role: "group", "aria-label": words.pad }, ...rows, ...space, erase);
}
