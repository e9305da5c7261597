/** One canvas: a world, a robot in it, light, and a camera. */

import {
  CircleGeometry, Color, ConeGeometry, CylinderGeometry, DirectionalLight, Fog, Group,
  BasicShadowMap, HemisphereLight, Mesh, MeshBasicMaterial, Object3D, OrthographicCamera, PCFShadowMap,
  PerspectiveCamera, Scene, Vector3, WebGLRenderer, ACESFilmicToneMapping, type Camera,
} from "three";
import { COLLISION } from "./colours";
import type { Moment, Setting } from "./film";
import { Forces, Robot, Trail } from "./robot";
import { signOver } from "./signs";
import { sharpen } from "./textures";
import { World } from "./world";

export type View = "follow" | "plan" | "first";
export const VIEWS: View[] = ["follow", "plan", "first"];
export const VIEW_NAMES: { [view in View]: string } = { follow: "Follow", plan: "Plan", first: "First person" };

/** What a person at the robot sees: places in m, the angle from below to above in rad. */
export interface Eye { height: number; ahead: number; field_of_view: number }
export const EYE: Eye = { height: 0.75, ahead: -0.1, field_of_view: 1.22 };

const LIT = 8;
/** m to each side of the robot that have shadows, where the world is larger than that. */
const SKY = "#dfe7ee";
const FOG_BEGINS = 14;
const FOG_ENDS = 45;
Object3D.DEFAULT_UP.set(0, 0, 1);

export class NoWebGL extends Error {}

export class Stage {
  readonly forces = new Forces();
  readonly trail: Trail;
  view: View = "follow";
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly world: World;
  private readonly robot: Robot;
  private readonly sun = new DirectionalLight("#fff1d6", 2.0);
  private readonly perspective = new PerspectiveCamera(50, 1, 0.05, 80);
  private readonly plan = new OrthographicCamera(-1, 1, 1, -1, 0.1, 60);
  private readonly cue = beacon();
  private readonly robotFrame = new Group();
  private readonly visitor = new Group();
  private lit = "";
  private fitted = "";
  private ready = false;
  private redraw = (): void => undefined;
  private readonly fog = new Fog(SKY, FOG_BEGINS, FOG_ENDS);

  constructor(
    private readonly canvas: HTMLCanvasElement, setting: Setting, capacity: number,
    fine: boolean, private readonly eye: Eye = EYE,
  ) {
    const careful = fine || !drawnInSoftware();
    this.renderer = rendererOn(canvas, careful);
    sharpen(careful ? 4 : 1);
    this.world = new World(setting.scene);
    this.robot = new Robot(setting);
    this.trail = new Trail(capacity);
    this.scene.fog = this.fog;
    this.scene.background = new Color(SKY);
    this.scene.add(new HemisphereLight("#f6f9ff", "#d8cfbe", 2.3), this.sun, this.sun.target);
    this.scene.add(
      this.world.group, this.robot.group, this.forces.group, this.trail.mesh, this.cue,
      this.robotFrame, this.visitor,
    );
    this.sun.castShadow = true;
    this.renderer.shadowMap.autoUpdate = false;
    this.sun.shadow.mapSize.setScalar(careful ? 2048 : 1024);
    this.sun.shadow.bias = -0.0006;
    this.sun.shadow.normalBias = 0.01;
    new ResizeObserver(() => this.fit()).observe(canvas);
  }

  /** Let the graphics driver make ready what it draws with, without holding up the page. */
  async prepare(): Promise<void> {
    this.fit(); // while the driver is idle: later it would have to be waited for
    await this.renderer.compileAsync(this.scene, this.perspective);
    this.ready = true;
    this.redraw();
  }

  /** Mark places of collisions on the floor. */
  mark(places: [number, number][]): void {
    const material = new MeshBasicMaterial({ color: COLLISION });
    for (const [x, y] of places) {
      const dot = new Mesh(new CircleGeometry(0.06, 20), material);
      dot.position.set(x, y, 0.009);
      this.scene.add(dot);
    }
  }

