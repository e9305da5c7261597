/** The participant's screen: the world from the robot, the task's sentences, a button to stop. */

import { Live, momentOf, type LiveSetting, type State } from "./live";
import { NoWebGL, Stage, type Eye } from "./stage";
import { make, say } from "./words";

interface Screen {
  waiting: string;
  next_target: string;
  stop: string;
  stopped: string;
  connection_lost: string;
  no_picture: string;
  scene: string;
}

interface Shown { language: string; screen: Screen; eye: Eye & { force_arrows: boolean } }

export function participant({ language, screen, eye }: Shown): void {
  document.documentElement.lang = language;
  const page = new ParticipantPage(screen, eye);
  document.body.append(page.element);
  page.start();
}

class ParticipantPage {
  readonly element: HTMLElement;
  private readonly canvas: HTMLCanvasElement;
  private readonly message = make("p", { class: "message large", role: "status" });
  private readonly chip = make("span", { class: "chip" });
  private readonly cue: HTMLElement;
  private readonly stop: HTMLButtonElement;
  private readonly live: Live;
  private setting: LiveSetting | null = null;
  private stage: Stage | null = null;
  private stopped = 0;
  private drawn = 0;
  frames = 0;

  constructor(private readonly screen: Screen, private readonly eye: Shown["eye"]) {
    this.canvas = make("canvas", { class: "scene", role: "img", "aria-label": screen.scene });
    this.cue = make("p", { class: "cue" }, `${screen.next_target} `, this.chip);
    this.stop = make("button", { type: "button", class: "stop" }, screen.stop);
    this.stop.disabled = true;
    this.stop.addEventListener("click", () => this.end());
    const title = make("h1", { class: "unseen" }, screen.scene);
    this.element = make("main", { class: "participant" }, title, this.canvas, this.cue, this.message, this.stop);
    this.live = new Live((setting) => this.open(setting));
    Object.assign(window, { participant: this });
  }

  start(): void {
    void navigator.wakeLock?.request("screen").catch(() => undefined);
    requestAnimationFrame(() => this.frame());
  }

  private open(setting: LiveSetting): void {
    try {
      this.stage?.close();
      this.stage = new Stage(this.canvas, setting, 1, false, this.eye);
    } catch (fault) {
      if (!(fault instanceof NoWebGL)) throw fault;
      document.body.replaceChildren(say(this.screen.no_picture, ""));
      return;
    }
    this.setting = setting;
    void this.stage.prepare();
    this.stage.view = "first";
    this.stage.forces.group.visible = this.eye.force_arrows;
    this.stage.trail.mesh.visible = false;
  }

  private end(): void {
    const state = this.live.state;
    if (!state) return;
    this.stopped = state.trial;
    this.live.say({ stop: state.trial });
  }

  private frame(): void {
    requestAnimationFrame(() => this.frame());
    const state = this.live.state;
    this.tell(this.sentences(state));
    const running = state !== null && state.status === "running";
    this.offerStop(running && this.stopped !== state.trial);
    this.point(running ? state.target : null);
    if (!state || !this.stage || this.setting?.trial !== state.trial || this.drawn === state.made) return;
    if (!this.stage.draw(momentOf(state, this.setting), null)) return;
    this.frames += 1;
    this.drawn = state.made;
    requestAnimationFrame(() => this.live.drew(state));
  }

  /** The one button has the focus whenever it can be pressed: one switch is enough. */
  private offerStop(offered: boolean): void {
    if (this.stop.disabled !== offered) return;
    this.stop.disabled = !offered;
    if (offered) this.stop.focus();
  }

  private sentences(state: State | null): string[] {
    if (this.live.lost) return [this.screen.connection_lost];
    if (!state) return [this.screen.waiting];
    if (this.stopped === state.trial) return [this.screen.stopped];
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
    if (block) this.chip.style.background = block.colour;
  }
}
