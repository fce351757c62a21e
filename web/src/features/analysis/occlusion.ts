// SPDX-License-Identifier: MIT
// Ambient occlusion: where the sky does not reach, under a vault or between ribs, the picture at rest
// gets darker, and so does the ground under it. Of three.js's pass only the figure is taken; it is
// multiplied onto the finished picture, whose colours and smooth edges stay.
import {
  AddEquation,
  type BufferGeometry,
  CustomBlending,
  DoubleSide,
  DstColorFactor,
  type Material,
  Mesh,
  NoBlending,
  type PerspectiveCamera,
  Scene,
  ShaderMaterial,
  Vector2,
  type WebGLRenderer,
  ZeroFactor,
} from "three";
import { GTAOPass } from "three/addons/postprocessing/GTAOPass.js";
import { FullScreenQuad } from "three/addons/postprocessing/Pass.js";
import { FLAT_NORMAL, VIEW_VERTEX } from "./view-shader.ts";

/** Display units, of which a structure is about ten long: how far away something still covers. */
const RADIUS = 2.5;
/** Of 1: how dark what sees no sky gets. */
const DEPTH = 0.5;

const VERTEX = `
varying vec2 vAt;
void main() {
  vAt = uv;
  gl_Position = vec4(position.xy, 0.0, 1.0);
}`;

const FRAGMENT = `
uniform sampler2D figure;
uniform float depth;
varying vec2 vAt;
void main() {
  gl_FragColor = vec4(vec3(mix(1.0, texture2D(figure, vAt).r, depth)), 1.0);
}`;

const NORMAL_FRAGMENT = `
varying vec3 vView;
#include <clipping_planes_pars_fragment>
${FLAT_NORMAL}
void main() {
  #include <clipping_planes_fragment>
  gl_FragColor = vec4(flatNormal() * 0.5 + 0.5, 1.0);
}`;

/** Normals of flat panels as colours; three.js's own shader for them is left out of the build. */
const normals = (): ShaderMaterial =>
  new ShaderMaterial({
    vertexShader: VIEW_VERTEX,
    fragmentShader: NORMAL_FRAGMENT,
    side: DoubleSide,
    blending: NoBlending,
    clipping: true,
  });

const multiplied = (): ShaderMaterial =>
  new ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    uniforms: { figure: { value: null }, depth: { value: DEPTH } },
    depthTest: false,
    depthWrite: false,
    blending: CustomBlending,
    blendEquation: AddEquation,
    blendSrc: DstColorFactor,
    blendDst: ZeroFactor,
  });

export class Occlusion {
  readonly #scene = new Scene();
  readonly #pass: GTAOPass;
  readonly #quad: FullScreenQuad;
  readonly #material = multiplied();
  readonly #normals = normals();
  readonly #panels: Mesh<BufferGeometry, Material>;
  readonly #under: Mesh;
  readonly #ground: Mesh;

  /** `panels` and `ground`: those of the picture. */
  constructor(panels: Mesh<BufferGeometry, Material>, ground: Mesh, camera: PerspectiveCamera) {
    this.#panels = panels;
    this.#under = ground;
    this.#ground = new Mesh(ground.geometry);
    const shell = new Mesh(panels.geometry);
    shell.frustumCulled = false;
    this.#scene.add(shell, this.#ground);
    this.#pass = new GTAOPass(this.#scene, camera, 1, 1);
    this.#pass.normalMaterial.dispose();
    Object.assign(this.#pass, { normalMaterial: this.#normals });
    this.#pass.output = GTAOPass.OUTPUT.Off;
    this.#pass.updateGtaoMaterial({ radius: RADIUS, scale: 1, thickness: 4 });
    this.#quad = new FullScreenQuad(this.#material);
  }

  /** Draws the shade over what the renderer has just drawn. */
  draw(renderer: WebGLRenderer): void {
    const { width, height } = renderer.getSize(new Vector2());
    this.#pass.setSize(width, height);
    this.#ground.position.copy(this.#under.position);
    this.#cutLike(this.#panels.material.clippingPlanes);
    this.#pass.render(renderer, this.#pass.pdRenderTarget, this.#pass.pdRenderTarget, 0, false);
    const uniforms = this.#material.uniforms as { figure: { value: unknown } };
    uniforms.figure.value = this.#pass.pdRenderTarget.texture;
    const clears = renderer.autoClear;
    renderer.autoClear = false;
    renderer.setRenderTarget(null);
    this.#quad.render(renderer);
    renderer.autoClear = clears;
  }

  /** What a section leaves out of the picture covers nothing. */
  #cutLike(planes: Material["clippingPlanes"]): void {
    if (this.#normals.clippingPlanes === planes) return;
    this.#normals.clippingPlanes = planes;
    this.#normals.needsUpdate = true;
  }

  dispose(): void {
    this.#pass.dispose();
    this.#quad.dispose();
    this.#material.dispose();
  }
}