  /** Put up signs with what blocks are called. */
  sign(words: { [block: string]: string }): void {
    for (const [name, word] of Object.entries(words)) {
      const block = this.world.block(name);
      if (block) this.scene.add(signOver(block, word));
    }
  }

  /** Take the canvas back from a stage that is not needed any more. */
  close(): void {
    this.renderer.dispose();
  }

  /** Put everything where it is at an instant, and draw, once that is possible; tells whether it was.
   * `heading` is where the camera looks. */
  draw(moment: Moment, target: string | null, heading = moment.theta): boolean {
    this.redraw = () => void this.draw(moment, target, heading);
    if (!this.ready) return false;
    this.robot.group.visible = this.view !== "first";
    const moved = this.world.show(moment) || this.robot.group.visible;
    this.robot.show(moment);
    this.forces.show(moment);
    this.robotFrame.position.set(moment.x, moment.y, 0);
    this.robotFrame.rotation.z = moment.theta;
    this.pointTo(target, moment.t);
    this.fog.far = this.view === "plan" ? 1e6 : FOG_ENDS;
    this.fog.near = this.view === "plan" ? 1e5 : FOG_BEGINS;
    const relit = this.light(moment);
    this.renderer.shadowMap.needsUpdate = moved || relit;
    this.renderer.render(this.scene, this.aim(moment, heading));
    return true;
  }

  /** Hang something of one's own on the robot. */
  onRobot(thing: Object3D): void {
    this.robotFrame.add(thing);
  }

  /** Draw for a headset from now on, each picture after `frame` was called with its time in ms. */
  async immerse(session: XRSession, frame: (now: number) => void): Promise<void> {
    const { xr } = this.renderer;
    xr.enabled = true;
    xr.setReferenceSpaceType("local-floor");
    this.renderer.setAnimationLoop(frame);
    await xr.setSession(session);
    this.visitor.add(this.perspective);
  }

  /** Draw for the screen again. */
  comeBack(): void {
    this.renderer.setAnimationLoop(null);
    this.renderer.xr.enabled = false;
    this.perspective.removeFromParent();
    this.fitted = "";
    this.fit();
    this.redraw();
  }

  /** Say how fast drawing must be: a slow machine gets fewer pixels. */
  coarsen(ratio: number): void {
    this.renderer.setPixelRatio(ratio);
    this.fit();
  }

  private aim(moment: Moment, heading: number): Camera {
    const { x, y } = moment;
    const [c, s] = [Math.cos(heading), Math.sin(heading)];
    const camera = this.perspective;
    if (this.renderer.xr.isPresenting) return this.stand(moment, heading);
    if (this.view === "plan") return this.plan;
    if (this.view === "first") {
      const [cc, ss] = [Math.cos(moment.theta), Math.sin(moment.theta)];
      camera.fov = (this.eye.field_of_view * 180) / Math.PI;
      camera.position.set(x + this.eye.ahead * cc, y + this.eye.ahead * ss, this.eye.height);
      camera.lookAt(x + 3 * cc, y + 3 * ss, 0.35);
    } else {
      camera.fov = 50;
      camera.position.set(x - 1.55 * c, y - 1.55 * s, 1.95);
      camera.lookAt(x + 0.5 * c, y + 0.5 * s, 0.12);
    }
    camera.updateProjectionMatrix();
    return camera;
  }

  /** Put a person with a headset, whose y points up, where the camera would be; the head is theirs. */
  private stand({ x, y }: Moment, heading: number): Camera {
    const behind = this.view === "first" ? -this.eye.ahead : 1.55;
    this.visitor.position.set(x - behind * Math.cos(heading), y - behind * Math.sin(heading), 0);
    this.visitor.rotation.set(Math.PI / 2, 0, heading - Math.PI / 2, "ZXY");
    this.visitor.updateMatrixWorld();
    return this.perspective;
  }

