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
  lag: Lag | null = null;
  private socket: WebSocket | null = null;
  private heardAt = performance.now();
  private lookedAt = performance.now();

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
      const told = JSON.parse(message.data as string) as { state: State | null; lag: Lag | null };
      if (told.state && told.state.trial !== this.state?.trial) void this.fetchSetting(told.state.trial);
      this.state = told.state;
      this.lag = told.lag;
    });
    socket.addEventListener("close", () => setTimeout(() => this.connect(), AGAIN));
  }

  private async fetchSetting(trial: number): Promise<void> {
    const answer = await fetch(`/setting/${trial}`);
    if (answer.ok) this.onSetting((await answer.json()) as LiveSetting);
  }
}
