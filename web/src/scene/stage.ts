// SPDX-License-Identifier: MIT
// Camera, light and ground; draws only when something changed.
import {
  Box3,
  DirectionalLight,
  HemisphereLight,
  Mesh,
  type Object3D,
  PCFShadowMap,
  PerspectiveCamera,
  PlaneGeometry,
  Scene,
  ShadowMaterial,
  Spherical,
  Vector3,
  WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import type { Palette } from "./palette.ts";

export type ViewName = "3D" | "Top" | "Front" | "Side";

const DIRECTIONS: Readonly<Record<ViewName, readonly [number, number, number]>> = {
  "3D": [-0.52, -0.92, 0.62],
  Top: [0, -0.001, 1],
  Front: [0, -1, 0],
  Side: [1, 0, 0],
};

/** Milliseconds: a slower frame leaves shadows out while something moves. */
const QUICK = 8;
/** Milliseconds without a change after which they are cast again. */
const REST = 160;

/** Share of the view that a fitted subject fills. */
const FILL = 0.86;

/** How far from `centre` a camera that looks at it must stand to see every point. */
function fittingDistance(points: Float32Array, centre: Vector3, camera: PerspectiveCamera): number {
  const right = new Vector3();
  const up = new Vector3();
  const towards = new Vector3();
  camera.matrixWorld.extractBasis(right, up, towards);
  const tangent = Math.tan((camera.fov * Math.PI) / 360) * FILL;
  const point = new Vector3();
  let distance = 1;
  for (let v = 0; v < points.length / 3; ++v) {
    point.fromArray(points, 3 * v).sub(centre);
    const across = Math.abs(point.dot(right)) / (tangent * camera.aspect);
    const high = Math.abs(point.dot(up)) / tangent;
    distance = Math.max(distance, Math.max(across, high) + point.dot(towards));
  }
  return distance;
}

export class Stage {
  readonly scene = new Scene();
  readonly camera = new PerspectiveCamera(28, 1, 0.1, 400);
  readonly orbit: OrbitControls;
  readonly renderer: WebGLRenderer;
  readonly #ground = new Mesh(new PlaneGeometry(80, 80), new ShadowMaterial());
  readonly #key = new DirectionalLight("#FFF9F0", 1.75);
  readonly #sky = new HemisphereLight("#FFFFFF", "#D9D2C3", 1.75);
  readonly #onDraw: () => void;
  #pending = 0;
  #drawMilliseconds = 0;
  #shadowTimer: ReturnType<typeof setTimeout> | undefined;
  #target: Object3D | null = null;

  constructor(canvas: HTMLCanvasElement, onDraw: () => void) {
    this.#onDraw = onDraw;
    this.renderer = new WebGLRenderer({
      canvas,
      antialias: true,
      powerPreference: "high-performance",
    });
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.renderer.shadowMap.autoUpdate = false;
    this.camera.up.set(0, 0, 1);
    this.orbit = new OrbitControls(this.camera, canvas);
    this.orbit.enableDamping = false;
    this.orbit.addEventListener("change", () => this.invalidate());
    this.#lightUp();
  }

  #lightUp(): void {
    const { shadow } = this.#key;
    this.#key.position.set(-9, -3.5, 11);
    this.#key.castShadow = true;
    shadow.mapSize.set(1024, 1024);
    shadow.radius = 4;
    shadow.bias = -0.008;
    Object.assign(shadow.camera, { left: -8, right: 8, top: 8, bottom: -8, near: 1, far: 40 });
    this.#ground.receiveShadow = true;
    this.scene.add(this.#sky, this.#key, this.#ground);
  }

  setPalette(palette: Palette): void {
    this.renderer.setClearColor(palette.paper);
    this.#sky.color.set(palette.sky);
    this.#sky.groundColor.set(palette.ground);
    this.#ground.material.opacity = palette.shadow;
    this.invalidate();
  }

  /** What the camera looks at; the ground lies just under it. */
  setSubject(subject: Object3D, bounds: Box3): void {
    if (this.#target) this.scene.remove(this.#target);
    this.#target = subject;
    this.scene.add(subject);
    this.#ground.position.z = bounds.min.z - 0.05;
    this.renderer.shadowMap.needsUpdate = true;
  }

  /** Moves the camera to a named view that just holds `points`. */
  view(name: ViewName, points: Float32Array): void {
    const centre = new Box3().setFromArray(points).getCenter(new Vector3());
    const towards = new Vector3(...DIRECTIONS[name]).normalize();
    this.camera.position.copy(centre).add(towards);
    this.camera.lookAt(centre);
    this.camera.updateMatrixWorld();
    const distance = fittingDistance(points, centre, this.camera);
    this.orbit.target.copy(centre);
    this.camera.position.copy(centre).addScaledVector(towards, distance);
    this.orbit.update();
    this.invalidate();
  }

  /** Brings a few points to the middle, near enough to judge them, without turning the view. */
  lookAt(points: Float32Array): void {
    const box = new Box3().setFromArray(points);
    const centre = box.getCenter(new Vector3());
    const arm = this.camera.position.clone().sub(this.orbit.target);
    const near = 7 * box.getSize(new Vector3()).length();
    this.orbit.target.copy(centre);
    this.camera.position.copy(centre).add(arm.setLength(Math.min(arm.length(), near)));
    this.orbit.update();
    this.invalidate();
  }

  /** Turns about the target, radians. */
  turn(right: number, down: number): void {
    const arm = this.camera.position.clone().sub(this.orbit.target);
    const spherical = new Spherical().setFromVector3(new Vector3(arm.x, arm.z, -arm.y));
    spherical.theta -= right;
    spherical.phi -= down;
    spherical.makeSafe();
    const turned = new Vector3().setFromSpherical(spherical);
    this.camera.position.copy(this.orbit.target).add(new Vector3(turned.x, -turned.z, turned.y));
    this.orbit.update();
    this.invalidate();
  }

  zoom(factor: number): void {
    this.camera.position.sub(this.orbit.target).multiplyScalar(factor).add(this.orbit.target);
    this.orbit.update();
    this.invalidate();
  }

  resize(width: number, height: number): void {
    if (width === 0 || height === 0) return;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.invalidate();
  }

  /** The geometry changed. Shadows follow at once if drawing is quick, else when it rests. */
  moved(): void {
    clearTimeout(this.#shadowTimer);
    if (this.#drawMilliseconds < QUICK) this.renderer.shadowMap.needsUpdate = true;
    else this.#shadowTimer = setTimeout(() => this.#castShadows(), REST);
    this.invalidate();
  }

  #castShadows(): void {
    this.renderer.shadowMap.needsUpdate = true;
    this.invalidate();
  }

  invalidate(): void {
    if (this.#pending === 0) this.#pending = requestAnimationFrame(() => this.draw());
  }

  draw(): void {
    this.#pending = 0;
    const begin = performance.now();
    this.renderer.render(this.scene, this.camera);
    this.#drawMilliseconds = performance.now() - begin;
    this.#onDraw();
  }

  dispose(): void {
    cancelAnimationFrame(this.#pending);
    clearTimeout(this.#shadowTimer);
    this.orbit.dispose();
    this.renderer.dispose();
  }
}
