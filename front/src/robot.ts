/** A robot as its links say, and what is drawn round it: forces, trail, light cue. */

import {
  BoxGeometry, BufferGeometry, CylinderGeometry, DynamicDrawUsage, Float32BufferAttribute, Group,
  Mesh, MeshBasicMaterial, Quaternion, Shape, ShapeGeometry, Vector3,
} from "three";
import { FORCE_X, FORCE_Y, RESULTANT, TORQUE_LEFT, TORQUE_RIGHT, TRAIL } from "./colours";
import type { Link, Moment, Setting } from "./film";
import { matt, rollers } from "./textures";

interface Moving { frame: Group; rest: Quaternion; place: Vector3; link: Link }

export class Robot {
  readonly group = new Group();
  private readonly moving: Moving[] = [];

  constructor(setting: Setting) {
    const frames = new Map<string, Group>([["", this.group]]);
    for (const link of setting.links) {
      const frame = new Group();
      frame.position.set(link.x, link.y, link.z);
      frame.rotation.set(link.roll, link.pitch, link.yaw, "ZYX");
      frame.add(body(link));
      (frames.get(link.parent) ?? this.group).add(frame);
      frames.set(link.name, frame);
      if (link.joint) {
        const [rest, place] = [frame.quaternion.clone(), frame.position.clone()];
        this.moving.push({ frame, rest, place, link });
      }
    }
    this.group.add(nose(setting));
  }

  show(moment: Moment): void {
    this.group.position.set(moment.x, moment.y, 0);
    this.group.rotation.z = moment.theta;
    for (const { frame, rest, place, link } of this.moving) {
      const axis = new Vector3(...link.joint!.axis);
      const value = moment.value(link.joint!.channel);
      if (link.joint!.motion === "turn") {
        frame.quaternion.copy(rest).multiply(new Quaternion().setFromAxisAngle(axis, value));
      } else {
        frame.position.copy(place).add(axis.applyQuaternion(rest).multiplyScalar(value));
      }
    }
  }
}

function body(link: Link): Mesh {
  const shape = link.geometry;
  const material = matt({ color: link.colour });
  let mesh: Mesh;
  if (shape.shape === "box") {
    mesh = new Mesh(new BoxGeometry(shape.x, shape.y, shape.z), material);
  } else {
    const upright = new CylinderGeometry(shape.radius, shape.radius, shape.length, 36);
    mesh = new Mesh(upright.rotateX(Math.PI / 2), material);
    if (link.surface !== "plain") {
      const tread = rollers(link.surface === "rollers_left" ? 1 : -1);
      const cap = matt({ color: link.colour });
      mesh.material = [matt({ map: tread }), cap, cap];
      mesh.add(hub(shape.radius, shape.length));
    }
  }
  mesh.castShadow = mesh.receiveShadow = true;
  return mesh;
}

/** Spokes, so that a turning wheel is seen to turn. */
function hub(radius: number, width: number): Group {
  const metal = matt({ color: "#d5d8dc" });
  const spokes = new Group();
  for (const turn of [0, 1, 2]) {
    const spoke = new Mesh(new BoxGeometry(1.5 * radius, 0.18 * radius, 1.04 * width), metal);
    spoke.rotation.z = (turn * Math.PI) / 3;
    spokes.add(spoke);
  }
  return spokes;
}

/** A bonnet that shows which end is the front. */
function nose({ footprint: [half, side], links }: Setting): Group {
  const first = links[0]?.geometry;
  const height = (links[0]?.z ?? 0) + (first?.shape === "box" ? first.z / 2 : 0);
  const top = new Group();
  top.position.z = height;
  const deck = new Mesh(
    new BoxGeometry(1.7 * half, 1.5 * side, 0.02),
    matt({ color: "#2b2f36" }),
  );
  deck.position.z = 0.01;
  const arrow = new Shape();
  arrow.moveTo(0.7 * half, 0);
  arrow.lineTo(0.25 * half, 0.5 * side);
  arrow.lineTo(0.25 * half, 0.17 * side);
  arrow.lineTo(-0.5 * half, 0.17 * side);
  arrow.lineTo(-0.5 * half, -0.17 * side);
  arrow.lineTo(0.25 * half, -0.17 * side);
  arrow.lineTo(0.25 * half, -0.5 * side);
  const sign = new Mesh(new ShapeGeometry(arrow), new MeshBasicMaterial({ color: "#f4efe4" }));
  sign.position.z = 0.023;
  const lamps = [0.62, -0.62].map((place) => {
    const lamp = new Mesh(
      new BoxGeometry(0.012, 0.22 * side, 0.03), new MeshBasicMaterial({ color: "#fff8d8" }),
    );
    lamp.position.set(half + 0.004, place * side, -0.03);
    return lamp;
  });
  deck.castShadow = true;
  top.add(deck, sign, ...lamps);
  return top;
}

