// SPDX-License-Identifier: MIT
// Glass: every panel mirrors a plain sky by the angle it is seen at and lets through the rest, so that
// neighbours tell apart by what they mirror, as the panes of a roof do.
import { Color, DoubleSide, ShaderMaterial } from "three";
import type { Skin } from "../../scene/skin.ts";
import { FLAT_NORMAL, VIEW_VERTEX } from "./view-shader.ts";

// Schlick's approximation says how much is mirrored.
const FRAGMENT = `
uniform vec3 zenith;
uniform vec3 horizon;
uniform vec3 ground;
uniform vec3 tint;
uniform vec3 sun;
varying vec3 vView;
#include <clipping_planes_pars_fragment>
${FLAT_NORMAL}
vec3 skyAt(vec3 towards) {
  float up = towards.z;
  vec3 sky = mix(horizon, zenith, pow(max(up, 0.0), 0.6));
  vec3 seen = mix(ground, sky, smoothstep(-0.08, 0.04, up));
  return seen + 0.8 * pow(max(dot(towards, sun), 0.0), 90.0);
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
  gl_FragColor = vec4(colour, cover);
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
      sun: { value: [-0.6162, -0.2397, 0.7501] },
    },
    side: DoubleSide,
    transparent: true,
    depthWrite: false,
    forceSinglePass: false,
    clipping: true,
  });

  update(): void {}

  dispose(): void {
    this.material.dispose();
  }
}
