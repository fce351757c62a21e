// SPDX-License-Identifier: MIT
// Camera, light and ground; draws only when something changed.
import {
  type Box3,
  DirectionalLight,
  HemisphereLight,
  Mesh,
  type Object3D,
  PCFShadowMap,
  PerspectiveCamera,
  PlaneGeometry,
  type Ray,
  Raycaster,
  Scene,
  ShadowMaterial,
  Spherical,
  Vector2,
  Vector3,
  WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import type { Camera } from "../design/camera.ts";
import { clearStandpoint, type Subject } from "./clearance.ts";
import { DIRECTIONS, pixelSlope, type Standpoint, sightOf, type ViewName } from "./framing.ts";
import { Glide } from "./glide.ts";
import {
  CLIP,
  changeLens,
  clip,
  isParallel,
  parallelDirection,
  stretchOf,
  WIDE,
  withWideLens,
} from "./lens.ts";
import type { Palette } from "./palette.ts";
import type { Box } from "./picking.ts";
import { Pivot } from "./pivot.ts";

/** Milliseconds: a slower frame leaves shadows out while something moves. */
const QUICK = 8;
/** Milliseconds without a change after which they are cast again. */
const REST = 160;
/** Pixels at the top of the view that the drag tools cover. */
const TOOLS = 52;

const toolsIn = (height: number): number => Math.min(TOOLS, height / 5);

export interface DrawingSteps {
  /** `pixel`: the display units that one spans where the camera looks. */
  before(pixel: number): void;
  after(): void;
}

/** Draws over the picture once it rests. */
export interface Finish {
  draw(renderer: WebGLRenderer): void;
  dispose(): void;
}

export class Stage {
  readonly scene = new Scene();
  readonly camera = new PerspectiveCamera(WIDE, 1, CLIP.near, CLIP.far);
  readonly orbit: OrbitControls;
  readonly renderer: WebGLRenderer;
  /** What is there for the hand: arrows, the line of the reach. */
  readonly aids = new Set<Object3D>();
  readonly ground = new Mesh(new PlaneGeometry(80, 80), new ShadowMaterial());
  readonly #key = new DirectionalLight("#FFF9F0", 2.15);
  readonly #sky = new HemisphereLight("#FFFFFF", "#D9D2C3", 1.5);
  readonly #glide: Glide;
  readonly #pivot: Pivot;
  readonly #caster = new Raycaster();
  readonly #steps: DrawingSteps;
  #paper = "#FFFFFF";
  #size = "";
  #pending = 0;
  #drawMilliseconds = 0;
  #shadowTimer: ReturnType<typeof setTimeout> | undefined;
  #restTimer: ReturnType<typeof setTimeout> | undefined;
  #stillTimer: ReturnType<typeof setTimeout> | undefined;
  #expected = 0;
  #finish: Finish | null = null;
  readonly #drawn = new Set<() => void>();
  #target: Object3D | null = null;

  constructor(canvas: HTMLCanvasElement, steps: DrawingSteps) {
    this.#steps = steps;
    this.renderer = new WebGLRenderer({
      canvas,
      antialias: true,
      powerPreference: "high-performance",
    });
    // Asking after each program stops the page until the graphics card has caught up.
    this.renderer.debug.checkShaderErrors = import.meta.env.DEV;
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.renderer.shadowMap.autoUpdate = false;
    this.camera.up.set(0, 0, 1);
    this.orbit = new OrbitControls(this.camera, canvas);
    this.orbit.enableDamping = false;
    this.orbit.zoomToCursor = true;
    this.orbit.addEventListener("change", () => this.invalidate());
    this.#glide = new Glide(this.camera, this.orbit);
    this.#pivot = new Pivot(this.camera, this.orbit);
    this.#lightUp();
    // Comes after the renderer's own listener, which makes its state and buffers again, but plain black.
    canvas.addEventListener("webglcontextrestored", () => {
      this.renderer.setClearColor(this.#paper);
      this.castShadows();
    });
  }

  #lightUp(): void {
    const { shadow } = this.#key;
    this.#key.position.set(-9, -3.5, 11);
    this.#key.castShadow = true;
    shadow.mapSize.set(1024, 1024);
    shadow.radius = 4;
    shadow.bias = -0.008;
    Object.assign(shadow.camera, { left: -8, right: 8, top: 8, bottom: -8, near: 1, far: 40 });
    this.ground.receiveShadow = true;
    this.scene.add(this.#sky, this.#key, this.ground);
  }

  setPalette(palette: Palette): void {
    this.#paper = palette.paper;
    this.renderer.setClearColor(this.#paper);
    this.#sky.color.set(palette.sky);
    this.#sky.groundColor.set(palette.ground);
    this.ground.material.opacity = palette.shadow;
    this.invalidate();
  }

  /** What the camera looks at; the ground lies just under it. */
  setSubject(subject: Object3D, bounds: Box3): void {
    if (this.#target) this.scene.remove(this.#target);
    this.#target = subject;
    this.scene.add(subject);
    this.ground.position.z = bounds.min.z - 0.05;
    this.renderer.shadowMap.needsUpdate = true;
  }

  /**
   * A named view that just holds the subject, clear of the boxes that lie over the view; `at once`
   * on opening, else with a short glide.
   */
  view(name: ViewName, subject: Subject, over: readonly Box[], atOnce: boolean): void {
    const towards = new Vector3(...DIRECTIONS[name]).normalize();
    this.#glide.stop();
    changeLens(this.camera, this.orbit.target, isParallel(name));
    const place = this.#standpoint(subject, towards, over);
    if (atOnce) this.#glide.jump(place);
    else this.#glide.to(place);
    this.invalidate();
  }

  /** Moves the camera, without turning it, to where it just holds the subject, as view() does. */
  fit(subject: Subject, over: readonly Box[]): void {
    const towards = this.camera.getWorldDirection(new Vector3()).negate();
    this.#glide.to(this.#standpoint(subject, towards, over));
    this.invalidate();
  }

  #standpoint(subject: Subject, towards: Vector3, over: readonly Box[]): Standpoint {
    const sight = sightOf(this.camera, towards);
    return clearStandpoint(subject, sight, toolsIn(sight.height), over);
  }

  /** Display units that a pixel spans where the camera looks. */
  pixel(): number {
    return pixelSlope(this.camera) * this.camera.position.distanceTo(this.orbit.target);
  }

  /** The ray through a place on screen, −1 … 1 to the right and upwards. */
  rayThrough(x: number, y: number): Ray {
    this.#caster.setFromCamera(new Vector2(x, y), this.camera);
    return this.#caster.ray.clone();
  }

  /** Where the camera is, or would be in perspective, and what it looks at. */
  read(): Camera {
    const { position, target } = withWideLens(this.camera, this.orbit.target);
    return { position: position.toArray(), target: target.toArray() };
  }

  /** Along the axes of Top, Front and Side the view is in parallel, as it was when it was read. */
  place({ position, target }: Camera): void {
    const wide = { position: new Vector3(...position), target: new Vector3(...target) };
    const towards = parallelDirection(wide);
    this.#glide.stop();
    changeLens(this.camera, this.orbit.target, towards !== null);
    const arm = wide.position.clone().sub(wide.target);
    if (towards) arm.copy(towards).setLength(wide.position.distanceTo(wide.target));
    const far = arm.multiplyScalar(stretchOf(this.camera)).add(wide.target);
    this.#glide.jump({ position: far, target: wide.target });
    this.invalidate();
  }

  glideTo(place: Standpoint): void {
    this.#glide.to(place);
    this.invalidate();
  }

  /**
   * The distance that zooming counts from becomes that of a point: it is approached by a share of
   * the way, however far away it is. The picture stays.
   */
  aim(point: Vector3): void {
    const forward = this.camera.getWorldDirection(new Vector3());
    const away = point.clone().sub(this.camera.position).dot(forward);
    if (away > 0) this.orbit.target.copy(this.camera.position).addScaledVector(forward, away);
  }

  /** What the pointer's next turn is about; null for what the camera looks at. */
  turnAbout(point: Vector3 | null): void {
    if (point) this.aim(point);
    this.#pivot.set(point);
  }

  /** Turns about a point, or about what the camera looks at; radians. */
  turn(right: number, down: number, about: Vector3 | null): void {
    this.#glide.stop();
    this.turnAbout(about);
    const arm = this.camera.position.clone().sub(this.orbit.target);
    const spherical = new Spherical().setFromVector3(new Vector3(arm.x, arm.z, -arm.y));
    spherical.theta -= right;
    spherical.phi -= down;
    spherical.makeSafe();
    const turned = new Vector3().setFromSpherical(spherical);
    this.camera.position.copy(this.orbit.target).add(new Vector3(turned.x, -turned.z, turned.y));
    this.orbit.update();
    this.turnAbout(null);
    this.invalidate();
  }

  zoom(factor: number): void {
    this.camera.position.sub(this.orbit.target).multiplyScalar(factor).add(this.orbit.target);
    this.orbit.update();
    this.invalidate();
  }

  resize(width: number, height: number): void {
    if (width === 0 || height === 0) return;
    const ratio = Math.min(window.devicePixelRatio, 2);
    const size = `${width} × ${height} × ${ratio}`;
    // To set a size that is set would still wait for the graphics card.
    if (size === this.#size) return;
    this.#size = size;
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    // The axis goes through the middle of what the tools leave free.
    const down = toolsIn(height) / 2;
    this.camera.setViewOffset(width, height, 0, -down, width, height);
    // A canvas of a new size is blank: not even one frame may show it.
    cancelAnimationFrame(this.#pending);
    this.draw();
  }

  /** The geometry changed. Shadows follow at once if drawing is quick, else when it rests. */
  moved(): void {
    clearTimeout(this.#shadowTimer);
    if (this.#drawMilliseconds < QUICK) this.renderer.shadowMap.needsUpdate = true;
    else this.#shadowTimer = setTimeout(() => this.castShadows(), REST);
    this.invalidate();
  }

  castShadows(): void {
    this.renderer.shadowMap.needsUpdate = true;
    this.invalidate();
  }

  invalidate(): void {
    if (this.#pending !== 0) return;
    this.#pending = requestAnimationFrame(() => this.draw());
    this.#stir();
  }

  /** The canvas says whether its picture still changes: shadows and the finish come last. */
  #stir(): void {
    const { dataset } = this.renderer.domElement;
    dataset.still = "false";
    clearTimeout(this.#stillTimer);
    this.#stillTimer = setTimeout(() => {
      dataset.still = `${this.#pending === 0 && this.#expected === 0}`;
    }, 2 * REST);
  }

  /** What is fetched to be drawn: until then the picture still changes. */
  async expecting<T>(part: Promise<T>): Promise<T> {
    this.#expected += 1;
    this.#stir();
    try {
      return await part;
    } finally {
      this.#expected -= 1;
      this.#stir();
    }
  }

  draw(): void {
    this.#pending = 0;
    this.#stir();
    const begin = performance.now();
    clip(this.camera, this.orbit.target);
    this.#steps.before(this.pixel());
    this.renderer.render(this.scene, this.camera);
    this.#drawMilliseconds = performance.now() - begin;
    this.#steps.after();
    for (const drawn of this.#drawn) drawn();
    clearTimeout(this.#restTimer);
    if (this.#finish) this.#restTimer = setTimeout(() => this.drawFinished(), REST);
  }

  /** Calls `drawn` after every picture. Returns how to stop. */
  onDrawn(drawn: () => void): () => void {
    this.#drawn.add(drawn);
    return () => this.#drawn.delete(drawn);
  }

  /** Draws the view as it is at rest. */
  drawFinished(): void {
    this.draw();
    clearTimeout(this.#restTimer);
    this.#finish?.draw(this.renderer);
  }

  /** Draws the view at rest, without what is there for the hand: a picture that is kept. */
  drawClean(): void {
    const shown = [...this.aids].filter(({ visible }) => visible);
    for (const aid of shown) aid.visible = false;
    this.drawFinished();
    for (const aid of shown) aid.visible = true;
    this.invalidate();
  }

  /** null for nothing. */
  finishBy(finish: Finish | null): void {
    if (!finish && !this.#finish) return;
    this.#finish?.dispose();
    this.#finish = finish;
    this.invalidate();
  }

  dispose(): void {
    cancelAnimationFrame(this.#pending);
    this.#glide.stop();
    clearTimeout(this.#shadowTimer);
    clearTimeout(this.#restTimer);
    clearTimeout(this.#stillTimer);
    this.#finish?.dispose();
    this.#finish = null;
    this.orbit.dispose();
    this.renderer.dispose();
  }
}
