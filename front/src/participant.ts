/** The participant's screen: the world from the robot, the pages between trials, a button to stop. */

import { fillScreen, keepAwake } from "./awake";
import { Choices } from "./choices";
import { Consent, type ConsentForm } from "./consent";
import { Keys } from "./keys";
import { Live, momentOf, type Dialogue, type LiveSetting, type State } from "./live";
import { Countdown, Instructions, Rest, Thanks } from "./pauses";
import { Questionnaire, type Instrument } from "./questionnaire";
import type { Pages, Screen } from "./sentences";
import { button, type Reply, type Sheet } from "./sheet";
import { NoWebGL, Stage, type Eye } from "./stage";
import { StickPointer } from "./stick";
import { Switch, type Scanning } from "./switch";
import { make } from "./words";

interface Shown {
  language: string;
  screen: Screen;
  pages: Pages;
  blocks: { [name: string]: string };
  eye: Eye & { force_arrows: boolean };
  scanning: Scanning;
}

const AGAIN_MS = 250;
/** A reply is repeated until another page comes: the connection may just be lost. */

export function participant(shown: Shown): void {
  document.documentElement.lang = shown.language;
  const page = new ParticipantPage(shown);
  document.body.append(page.element);
  page.start();
}

class ParticipantPage {
  readonly element: HTMLElement;
  private readonly title: HTMLElement;
  private readonly canvas: HTMLCanvasElement;
  private readonly message = make("p", { class: "message large", role: "status" });
  private readonly chip = make("span", { class: "chip", "aria-hidden": "true" });
  private readonly called = make("strong");
  private readonly cue: HTMLElement;
  private readonly whole: HTMLButtonElement;
  private readonly stop: HTMLButtonElement;
  private readonly live: Live;
  private readonly choices: Choices;
  private readonly stick: StickPointer;
  private readonly oneSwitch: Switch | null;
  private setting: LiveSetting | null = null;
  private blind = false;
  private stage: Stage | null = null;
  private driving = false;
  private stopped = 0;
  private drawn = 0;
  private sheet: Sheet | null = null;
  private asked: Dialogue | null = null;
  private said: (Reply & { to: string; stopped?: boolean }) | null = null;
  private saidAt = 0;
  frames = 0;

  constructor(private readonly shown: Shown) {
    const { screen, pages, scanning } = shown;
    const lean = scanning.one_switch ? " switched" : "";
    this.title = make("h1", { class: "unseen" }, screen.scene);
    this.canvas = make("canvas", { class: "scene", role: "img", "aria-label": screen.scene });
    this.cue = make("p", { class: "cue" }, `${screen.next_target}: `, this.chip, this.called);
    this.whole = button(pages.controls.full_screen, fillScreen, "whole");
    this.stop = button(screen.stop, () => this.end(), "stop");
    this.stop.disabled = true;
    this.element = make("main", { class: `participant${lean}` },
      this.title, this.canvas, this.cue, this.message, this.whole, this.stop);
    this.choices = new Choices(this.element);
    this.stick = new StickPointer(this.choices);
    this.oneSwitch = scanning.one_switch ? new Switch(this.choices, scanning.pace) : null;
    this.live = new Live((setting) => this.open(setting));
    if (!this.oneSwitch) new Keys((codes) => this.live.say({ keys: codes }));
    Object.assign(window, { participant: this });
  }

  start(): void {
    keepAwake();
    requestAnimationFrame(() => this.frame());
  }

  private open(setting: LiveSetting): void {
    try {
      this.stage?.close();
      this.stage = new Stage(this.canvas, setting, 1, false, this.shown.eye);
    } catch (fault) {
      if (!(fault instanceof NoWebGL)) throw fault;
      this.blind = true;
      return;
    }
    this.setting = setting;
    this.stage.sign(this.shown.blocks);
    void this.stage.prepare();
    this.stage.view = "first";
    this.stage.forces.group.visible = this.shown.eye.force_arrows;
    this.stage.trail.mesh.visible = false;
  }

  private end(): void {
    const { state } = this.live;
    if (this.sheet && this.asked) this.reply({}, true);
    else if (state) {
      this.stopped = state.trial;
      this.live.say({ stop: state.trial });
    }
  }