/** N and N·m at which the published drawing clips, and the lengths in m that it draws there. */
const FULL = { force: 13.5, forceLength: 2.55, torque: 4.4, torqueLength: 1.275 };

/** Feedback at the hand as the thesis draws it: Fx green, Fy blue, resultant grey, torque upright. */
export class Forces {
  readonly group = new Group();
  private readonly x = new Arrow(FORCE_X, 0.022);
  private readonly y = new Arrow(FORCE_Y, 0.022);
  private readonly both = new Arrow(RESULTANT, 0.014);
  private readonly left = new Arrow(TORQUE_LEFT, 0.022);
  private readonly right = new Arrow(TORQUE_RIGHT, 0.022);

  constructor() {
    this.group.add(...[this.x, this.y, this.both, this.left, this.right].map((one) => one.group));
  }

  show(moment: Moment): void {
    const [fx, fy, tau] = ["fx", "fy", "tau"].map((name) => moment.value(name)) as [number, number, number];
    this.group.position.set(moment.x, moment.y, 0.32);
    this.group.rotation.z = moment.theta;
    this.x.point(new Vector3(reach(fx), 0, 0));
    this.y.point(new Vector3(0, reach(fy), 0));
    this.both.point(new Vector3(reach(fx), reach(fy), 0), Math.abs(fx * fy) > 1e-6);
    const high = (Math.min(Math.abs(tau), FULL.torque) / FULL.torque) * FULL.torqueLength;
    this.left.point(new Vector3(0, 0, tau > 0 ? high : 0));
    this.right.point(new Vector3(0, 0, tau < 0 ? high : 0));
  }
}

function reach(force: number): number {
  return (Math.max(-FULL.force, Math.min(FULL.force, force)) / FULL.force) * FULL.forceLength;
}

class Arrow {
  readonly group = new Group();
  private readonly shaft: Mesh;
  private readonly head: Mesh;

  constructor(colour: string, private readonly thickness: number) {
    const material = new MeshBasicMaterial({ color: colour, depthTest: false, transparent: true });
    this.shaft = new Mesh(new CylinderGeometry(thickness, thickness, 1, 12), material);
    this.head = new Mesh(new CylinderGeometry(0, 2.6 * thickness, 6 * thickness, 16), material);
    this.shaft.renderOrder = this.head.renderOrder = 5;
    this.group.add(this.shaft, this.head);
  }

  point(to: Vector3, wanted = true): void {
    const length = to.length();
    this.group.visible = wanted && length > 0.01;
    if (!this.group.visible) return;
    const head = Math.min(6 * this.thickness, length);
    this.group.quaternion.setFromUnitVectors(new Vector3(0, 1, 0), to.clone().normalize());
    this.shaft.scale.set(1, Math.max(length - head, 1e-3), 1);
    this.shaft.position.y = (length - head) / 2;
    this.head.scale.setScalar(head / (6 * this.thickness));
    this.head.position.y = length - head / 2;
  }
}

const TRAIL_WIDTH = 0.035;

/** The way gone, as a ribbon on the floor. */
export class Trail {
  readonly mesh: Mesh;
  private readonly places: Float32BufferAttribute;
  private length = 0;
  private last: [number, number] | null = null;

  constructor(private readonly capacity: number) {
    const geometry = new BufferGeometry();
    this.places = new Float32BufferAttribute(new Float32Array(capacity * 18), 3);
    this.places.setUsage(DynamicDrawUsage);
    geometry.setAttribute("position", this.places);
    geometry.setDrawRange(0, 0);
    const material = new MeshBasicMaterial({ color: TRAIL, transparent: true, opacity: 0.85 });
    this.mesh = new Mesh(geometry, material);
    this.mesh.position.z = 0.006;
    this.mesh.frustumCulled = false;
  }

  /** Go on to a place; the ribbon ends when its capacity is used up. */
  add(x: number, y: number): void {
    if (this.last && this.length < this.capacity) {
      const [px, py] = this.last;
      const long = Math.hypot(x - px, y - py) || 1;
      const [nx, ny] = [(-(y - py) / long) * TRAIL_WIDTH * 0.5, ((x - px) / long) * TRAIL_WIDTH * 0.5];
      const at = 6 * this.length;
      this.places.setXYZ(at, px + nx, py + ny, 0).setXYZ(at + 1, px - nx, py - ny, 0);
      this.places.setXYZ(at + 2, x - nx, y - ny, 0).setXYZ(at + 3, px + nx, py + ny, 0);
      this.places.setXYZ(at + 4, x - nx, y - ny, 0).setXYZ(at + 5, x + nx, y + ny, 0);
      this.length += 1;
      this.places.needsUpdate = true;
      this.reveal(this.length);
    }
    this.last = [x, y];
  }

  /** Show the first pieces only. */
  reveal(pieces: number): void {
    this.mesh.geometry.setDrawRange(0, 6 * Math.max(0, Math.min(pieces, this.length)));
  }
}
