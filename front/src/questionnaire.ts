/** An instrument, one question at a time. */

import { Draft } from "./draft";
import { answerOf, drawn, faultOf, type Item } from "./questions";
import type { Pages } from "./sentences";
import { button, heading, Sheet, type Reply } from "./sheet";
import { fill, make } from "./words";

export interface Instrument { name: string; title: string; language: string; introduction: string; items: Item[] }

export class Questionnaire extends Sheet {
  private readonly draft: Draft;
  private readonly fault = make("p", { class: "fault", id: "fault", role: "alert" });

  constructor(
    private readonly instrument: Instrument, mark: string, private readonly words: Pages,
    private readonly reply: (said: Reply) => void, private readonly withPad: boolean,
  ) {
    super("asking", words.controls.read_on);
    this.element.lang = instrument.language;
    this.draft = new Draft(mark);
    this.element.addEventListener("keydown", (event) => {
      const here = event.target as HTMLElement;
      if (event.key === "Enter" && here.matches("input")) this.goOn();
    });
  }

  begin(): void {
    this.show();
  }

  private get item(): Item {
    return this.instrument.items[this.draft.step]!;
  }

  private show(): void {
    const { items, title, introduction } = this.instrument;
    const { survey, controls } = this.words;
    const at = this.draft.step;
    const progress = make("progress", { max: `${items.length}`, value: `${at}`, "aria-hidden": "true" });
    const step = make("p", { class: "step", role: "status" }, fill(survey.step, { number: at + 1, total: items.length }));
    const question = drawn(this.item, this.words, {
      value: this.draft.value(this.item.name),
      keep: (value) => this.draft.keep(this.item.name, value),
      withPad: this.withPad,
    });
    const back = button(controls.back, () => this.go(at - 1));
    const next = button(at === items.length - 1 ? survey.finish : controls.next, () => this.goOn(), "main");
    this.fault.textContent = "";
    const lead = introduction ? [make("p", { class: "hint" }, introduction)] : [];
    this.write([heading(title), progress, step, ...lead, question, this.fault], at ? [back, next] : [next]);
  }

  private go(step: number): void {
    this.draft.goTo(step);
    this.show();
  }

  private goOn(): void {
    const fault = faultOf(this.item, this.draft.value(this.item.name), this.words);
    this.fault.textContent = fault;
    if (fault) {
      this.fault.scrollIntoView({ block: "nearest" });
      this.element.querySelector<HTMLElement>("input:checked, input, textarea")?.focus();
    } else if (this.draft.step < this.instrument.items.length - 1) {
      this.go(this.draft.step + 1);
    } else {
      this.end();
    }
  }

  private end(): void {
    const given = this.instrument.items.map((item) => ({
      item: item.name, value: answerOf(item, this.draft.value(item.name)),
    }));
    this.draft.forget();
    this.reply({ given });
  }
}