  private reply(said: Reply, stopped = false): void {
    if (!this.asked || this.said?.to === this.asked.mark) return;
    this.said = { ...said, to: this.asked.mark, stopped };
    this.saidAt = 0;
  }

  private frame(): void {
    requestAnimationFrame(() => this.frame());
    const now = performance.now();
    const { state, dialogue } = this.live;
    const running = state !== null && state.status === "running";
    if (dialogue) this.converse(dialogue, now);
    else if (state) this.asked = this.said = null;
    if (!this.asked || this.answered || (this.asked.page === "countdown" && !dialogue)) this.putAway();
    this.title.hidden = this.sheet !== null;
    this.tell(this.sentences(state));
    this.offerStop(running && this.stopped !== state.trial, this.sheet !== null && this.asked?.page !== "thank");
    this.whole.hidden = running || !document.fullscreenEnabled || document.fullscreenElement !== null;
    this.point(running ? state.target : null);
    this.oneSwitch?.scan(now);
    if (!state || !this.stage || this.setting?.trial !== state.trial || this.drawn === state.made) return;
    if (!this.stage.draw(momentOf(state, this.setting), null)) return;
    this.frames += 1;
    this.drawn = state.made;
    requestAnimationFrame(() => this.live.drew(state));
  }

  private get answered(): boolean {
    return this.said !== null && this.said.to === this.asked?.mark;
  }

  /** Show what the session shows, and repeat what was said to it. */
  private converse(dialogue: Dialogue, now: number): void {
    if (dialogue.mark !== this.asked?.mark) {
      this.putAway();
      this.asked = dialogue;
      this.sheet = this.sheetOf(dialogue);
      this.whole.before(this.sheet.element);
      this.sheet.begin();
      this.choices.forget();
      this.stick.forget();
    }
    this.sheet?.update(dialogue);
    if (this.sheet && dialogue.stick) this.stick.follow(dialogue.stick, now);
    if (this.answered && now - this.saidAt > AGAIN_MS) {
      this.saidAt = now;
      this.live.say({ said: this.said });
    }
  }

  private sheetOf({ page, mark, content, lines: ended, stick }: Dialogue): Sheet {
    const words = this.shown.pages;
    const lines = this.stopped ? [this.shown.screen.stopped] : ended;
    this.stopped = 0;
    const reply = (said: Reply): void => this.reply(said);
    if (page === "instruct") return new Instructions(words, reply);
    if (page === "rest") return new Rest(words, lines, reply);
    if (page === "countdown") return new Countdown(words);
    if (page === "thank") return new Thanks(words, lines);
    if (page === "consent") return new Consent(content as ConsentForm, mark, words, reply);
    const withPad = this.oneSwitch !== null || stick !== null;
    return new Questionnaire(content as Instrument, mark, words, reply, withPad);
  }

  private putAway(): void {
    this.sheet?.element.remove();
    this.sheet = null;
  }

  /** During a trial the one button has the focus whenever it can be pressed. */
  private offerStop(driving: boolean, reading: boolean): void {
    const begins = driving && !this.driving;
    this.driving = driving;
    this.stop.disabled = !driving && !reading;
    if (begins) this.stop.focus();
  }

  private sentences(state: State | null): string[] {
    const { screen, pages } = this.shown;
    if (this.answered && this.said?.stopped) return [screen.stopped];
    if (this.asked?.page === "thank") return [];
    if (this.live.lost) return [screen.connection_lost];
    if (this.sheet) return [];
    if (this.blind) return [screen.no_picture];
    if (this.asked?.page === "countdown") return [pages.pauses.starting];
    if (!state) return [screen.waiting];
    if (this.stopped === state.trial) return [screen.stopped];
    return state.lines;
  }

  private tell(lines: string[]): void {
    const text = lines.join("\n");
    if (this.message.textContent !== text) this.message.textContent = text;
    this.message.hidden = text === "";
  }

  private point(target: string | null): void {
    const block = this.setting?.scene.bodies.find((body) => body.name === target);
    this.cue.hidden = !block;
    if (!block) return;
    this.chip.style.background = block.colour;
    const word = this.shown.blocks[block.name] ?? "";
    if (this.called.textContent !== word) this.called.textContent = word;
  }
}
