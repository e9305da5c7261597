/** A range sensor's rays, cast again from where the robot was: exact, without the sensor's noise. */

import type { Body, Moment, Scene, Sight } from "./film";
import { placeOf } from "./motion";

type Point = [number, number];

/** A body at the height of the rays, where it was at an instant. */
interface Obstacle { body: Body; x: number; y: number; yaw: number; reach: number }

export class Rays {
  private readonly bodies: Body[];

  constructor(private readonly sight: Sight, scene: Scene) {
    this.bodies = scene.bodies.filter((body) => {
      const tall = body.geometry.shape === "box" ? body.geometry.z : body.geometry.length;
      return body.solid && body.role !== "floor" && Math.abs(body.z - sight.height) <= tall / 2;
    });
  }

  /** Where rays meet something, in the robot's frame, m. */
  hits(moment: Moment): [from: Point, to: Point][] {
    const near = this.near(moment);
    const found: [Point, Point][] = [];
    const [c, s] = [Math.cos(moment.theta), Math.sin(moment.theta)];
    this.sight.angles.forEach((angle, i) => {
      const [ox, oy] = this.sight.origins[i]!;
      const from: Point = [moment.x + c * ox - s * oy, moment.y + s * ox + c * oy];
      const towards: Point = [Math.cos(moment.theta + angle), Math.sin(moment.theta + angle)];
      let range = this.sight.max_range;
      for (const one of near) range = Math.min(range, along(one, from, towards));
      if (range >= this.sight.max_range) return;
      found.push([[ox, oy], [ox + range * Math.cos(angle), oy + range * Math.sin(angle)]]);
    });
    return found;
  }

  /** What rays might meet from here. */
  private near(moment: Moment): Obstacle[] {
    const far = this.sight.max_range + Math.max(...this.sight.origins.map(([x, y]) => Math.hypot(x, y)));
    return this.bodies.map((body) => placed(body, moment)).filter(
      ({ x, y, reach }) => Math.hypot(x - moment.x, y - moment.y) <= far + reach,
    );
  }
}

function placed(body: Body, moment: Moment): Obstacle {
  const shape = body.geometry;
  const reach = shape.shape === "box" ? Math.hypot(shape.x, shape.y) / 2 : shape.radius;
  const [x, y] = placeOf(body, moment.t);
  if (!body.hinge) return { body, x, y, yaw: body.yaw, reach };
  const yaw = body.yaw + moment.value(`hinge_${body.name}`);
  const [was, is] = [turned(body.hinge, body.yaw), turned(body.hinge, yaw)];
  return { body, x: x + was[0] - is[0], y: y + was[1] - is[1], yaw, reach };
}

function turned({ x, y }: { x: number; y: number }, angle: number): Point {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return [c * x - s * y, s * x + c * y];
}

/** How far a ray gets before it enters a body, m; infinite past it, and from inside. */
function along(obstacle: Obstacle, from: Point, towards: Point): number {
  const shape = obstacle.body.geometry;
  const back = -obstacle.yaw;
  const [x, y] = turned({ x: from[0] - obstacle.x, y: from[1] - obstacle.y }, back);
  const [dx, dy] = turned({ x: towards[0], y: towards[1] }, back);
  if (shape.shape === "cylinder") {
    const [half, rest] = [x * dx + y * dy, x * x + y * y - shape.radius ** 2];
    const root = half * half - rest;
    const range = root < 0 ? Infinity : -half - Math.sqrt(root);
    return range >= 0 ? range : Infinity;
  }
  const [inX, outX] = slab(x, dx, shape.x / 2);
  const [inY, outY] = slab(y, dy, shape.y / 2);
  const enters = Math.max(inX, inY);
  return enters >= 0 && enters <= Math.min(outX, outY) ? enters : Infinity;
}

/** Where a line is between two parallel planes. */
function slab(at: number, towards: number, half: number): Point {
  if (Math.abs(towards) < 1e-12) return Math.abs(at) <= half ? [-Infinity, Infinity] : [Infinity, -Infinity];
  const [one, other] = [(-half - at) / towards, (half - at) / towards];
  return one < other ? [one, other] : [other, one];
}
