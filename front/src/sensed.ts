/** What a robot senses, drawn on it: rays as the thesis draws them, and where walls push. */

import {
  BufferGeometry, Color, DoubleSide, Float32BufferAttribute, Group, LineBasicMaterial, LineLoop, LineSegments,
  Mesh, MeshBasicMaterial, Points, PointsMaterial, Shape, ShapeGeometry, Vector2,
} from "three";
import { BOUNDARY, CLEARANCE, COLLISION, FORCE_X } from "./colours";

type Point = [number, number];

const RAY = CLEARANCE;
const RAY_AHEAD = FORCE_X;
/** Light blue and green, as the thesis has them; colours that also tell series apart. */
const AHEAD = (33.75 * Math.PI) / 180 + 1e-6;
/** rad to either side that the thesis draws as the front sector: rays 52 to 76 of 128. */
const HEIGHT = 0.3;

/** Rays that met something, from where they start to where they end, in the robot's frame. */
export class Scanned {
  readonly group = new Group();
  private readonly rays = new LineSegments(new BufferGeometry(), new LineBasicMaterial({ vertexColors: true }));
  private readonly ends = new Points(
    new BufferGeometry(), new PointsMaterial({ color: COLLISION, size: 5, sizeAttenuation: false }),
  );

  constructor() {
    this.group.add(this.rays, this.ends);
    this.group.position.z = HEIGHT;
    for (const one of [this.rays, this.ends]) one.frustumCulled = false;
  }

  show(rays: [from: Point, to: Point][]): void {
    const tints = rays.flatMap(([[ox, oy], [x, y]]) => {
      const tint = Math.abs(Math.atan2(y - oy, x - ox)) < AHEAD ? RAY_AHEAD : RAY;
      const parts = new Color(tint).toArray();
      return [...parts, ...parts];
    });
    this.rays.geometry.setAttribute("position", places(rays.flat()));
    this.rays.geometry.setAttribute("color", new Float32BufferAttribute(tints, 3));
    this.ends.geometry.setAttribute("position", places(rays.map(([, to]) => to)));
  }
}

/** The layer round the robot inside which walls push. */
export function layer(boundary: Point[]): Group {
  const group = new Group();
  const line = new BufferGeometry();
  line.setAttribute("position", places(boundary));
  const skin = new MeshBasicMaterial({
    color: BOUNDARY, transparent: true, opacity: 0.3, depthWrite: false, side: DoubleSide,
  });
  const outline = new Shape(boundary.map(([x, y]) => new Vector2(x, y)));
  group.add(new LineLoop(line, new LineBasicMaterial({ color: BOUNDARY })), new Mesh(new ShapeGeometry(outline), skin));
  group.position.z = 0.01;
  return group;
}

function places(points: Point[]): Float32BufferAttribute {
  return new Float32BufferAttribute(points.flatMap(([x, y]) => [x, y, 0]), 3);
}