  /** Shine on what is looked at; tells whether the light is another than before. */
  private light({ x, y }: Moment): boolean {
    const { west, east, south, north } = this.world.extent;
    const size = Math.max(east - west, north - south) / 2 + 1;
    const whole = this.view === "plan" || size < LIT;
    const middle = whole ? [(west + east) / 2, (south + north) / 2] : [x, y].map(Math.round);
    const half = whole ? size : LIT;
    const lit = `${this.view} ${middle.join(" ")}`;
    if (lit === this.lit) return false;
    this.lit = lit;
    this.sun.target.position.set(middle[0]!, middle[1]!, 0);
    const lean = this.view === "plan" ? 0.3 : 1;
    this.sun.position.set(middle[0]! - 3 * lean, middle[1]! - 4.5 * lean, 11);
    const camera = this.sun.shadow.camera;
    if (camera.right !== half) {
      camera.left = camera.bottom = -half;
      camera.right = camera.top = half;
      camera.far = 60;
      camera.updateProjectionMatrix();
    }
    return true;
  }

  private pointTo(target: string | null, t: number): void {
    const block = target === null ? undefined : this.world.block(target);
    this.cue.visible = block !== undefined;
    if (!block) return;
    this.cue.position.set(block.position.x, block.position.y, 0);
    this.cue.children[0]!.position.z = 1.15 + 0.07 * Math.sin(3 * t);
    const tint = (block.material as MeshBasicMaterial).color;
    for (const part of this.cue.children) ((part as Mesh).material as MeshBasicMaterial).color.copy(tint);
  }

  private fit(): void {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    const size = `${width} ${height} ${this.renderer.getPixelRatio()}`;
    if (!width || !height || size === this.fitted || this.renderer.xr.isPresenting) return;
    this.fitted = size;
    this.renderer.setSize(width, height, false);
    this.perspective.aspect = width / height;
    const { west, east, south, north } = this.world.extent;
    const half = Math.max((north - south) / 2 + 0.5, ((east - west) / 2 + 0.5) / (width / height));
    this.plan.top = half;
    this.plan.bottom = -half;
    this.plan.right = (half * width) / height;
    this.plan.left = -this.plan.right;
    const middle = new Vector3((west + east) / 2, (south + north) / 2, 0);
    this.plan.position.copy(middle).setZ(30);
    this.plan.up.set(0, 1, 0);
    this.plan.lookAt(middle);
    this.plan.updateProjectionMatrix();
  }
}

let software: boolean | undefined;

/** Whether there is no graphics card to draw with, so that every pixel counts. */
function drawnInSoftware(): boolean {
  software ??= /swiftshader|llvmpipe|software/i.test(rendererName());
  return software;
}

function rendererName(): string {
  const gl = document.createElement("canvas").getContext("webgl2");
  const told = gl?.getExtension("WEBGL_debug_renderer_info");
  const name = gl && told ? String(gl.getParameter(told.UNMASKED_RENDERER_WEBGL)) : "";
  gl?.getExtension("WEBGL_lose_context")?.loseContext();
  return name;
}

function rendererOn(canvas: HTMLCanvasElement, fine: boolean): WebGLRenderer {
  let renderer: WebGLRenderer;
  try {
    renderer = new WebGLRenderer({ canvas, antialias: fine, preserveDrawingBuffer: true });
  } catch (cause) {
    throw new NoWebGL("no WebGL", { cause });
  }
  renderer.setPixelRatio(fine ? Math.min(window.devicePixelRatio, 2) : 0.75);
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.type = fine ? PCFShadowMap : BasicShadowMap;
  renderer.toneMapping = ACESFilmicToneMapping;
  renderer.toneMappingExposure = 0.95;
  return renderer;
}

/** What hangs over the block to be reached: a pointer and a column of light. */
function beacon(): Group {
  const group = new Group();
  const cone = new Mesh(new ConeGeometry(0.14, 0.3, 24), new MeshBasicMaterial());
  cone.rotation.x = -Math.PI / 2;
  const column = new Mesh(
    new CylinderGeometry(0.17, 0.17, 1.0, 32, 1, true),
    new MeshBasicMaterial({ transparent: true, opacity: 0.22, depthWrite: false }),
  );
  column.rotation.x = Math.PI / 2;
  column.position.z = 0.5;
  group.add(cone, column);
  return group;
}
