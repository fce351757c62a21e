// SPDX-License-Identifier: MIT
// Glass: every panel mirrors a plain sky by the angle it is seen at and lets through the rest, so that
// neighbours tell apart by what they mirror, as the panes of a roof do. Each pane has a frame along its sides
// and is deeper in colour beside it, where one looks into the thickness of the glass.
import {
  BufferAttribute,
  type BufferGeometry,
  Color,
  DoubleSide,
  InterleavedBuffer,
  InterleavedBufferAttribute,
  ShaderMaterial,
} from "three";
import { DirtyRange } from "../../scene/dirty-range.ts";
import type { Skin } from "../../scene/skin.ts";
import { followCorners, meanSide, sidesKept, writeSideDistances } from "./side-distances.ts";
import { FLAT_NORMAL, VIEW_VERTEX } from "./view-shader.ts";

/** How wide a pane's own frame is, as a share of the mean side: with its neighbour's it is twice that. */
const FRAME = 0.02;

// Schlick's approximation says how much is mirrored.
const FRAGMENT = `
uniform vec3 zenith;
uniform vec3 horizon;
uniform vec3 ground;
uniform vec3 tint;
uniform vec3 sun;
uniform vec3 frame;
uniform vec3 edge;
uniform float frameWidth;
varying vec4 vSides;
#if SIDES > 4
varying vec4 vMoreSides;
#endif
varying vec3 vView;
#include <clipping_planes_pars_fragment>
${FLAT_NORMAL}
vec3 skyAt(vec3 towards) {
  float up = towards.z;
  vec3 sky = mix(horizon, zenith, pow(max(up, 0.0), 0.6));
  vec3 seen = mix(ground, sky, smoothstep(-0.08, 0.04, up));
  return seen + 0.8 * pow(max(dot(towards, sun), 0.0), 90.0);
}
float toSide() {
  vec4 all = vSides;
  #if SIDES > 4
  all = min(all, vMoreSides);
  #endif
  return min(min(all.x, all.y), min(all.z, all.w));
}
void main() {
  #include <clipping_planes_fragment>
  vec3 view = normalize(vView);
  vec3 normal = flatNormal();
  float mirrored = 0.06 + 0.94 * pow(1.0 - clamp(dot(view, normal), 0.0, 1.0), 5.0);
  vec3 towards = (vec4(reflect(-view, normal), 0.0) * viewMatrix).xyz;
  float shine = min(1.0, 2.5 * mirrored);
  float cover = shine + (1.0 - shine) * 0.3;
  vec3 colour = mix(tint, skyAt(towards), shine / cover);
  float side = toSide();
  float thick = 1.0 - smoothstep(frameWidth, 3.5 * frameWidth, side);
  colour = mix(colour, edge, 0.45 * thick);
  cover = mix(cover, 1.0, 0.35 * thick);
  float blur = max(fwidth(side), 1e-6);
  float framed = 1.0 - clamp((side - frameWidth) / blur + 0.5, 0.0, 1.0);
  framed *= min(1.0, 2.0 * frameWidth / blur);
  vec3 metal = frame * (0.75 + 0.5 * abs(normal.y));
  gl_FragColor = vec4(mix(colour, metal, framed), mix(cover, 1.0, framed));
  #include <colorspace_fragment>
}`;

export class Glass implements Skin {
  readonly material = new ShaderMaterial({
    vertexShader: VIEW_VERTEX,
    fragmentShader: FRAGMENT,
    uniforms: {
      zenith: { value: new Color("#5F8FBF") },
      horizon: { value: new Color("#EEF3F6") },
      ground: { value: new Color("#A9A59B") },
      tint: { value: new Color("#A9C4C4") },
      frame: { value: new Color("#5B6268") },
      edge: { value: new Color("#4F7F78") },
      frameWidth: { value: 0 },
      sun: { value: [-0.6162, -0.2397, 0.7501] },
    },
    side: DoubleSide,
    transparent: true,
    depthWrite: false,
    forceSinglePass: false,
    clipping: true,
  });

  #sides: InterleavedBuffer | null = null;
  /** The corners that distances were taken of last. */
  #before = new Float32Array(0);
  readonly #dirty = new DirtyRange();

  /** Takes new distances in panels whose points moved; frames stay as wide as they were at first. */
  update(geometry: BufferGeometry, offsets: Int32Array): void {
    const { position } = geometry.attributes;
    if (!(position instanceof BufferAttribute)) return;
    const corners = position.array as Float32Array;
    const sides = this.#sides ?? this.#begin(geometry, corners, offsets);
    const out = { array: sides.array as Float32Array, stride: sides.stride };
    followCorners(corners, this.#before, offsets, out, (corner) => this.#dirty.add(corner));
    this.#dirty.flush(sides, sides.stride);
  }

  #begin(geometry: BufferGeometry, corners: Float32Array, offsets: Int32Array): InterleavedBuffer {
    const sides = this.#frame(geometry, corners, offsets);
    const { array, stride } = sides;
    writeSideDistances(corners, offsets, { array: array as Float32Array, stride });
    this.#before = corners.slice();
    this.#dirty.addAll(array.length / stride);
    this.#sides = sides;
    return sides;
  }

  #frame(geometry: BufferGeometry, corners: Float32Array, offsets: Int32Array): InterleavedBuffer {
    const kept = sidesKept(offsets);
    const there = geometry.attributes.sides;
    const sides =
      there instanceof InterleavedBufferAttribute
        ? there.data
        : new InterleavedBuffer(new Float32Array((kept * corners.length) / 3), kept);
    geometry.setAttribute("sides", new InterleavedBufferAttribute(sides, 4, 0));
    if (kept > 4) geometry.setAttribute("moreSides", new InterleavedBufferAttribute(sides, 4, 4));
    this.material.defines.SIDES = kept;
    this.material.uniforms.frameWidth = { value: FRAME * meanSide(corners, offsets) };
    return sides;
  }

  dispose(): void {
    this.material.dispose();
  }
}
