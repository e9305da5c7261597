/** A consent form: its text part by part, what is asked to be ticked, and yes or no. */

import type { Pages } from "./sentences";
import { button, heading, Sheet, type Reply } from "./sheet";
import { Draft } from "./draft";
import { fill, make } from "./words";

export interface ConsentForm {
  title: string;
  version: string;
  language: string;
  sections: { heading: string; paragraphs: string[] }[];
  asked: { name: string; text: string; required: boolean }[];
}

export class Consent extends Sheet {
  private readonly draft: Draft;
  private readonly fault = make("p", { class: "fault", role: "alert" });

  constructor(
    private readonly form: ConsentForm, mark: string,
    private readonly words: Pages, private readonly reply: (said: Reply) => void,
  ) {
    super("reading consent", words.controls.read_on);
    this.element.lang = form.language;
    this.draft = new Draft(mark);
  }

  begin(): void {
    this.show();
  }

  /** Show the part that is being read; what is asked stands on the last. */
  private show(): void {
    const { sections, title } = this.form;
    const at = Math.min(this.draft.step, sections.length - 1);
    const section = sections[at]!;
    const last = at === sections.length - 1;
    const step = make("p", { class: "step" }, title, " · ", fill(this.words.consent.step, { number: at + 1, total: sections.length }));
    const text = section.paragraphs.map((paragraph) => make("p", {}, paragraph));
    const back = button(this.words.controls.back, () => this.go(at - 1));
    const buttons = last
      ? [button(this.words.consent.decline, () => this.end(false)), button(this.words.consent.agree, () => this.end(true), "main")]
      : [button(this.words.controls.next, () => this.go(at + 1), "main")];
    this.fault.textContent = "";
    this.write(
      [step, heading(section.heading), ...text, ...(last && this.form.asked.length ? [this.asked(), this.fault] : [])],
      at ? [back, ...buttons] : buttons,
    );
  }

  private asked(): HTMLElement {
    const { consent } = this.words;
    const ticks = this.form.asked.map(({ name, text, required }) => {
      const box = make("input", { type: "checkbox" });
      box.checked = this.draft.value(name) === "yes";
      box.addEventListener("change", () => this.draft.keep(name, box.checked ? "yes" : ""));
      const needed = required ? [make("em", {}, ` (${consent.needed})`)] : [];
      return make("label", { class: "tile tick" }, box, make("span", {}, text, ...needed));
    });
    return make("fieldset", { class: "ticks" }, make("legend", {}, consent.asked), ...ticks);
  }

  private go(step: number): void {
    this.draft.goTo(step);
    this.show();
  }

  private end(agreed: boolean): void {
    const ticked = this.form.asked.map(({ name }) => name).filter((name) => this.draft.value(name) === "yes");
    if (agreed && this.form.asked.some(({ name, required }) => required && !ticked.includes(name))) {
      this.fault.textContent = this.words.consent.ticks_needed;
      this.fault.scrollIntoView({ block: "nearest" });
      return;
    }
    this.draft.forget();
    this.reply({ agreed, ticked });
  }
}
