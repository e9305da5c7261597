/** A scene's bodies as things to look at. */

import {
  BoxGeometry, BufferGeometry, CircleGeometry, Color, CylinderGeometry, Float32BufferAttribute,
  Group, Mesh, MeshBasicMaterial, PlaneGeometry, Shape, ShapeGeometry,
} from "three";
import type { Body, Moment, Scene } from "./film";
import { placeOf } from "./motion";
import { concrete, matt, plaster, wood, type Matt } from "./textures";

const WALL_TINT: { [colour: string]: string } = { "#8a8f98": "#f4f1e9" };
/** The stock grey of a wall in plans is plaster in the light. */
const TOP = "#4a505a";
const REGION_TINTS: { [group: string]: string } = { blue: "#5b8fd9", green: "#57a86b" };

export interface Extent { west: number; east: number; south: number; north: number; height: number }

export function extentOf(scene: Scene): Extent {
  const extent = { west: Infinity, east: -Infinity, south: Infinity, north: -Infinity, height: 0.1 };
  for (const body of scene.bodies) {
    const shape = body.geometry;
    const radius = shape.shape === "box" ? 0 : shape.radius;
    const [c, s] = [Math.abs(Math.cos(body.yaw)), Math.abs(Math.sin(body.yaw))];
    const dx = shape.shape === "box" ? (c * shape.x + s * shape.y) / 2 : radius;
    const dy = shape.shape === "box" ? (s * shape.x + c * shape.y) / 2 : radius;
    const height = shape.shape === "box" ? shape.z : shape.length;
    extent.west = Math.min(extent.west, body.x - dx);
    extent.east = Math.max(extent.east, body.x + dx);
    extent.south = Math.min(extent.south, body.y - dy);
    extent.north = Math.max(extent.north, body.y + dy);
    extent.height = Math.max(extent.height, body.z + height / 2);
  }
  return Number.isFinite(extent.west)
    ? extent : { west: -3, east: 3, south: -3, north: 3, height: 0.1 };
}

export class World {
  readonly group = new Group();
  readonly extent: Extent;
  private readonly doors: [string, Group][] = [];
  private readonly movers: [Body, Mesh][] = [];
  private readonly blocks = new Map<string, Mesh>();

  constructor(scene: Scene) {
    this.extent = extentOf(scene);
    this.group.add(floor(this.extent));
    for (const region of scene.regions) this.group.add(tinted(region.polygon, region.group));
    const still = scene.bodies.filter((body) => body.role === "wall" && !body.motion);
    for (const mesh of walls(still)) this.group.add(mesh);
    for (const body of scene.bodies) {
      if (body.role === "floor" || (body.role === "wall" && !body.motion)) continue;
      this.add(body);
    }
  }

  /** Where a block stands, for what marks it. */
  block(name: string): Mesh | undefined {
    return this.blocks.get(name);
  }

  /** Open doors and move bodies as they were at an instant; tells whether anything moved. */
  show(moment: Moment): boolean {
    let moved = this.movers.length > 0;
    for (const [name, hinge] of this.doors) {
      const angle = moment.value(`hinge_${name}`);
      moved ||= Math.abs(angle - hinge.rotation.z) > 1e-4;
      hinge.rotation.z = angle;
    }
    for (const [body, mesh] of this.movers) {
      const [x, y] = placeOf(body, moment.t);
      mesh.position.set(x, y, body.z);
    }
    return moved;
  }

  private add(body: Body): void {
    const mesh = new Mesh(geometryOf(body), materialOf(body));
    mesh.castShadow = mesh.receiveShadow = true;
    if (body.hinge) {
      const frame = new Group();
      frame.position.set(body.x, body.y, body.z);
      frame.rotation.z = body.yaw;
      const hinge = new Group();
      hinge.position.set(body.hinge.x, body.hinge.y, 0);
      mesh.position.set(-body.hinge.x, -body.hinge.y, 0);
      hinge.add(mesh, handle(body));
      frame.add(hinge);
      this.group.add(frame);
      this.doors.push([body.name, hinge]);
      return;
    }
    mesh.position.set(body.x, body.y, body.z);
    mesh.rotation.z = body.yaw;
    this.group.add(mesh);
    if (body.motion) this.movers.push([body, mesh]);
    else this.blocks.set(body.name, mesh);
  }
}

function geometryOf({ geometry }: Body): BufferGeometry {
  if (geometry.shape === "box") return new BoxGeometry(geometry.x, geometry.y, geometry.z);
  return new CylinderGeometry(geometry.radius, geometry.radius, geometry.length, 32).rotateX(Math.PI / 2);
}

function materialOf(body: Body): Matt {
  const colour = new Color(body.colour);
  if (body.role === "door") return matt({ color: colour, map: wood() });
  if (body.role === "wall") return matt({ color: "#c2410c" });
  return matt({
    color: colour, emissive: colour, emissiveIntensity: 0.25,
  });
}

