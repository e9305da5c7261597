/** A film as the page gets it, and what it says at an instant. Lengths in m, times in s. */

export interface Box { shape: "box"; x: number; y: number; z: number }
export interface Cylinder { shape: "cylinder"; radius: number; length: number }

export interface Patrol {
  kind: "patrol";
  waypoints: [number, number][];
  speed: number;
  course: "there_and_back" | "round";
  pause: number;
  offset: number;
}
export interface Timetable { kind: "timetable"; stops: [number, number, number][]; repeats: boolean }

export interface Body {
  name: string;
  role: "wall" | "target" | "finish" | "door" | "floor";
  geometry: Box | Cylinder;
  x: number;
  y: number;
  z: number;
  yaw: number;
  colour: string;
  solid: boolean;
  hinge: { x: number; y: number } | null;
  motion: Patrol | Timetable | null;
}

export interface Region { name: string; group: string; polygon: [number, number][] }
export interface Scene { bodies: Body[]; regions: Region[] }

export interface Link {
  name: string;
  parent: string;
  geometry: Box | Cylinder;
  x: number;
  y: number;
  z: number;
  roll: number;
  pitch: number;
  yaw: number;
  colour: string;
  surface: "plain" | "rollers_left" | "rollers_right";
  joint: {
    channel: string;
    axis: [number, number, number];
    motion: "turn" | "slide";
    rate: boolean;
  } | null;
}

/** Rays of a range sensor in the robot's frame; `height` above the floor. */
export interface Sight {
  origins: [number, number][];
  angles: number[];
  height: number;
  max_range: number;
}

export interface Leg { target: string; path: [number, number][] }

/** What a stage needs to draw a robot in a world. */
export interface Setting {
  scene: Scene;
  legs: Leg[];
  links: Link[];
  footprint: [number, number];
  sight: Sight | null;
  start: [x: number, y: number, theta: number];
}

export interface Film extends Setting {
  study: string;
  virtual: boolean;
  trial: number;
  participant: string;
  condition: string;
  masked: boolean;
  route: string;
  status: string;
  end: number;
  duration_s: number | null;
  collisions: number | null;
  series: { name: string; unit: string; description: string; data: string }[];
  events: [number, string, string][];
  captions: [number, number, string[]][];
}

/** One instant of a trial, whether stored or live. */
export interface Moment {
  t: number;
  x: number;
  y: number;
  theta: number;
  value(channel: string): number;
}

const PLACE = ["x", "y", "theta"];

/** The series of a film, to be asked at any time. */
export class Record {
  readonly t: Float32Array;
  readonly end: number;
  private readonly series = new Map<string, Float32Array>();

  constructor(film: Film) {
    for (const one of film.series) this.series.set(one.name, decoded(one.data));
    this.t = this.of("t");
    PLACE.forEach((name, i) => this.series.set(name, filled(this.of(name), film.start[i]!, this.t.length)));
    for (const { joint } of film.links) if (joint?.rate) this.addUp(joint.channel);
    this.end = this.t[this.t.length - 1] ?? 0;
  }

  /** All values of a quantity; empty for one that was not recorded. */
  of(name: string): Float32Array {
    return this.series.get(name) ?? new Float32Array(0);
  }

  /** How many samples were taken up to a time. */
  count(t: number): number {
    let low = 0;
    let high = this.t.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.t[middle]! <= t) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  at(t: number): Moment {
    const after = Math.min(Math.max(this.count(t), 1), this.t.length - 1);
    const before = Math.max(after - 1, 0);
    const span = this.t[after]! - this.t[before]! || 1;
    const part = Math.min(Math.max((t - this.t[before]!) / span, 0), 1);
    const value = (name: string): number => {
      const values = this.series.get(name);
      if (!values) return 0;
      const mixed = values[before]! * (1 - part) + values[after]! * part;
      return Number.isFinite(mixed) ? mixed : 0;
    };
    return { t, x: value("x"), y: value("y"), theta: value("theta"), value };
  }

  /** Turn a speed into what it adds up to. */
  private addUp(name: string): void {
    const [t, speed] = [this.of("t"), this.of(name)];
    const sum = new Float32Array(speed.length);
    for (let i = 1; i < speed.length; i += 1) {
      sum[i] = sum[i - 1]! + speed[i - 1]! * (t[i]! - t[i - 1]!);
    }
    if (speed.length) this.series.set(name, sum);
  }
}

/** What was not recorded, or not at once, rests. */
function filled(values: Float32Array, rest: number, count: number): Float32Array {
  if (values.length === 0) return new Float32Array(count).fill(rest);
  return values.map((value) => (Number.isFinite(value) ? value : rest));
}

function decoded(base64: string): Float32Array {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; i += 1) bytes[i] = text.charCodeAt(i);
  return new Float32Array(bytes.buffer); // every machine that draws WebGL is little-endian, as films are
}

/** The block to be reached next, by how many were reached before a time. */
export function targetAt(film: Film, t: number): string | null {
  const reached = film.events.filter(([at, kind]) => at <= t && (kind === "block" || kind === "finish"));
  return film.legs[reached.length]?.target ?? null;
}

/** The running number of collisions at a time. */
export function collisionsAt(film: Film, t: number): number {
  return film.events.filter(([at, kind]) => at <= t && kind === "collision").length;
}

export function linesAt(film: Film, t: number): string[] {
  return film.captions.filter(([begin, end]) => begin <= t && t < end).flatMap(([, , lines]) => lines);
}
