// SPDX-License-Identifier: MIT
// Reflection lines: how stripes of light lie on the surface that goes smoothly through the points. A
// kink in a stripe is a kink in the shape; panels by themselves, each flat, would only show their edges.
import { BufferAttribute, type BufferGeometry, Color, DoubleSide, ShaderMaterial } from "three";
import { row, type Topology } from "../../mesh/topology.ts";
import type { Skin } from "../../scene/skin.ts";
import { VIEW_VERTEX } from "./view-shader.ts";

/** Stripes from the horizon to the zenith. */
const STRIPES = 10;

// The stripes stand about the model, so that they run over it as the camera turns.
const FRAGMENT = `
uniform vec3 light;
uniform vec3 dark;
uniform float stripes;
varying vec3 vNormal;
varying vec3 vView;
#include <clipping_planes_pars_fragment>
void main() {
  #include <clipping_planes_fragment>
  vec3 view = normalize(vView);
  vec3 normal = faceforward(normalize(vNormal), -view, normalize(vNormal));
  vec3 mirrored = reflect(-view, normal);
  vec3 world = (vec4(mirrored, 0.0) * viewMatrix).xyz;
  float place = stripes * asin(clamp(world.y, -1.0, 1.0)) / 1.5707963;
  float width = max(fwidth(place), 1e-4);
  float stripe = abs(fract(place) - 0.5) - 0.25;
  float ink = clamp(0.5 + stripe / width, 0.0, 1.0);
  ink = mix(ink, 0.5, smoothstep(0.4, 1.2, width));
  gl_FragColor = vec4(mix(light, dark, ink) * (0.82 + 0.18 * normal.z), 1.0);
  #include <colorspace_fragment>
}`;

/** Points' normals by area, for every corner; `corners` in the order of `offsets`. */
export function smoothNormals(
  corners: Float32Array,
  offsets: Int32Array,
  topology: Topology,
  out: Float32Array,
): void {
  const count = topology.corners.offsets.length - 1;
  const panels = panelNormals(corners, offsets);
  for (let v = 0; v < count; ++v) {
    let [x, y, z] = [0, 0, 0];
    const own = row(topology.corners, v);
    for (const corner of own) {
      x += panels[3 * corner] ?? 0;
      y += panels[3 * corner + 1] ?? 0;
      z += panels[3 * corner + 2] ?? 0;
    }
    const length = Math.hypot(x, y, z) || 1;
    for (const corner of own) out.set([x / length, y / length, z / length], 3 * corner);
  }
}

/** The area vector of its panel, for every corner. */
function panelNormals(corners: Float32Array, offsets: Int32Array): Float32Array {
  const normals = new Float32Array(corners.length);
  for (let f = 0; f + 1 < offsets.length; ++f) {
    const [begin, end] = [offsets[f] ?? 0, offsets[f + 1] ?? 0];
    const at = (k: number, axis: number): number => corners[3 * k + axis] ?? 0;
    const normal = [0, 0, 0];
    for (let k = begin; k < end; ++k) {
      const next = k + 1 < end ? k + 1 : begin;
      for (let axis = 0; axis < 3; ++axis) {
        const [b, c] = [(axis + 1) % 3, (axis + 2) % 3];
        normal[axis] = (normal[axis] ?? 0) + at(k, b) * at(next, c) - at(k, c) * at(next, b);
      }
    }
    for (let k = begin; k < end; ++k) normals.set(normal, 3 * k);
  }
  return normals;
}

export class Zebra implements Skin {
  readonly material = new ShaderMaterial({
    vertexShader: VIEW_VERTEX,
    fragmentShader: FRAGMENT,
    uniforms: {
      light: { value: new Color("#F7F6F2") },
      dark: { value: new Color("#1C2024") },
      stripes: { value: STRIPES },
    },
    defines: { SMOOTH_NORMALS: "" },
    side: DoubleSide,
    clipping: true,
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
  });

  /** Takes new normals after points moved. */
  update(geometry: BufferGeometry, offsets: Int32Array, topology: Topology): void {
    const { position, normal } = geometry.attributes;
    if (!(position instanceof BufferAttribute)) return;
    const there = normal instanceof BufferAttribute;
    const normals = there
      ? normal
      : new BufferAttribute(new Float32Array(position.array.length), 3);
    smoothNormals(position.array as Float32Array, offsets, topology, normals.array as Float32Array);
    normals.needsUpdate = true;
    if (!there) geometry.setAttribute("normal", normals);
  }

  dispose(): void {
    this.material.dispose();
  }
}
