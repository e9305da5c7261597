/** What arrives from a trial while it is driven. */

import type { Moment, Setting } from "./film";

export interface State {
  trial: number;
  t: number;
  values: { [channel: string]: number | null };
  target: string | null;
  lines: string[];
  collisions: number;
  events: [number, string, string][];
  hits: [number, number][];
  late: number;
  status: string;
  made: number;
}

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

export interface Lag { trial: number; frames: number; median_ms: number; p99_ms: number }

export interface LiveSetting extends Setting {
  trial: number;
  participant: string;
  label: string;
  route: string;
  place: number;
  places: number;
  expected_s: number;
  following: string;
  boundary: [number, number][];
}

type Told = State | { dialogue: Dialogue } | null;

export function momentOf(state: State): Moment {
  const value = (name: string): number => state.values[name] ?? 0;
  return { t: state.t, x: value("x"), y: value("y"), theta: value("theta"), value };
}

const SILENCE = 2000;
/** ms without a word from the server after which the connection counts as lost. */
const STALL = 300;
const AGAIN = 500;

/** The connection to the server: the latest state, and a way to answer. It connects again by itself. */
export class Live {
  state: State | null = null;
  dialogue: Dialogue | null = null;
  lag: Lag | null = null;
  private socket: WebSocket | null = null;
  private heardAt = performance.now();
  private lookedAt = performance.now();
  private known = 0;

  constructor(private readonly onSetting: (setting: LiveSetting) => void) {
    this.connect();
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

  private connect(): void {
    const socket = new WebSocket(`ws${location.protocol.slice(4)}//${location.host}/live`);
    this.socket = socket;
    socket.addEventListener("message", (message) => {
      this.heardAt = performance.now();
      const { state, lag } = JSON.parse(message.data as string) as { state: Told; lag: Lag | null };
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
