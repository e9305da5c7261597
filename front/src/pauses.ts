/** What is read before, between and after the trials. */

import { fillScreen } from "./awake";
import type { Dialogue } from "./live";
import type { Pages } from "./sentences";
import { button, heading, Sheet, type Reply } from "./sheet";
import { fill, make } from "./words";

type Say = (said: Reply) => void;

export class Instructions extends Sheet {
  constructor(private readonly words: Pages, private readonly reply: Say) {
    super("reading", words.controls.read_on);
  }

  begin(): void {
    const { welcome, instructions, ready } = this.words.pauses;
    const begin = button(ready, () => {
      fillScreen();
      this.reply({});
    }, "main");
    this.write([heading(welcome), ...paragraphs(instructions)], [begin]);
  }
}

export class Rest extends Sheet {
  private readonly left = make("p", { role: "timer" });

  constructor(private readonly words: Pages, private readonly lines: string[], private readonly reply: Say) {
    super("reading", words.controls.read_on);
  }

  begin(): void {
    const { rest, ready } = this.words.pauses;
    this.write([...result(this.lines), heading(rest), this.left], [button(ready, () => this.reply({}), "main")]);
  }

  override update({ remaining }: Dialogue): void {
    const seconds = Math.ceil(remaining);
    const time = `${Math.floor(seconds / 60)}:${`${seconds % 60}`.padStart(2, "0")}`;
    const { rest_left, rest_over } = this.words.pauses;
    tell(this.left, seconds ? fill(rest_left, { time }) : rest_over);
  }
}

export class Countdown extends Sheet {
  private readonly count = make("p", { class: "count", role: "timer", "aria-live": "assertive" });

  constructor(private readonly words: Pages) {
    super("counting", words.controls.read_on);
  }

  begin(): void {
    this.write([heading(this.words.pauses.countdown), this.count], []);
  }

  override update({ remaining }: Dialogue): void {
    tell(this.count, `${Math.max(1, Math.ceil(remaining))}`);
  }
}

export class Thanks extends Sheet {
  constructor(private readonly words: Pages, private readonly lines: string[]) {
    super("reading", words.controls.read_on);
  }

  begin(): void {
    const { thanks, thanks_text } = this.words.pauses;
    this.write([...result(this.lines), heading(thanks), ...paragraphs([thanks_text])], []);
  }
}

/** How the trial ended; there was no time to read it. */
function result(lines: string[]): HTMLElement[] {
  return lines.length ? [make("p", { class: "result" }, lines.join("\n"))] : [];
}

function paragraphs(texts: string[]): HTMLElement[] {
  return texts.map((text) => make("p", {}, text));
}

function tell(place: HTMLElement, text: string): void {
  if (place.textContent !== text) place.textContent = text;
}
