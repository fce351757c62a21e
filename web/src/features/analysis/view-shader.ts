// SPDX-License-Identifier: MIT
// What shaders of panels begin with: the way to the eye, with SMOOTH_NORMALS those of the geometry in the
// view, and what a section leaves out.
export const VIEW_VERTEX = `
#ifdef SMOOTH_NORMALS
varying vec3 vNormal;
#endif
varying vec3 vView;
#include <clipping_planes_pars_vertex>
void main() {
  vec4 mvPosition = modelViewMatrix * vec4(position, 1.0);
  #ifdef SMOOTH_NORMALS
  vNormal = mat3(viewMatrix) * normal;
  #endif
  vView = -mvPosition.xyz;
  gl_Position = projectionMatrix * mvPosition;
  #include <clipping_planes_vertex>
}`;

/** The panel's own normal, towards the eye: its triangles lie in one plane. */
export const FLAT_NORMAL = `
vec3 flatNormal() {
  vec3 normal = normalize(cross(dFdx(vView), dFdy(vView)));
  return faceforward(normal, -vView, normal);
}`;