function handle(body: Body): Group {
  const both = new Group();
  const shape = body.geometry;
  if (shape.shape !== "box" || !body.hinge) return both;
  const metal = matt({ color: "#d8dade" });
  for (const side of [1, -1]) {
    const knob = new Mesh(new BoxGeometry(0.1, 0.02, 0.02), metal);
    knob.position.set(-1.86 * body.hinge.x, side * (shape.y / 2 + 0.02), 0.1);
    both.add(knob);
  }
  return both;
}

function floor(extent: Extent): Mesh {
  const margin = 12;
  const width = extent.east - extent.west + 2 * margin;
  const depth = extent.north - extent.south + 2 * margin;
  const geometry = new PlaneGeometry(width, depth);
  const [x, y] = [(extent.east + extent.west) / 2, (extent.north + extent.south) / 2];
  const place = geometry.getAttribute("position");
  const uv = geometry.getAttribute("uv");
  for (let i = 0; i < place.count; i += 1) uv.setXY(i, place.getX(i) + x, place.getY(i) + y);
  const mesh = new Mesh(geometry, matt({ map: concrete() }));
  mesh.position.set(x, y, 0);
  mesh.receiveShadow = true;
  return mesh;
}

function tinted(polygon: [number, number][], group: string): Mesh {
  const outline = new Shape();
  polygon.forEach(([x, y], i) => (i ? outline.lineTo(x, y) : outline.moveTo(x, y)));
  const material = new MeshBasicMaterial({
    color: REGION_TINTS[group] ?? "#8a8a86", transparent: true, opacity: 0.14, depthWrite: false,
  });
  const mesh = new Mesh(new ShapeGeometry(outline), material);
  mesh.position.z = 0.002;
  return mesh;
}

/** All walls that stand still as two meshes a colour, sides and tops: few calls for any map. */
function walls(bodies: Body[]): Mesh[] {
  const meshes: Mesh[] = [];
  const boxes = bodies.filter(({ geometry }) => geometry.shape === "box");
  for (const colour of new Set(boxes.map((body) => body.colour))) {
    const [sides, tops] = [new Faces(), new Faces()];
    for (const body of boxes.filter((one) => one.colour === colour)) addBox(body, sides, tops);
    const tint = WALL_TINT[colour] ?? colour;
    meshes.push(
      shaded(sides.geometry(), matt({ color: tint, map: plaster() })),
      shaded(tops.geometry(), matt({ color: TOP })),
    );
  }
  for (const body of bodies) {
    if (body.geometry.shape === "box") continue;
    const { radius, length } = body.geometry;
    const tint = WALL_TINT[body.colour] ?? body.colour;
    const post = shaded(geometryOf(body), matt({ color: tint, map: plaster() }));
    post.position.set(body.x, body.y, body.z);
    const top = shaded(new CircleGeometry(radius, 32), matt({ color: TOP }));
    top.position.set(body.x, body.y, body.z + length / 2 + 0.001);
    meshes.push(post, top);
  }
  return meshes;
}

function shaded(geometry: BufferGeometry, material: Matt): Mesh {
  const mesh = new Mesh(geometry, material);
  mesh.castShadow = mesh.receiveShadow = true;
  return mesh;
}

type Corner = [number, number, number];

/** Four-cornered faces that are collected into one geometry. */
class Faces {
  private readonly places: number[] = [];
  private readonly normals: number[] = [];
  private readonly uvs: number[] = [];

  /** Add a face by its corners, counter-clockwise, and its sizes for the texture, in m. */
  add(corners: [Corner, Corner, Corner, Corner], normal: Corner, width: number, height: number): void {
    const uv: [number, number][] = [[0, 0], [width, 0], [width, height], [0, height]];
    for (const i of [0, 1, 2, 0, 2, 3]) {
      this.places.push(...corners[i]!);
      this.normals.push(...normal);
      this.uvs.push(...uv[i]!);
    }
  }

  geometry(): BufferGeometry {
    const made = new BufferGeometry();
    made.setAttribute("position", new Float32BufferAttribute(this.places, 3));
    made.setAttribute("normal", new Float32BufferAttribute(this.normals, 3));
    made.setAttribute("uv", new Float32BufferAttribute(this.uvs, 2));
    return made;
  }
}

function addBox(body: Body, sides: Faces, tops: Faces): void {
  if (body.geometry.shape !== "box") return;
  const { x: length, y: width, z: height } = body.geometry;
  const [c, s] = [Math.cos(body.yaw), Math.sin(body.yaw)];
  const [low, high] = [body.z - height / 2, body.z + height / 2];
  const plan = [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([u, v]): [number, number] => {
    const [x, y] = [(u! * length) / 2, (v! * width) / 2];
    return [body.x + c * x - s * y, body.y + s * x + c * y];
  });
  plan.forEach((from, i) => {
    const to = plan[(i + 1) % 4]!;
    const long = Math.hypot(to[0] - from[0], to[1] - from[1]);
    const normal: Corner = [(to[1] - from[1]) / long, -(to[0] - from[0]) / long, 0];
    sides.add([[...from, low], [...to, low], [...to, high], [...from, high]], normal, long, height);
  });
  const top = plan.map((corner): Corner => [...corner, high]);
  tops.add(top as [Corner, Corner, Corner, Corner], [0, 0, 1], length, width);
}
