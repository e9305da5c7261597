/** Scripted paths of moving bodies, by the same rule as the simulation's. */

import type { Body, Patrol } from "./film";

type Place = [number, number];

/** Where a body is at t seconds after the trial opened. */
export function placeOf(body: Body, t: number): Place {
  const motion = body.motion;
  if (!motion) return [body.x, body.y];
  const home: Place = [body.x, body.y];
  if (motion.kind === "patrol") {
    const stops = patrolled(motion, home);
    return between(stops, (t + motion.offset) % stops[stops.length - 1]![0]);
  }
  const stops: Stop[] = [[0, home], ...motion.stops.map(([at, x, y]): Stop => [at, [x, y]])];
  return between(stops, motion.repeats ? t % stops[stops.length - 1]![0] : t);
}

type Stop = [number, Place];

function patrolled(motion: Patrol, home: Place): Stop[] {
  const there: Place[] = [home, ...motion.waypoints];
  const round = motion.course === "round";
  const corners = round ? [...there, home] : [...there, ...there.slice(0, -1).reverse()];
  const turning = round ? -1 : motion.waypoints.length;
  const stops: Stop[] = [[0, home]];
  let t = 0;
  for (let i = 1; i < corners.length; i += 1) {
    const [from, to] = [corners[i - 1]!, corners[i]!];
    t += Math.hypot(to[0] - from[0], to[1] - from[1]) / motion.speed;
    stops.push([t, to]);
    if (motion.pause > 0 && (i === turning || i === corners.length - 1)) {
      t += motion.pause;
      stops.push([t, to]);
    }
  }
  return stops;
}

function between(stops: Stop[], t: number): Place {
  const next = stops.findIndex(([at]) => at > t);
  if (next < 1) return stops[next === 0 ? 0 : stops.length - 1]![1];
  const [[before, a], [after, b]] = [stops[next - 1]!, stops[next]!];
  const part = (t - before) / (after - before);
  return [a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1])];
}
