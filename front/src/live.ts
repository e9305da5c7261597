/** What arrives from a trial while it is driven. */

import type { Moment, Setting } from "./film";
import { ServerClock } from "./server_clock";

export interface State {
  trial: number;
  t: number;
  values: { [channel: string]: number | null };
  target: string | null;
  lines: string[];
  collisions: number;
  events: [number, string, string][];
  rays: [from: [number, number], to: [number, number]][];
  health: Reading[];
  status: string;
  made: number;
}

export interface Reading { name: string; value: number; unit: string; ok: boolean }

/** What a session says to the participant between two trials; `content` is as `page` says,
 * `lines` stood on the screen when the trial before it ended. */
export interface Dialogue {
  page: "instruct" | "rest" | "countdown" | "consent" | "survey" | "thank";
  mark: string;
  remaining: number;
  trial: number | null;
  content: unknown;
  lines: string[];
  stick: [x: number, y: number, theta: number] | null;
}

/** Of the participant's screen, ms; `clock_ms` is how far off the numbers may be. */
export interface Lag { trial: number; frames: number; median_ms: number; p99_ms: number; clock_ms: number }

export interface Coming { place: number; kind: string; label: string; route: string; expected_s: number }

export interface LiveSetting extends Setting {
  trial: number;
  participant: string;
  label: string;
  masked: boolean;
  kind: string;
  route: string;
  visit: number;
  place: number;
  places: number;
  expected_s: number;
  coming: Coming[];
  pause_s: number;
  boundary: [number, number][];
}

export function momentOf(state: State, { start: [x, y, theta] }: Setting): Moment {
  const { t, values } = state;
  const value = (name: string): number => values[name] ?? 0;
  return { t, x: values.x ?? x, y: values.y ?? y, theta: values.theta ?? theta, value };
}

interface Said { dialogue: Dialogue; made: number }
interface Told { state: State | Said | null; lag: Lag | null }
interface Answered { clock: number; at: number }

const SILENCE = 2000;
/** ms without a word from the server after which the connection counts as lost. */
const STALL = 300;
const AGAIN = 500;
const ASK_CLOCK = 500;
/** ms between questions after the session's clock. */

/** The connection to the server: the latest state, and a way to answer. It connects again by itself. */
export class Live {
  state: State | null = null;
  dialogue: Dialogue | null = null;
  lag: Lag | null = null;
  readonly clock = new ServerClock();
  private socket: WebSocket | null = null;
  private heardAt = performance.now();
  private lookedAt = performance.now();
  private known = 0;

  constructor(private readonly onSetting: (setting: LiveSetting) => void) {
    this.connect();
    setInterval(() => this.say({ clock: performance.now() }), ASK_CLOCK);
  }

  /** To be asked at every frame; time in which the page itself stood still does not count. */
  get lost(): boolean {
    const now = performance.now();
    if (now - this.lookedAt > STALL) this.heardAt += now - this.lookedAt;
    this.lookedAt = now;
    return now - this.heardAt > SILENCE;
  }

  say(answer: object): void {
    if (this.socket?.readyState === WebSocket.OPEN) this.socket.send(JSON.stringify(answer));
  }

  /** Tell that a state is on the screen now. */
  drew({ trial, made }: State): void {
    if (!Number.isFinite(this.clock.within)) return;
    this.say({ drawn: made, trial, at: this.clock.now / 1000, within: this.clock.within / 1000 });
  }

  private connect(): void {
    const socket = new WebSocket(`ws${location.protocol.slice(4)}//${location.host}/live`);
    this.socket = socket;
    socket.addEventListener("open", () => this.say({ clock: performance.now() }));
    socket.addEventListener("message", (message) => {
      this.heardAt = performance.now();
      const told = JSON.parse(message.data as string) as Told | Answered;
      if ("clock" in told) {
        this.clock.learn(told.clock, told.at);
        return;
      }
      const { state, lag } = told;
      if (state) this.say({ took: true });
      this.dialogue = state && "dialogue" in state ? state.dialogue : null;
      this.state = state && "trial" in state ? state : null;
      this.lag = lag;
      const trial = this.state?.trial ?? this.dialogue?.trial;
      if (trial && trial !== this.known) void this.fetchSetting(trial);
    });
    socket.addEventListener("close", () => setTimeout(() => this.connect(), AGAIN));
  }

  private async fetchSetting(trial: number): Promise<void> {
    this.known = trial;
    const answer = await fetch(`/setting/${trial}`);
    if (answer.ok) this.onSetting((await answer.json()) as LiveSetting);
  }
}
