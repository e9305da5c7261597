/** A sheet of paper over the participant's screen: a heading, a body, and buttons below. */

import type { Dialogue } from "./live";
import { make } from "./words";

/** What is said back to the session, without the mark of the page that asked. */
export interface Reply { agreed?: boolean; ticked?: string[]; given?: { item: string; value: string | number | null }[] }

export abstract class Sheet {
  readonly element: HTMLElement;
  readonly body = make("div", { class: "body", role: "region" });
  private readonly foot = make("div", { class: "foot" });
  private readonly more: HTMLButtonElement;

  constructor(kind: string, readOn: string) {
    this.more = button(readOn, () => this.body.scrollBy({ top: 0.8 * this.body.clientHeight }), "more");
    this.element = make("section", { class: `sheet ${kind}` }, this.body, this.foot);
    this.body.addEventListener("scroll", () => this.offerMore());
    new ResizeObserver(() => this.offerMore()).observe(this.body);
  }

  /** Called once it lies on the screen. */
  abstract begin(): void;

  /** Called with every word of the session while it lies there. */
  update(_dialogue: Dialogue): void {}

  /** Write something else on it; the first thing that can be used gets the focus. */
  protected write(parts: Node[], buttons: HTMLButtonElement[]): void {
    this.body.replaceChildren(...parts);
    this.foot.replaceChildren(this.more, ...buttons);
    this.body.setAttribute("aria-label", this.body.querySelector("h1")?.textContent ?? "");
    this.body.scrollTop = 0;
    this.offerMore();
    const first = this.element.querySelector<HTMLElement>("input:checked, input, textarea, [data-first]");
    (first ?? buttons[buttons.length - 1])?.focus();
  }

  private offerMore(): void {
    const { scrollTop, clientHeight, scrollHeight } = this.body;
    const longer = scrollHeight > clientHeight + 2;
    this.more.hidden = !longer || scrollTop + clientHeight > scrollHeight - 2;
    if (longer) this.body.tabIndex = 0;
    else this.body.removeAttribute("tabindex");
  }
}

export function button(text: string, pressed: () => void, kind = ""): HTMLButtonElement {
  const made = make("button", { type: "button", class: kind }, text);
  made.addEventListener("click", pressed);
  return made;
}

export function heading(text: string): HTMLElement {
  return make("h1", {}, text);
}
