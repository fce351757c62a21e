// SPDX-License-Identifier: MIT
// What shaders of panels begin with: the way to the eye, with SMOOTH_NORMALS those of the geometry in the
// view, with SIDES how far it is to the panel's sides, and what a section leaves out.
export const VIEW_VERTEX = `
#ifdef SMOOTH_NORMALS
varying vec3 vNormal;
#endif
#ifdef SIDES
attribute vec4 sides;
varying vec4 vSides;
#if SIDES > 4
attribute vec4 moreSides;
varying vec4 vMoreSides;
#endif
#endif
varying vec3 vView;
#include <clipping_planes_pars_vertex>
void main() {
  vec4 mvPosition = modelViewMatrix * vec4(position, 1.0);
  #ifdef SMOOTH_NORMALS
  vNormal = mat3(viewMatrix) * normal;
  #endif
  #ifdef SIDES
  vSides = sides;
  #if SIDES > 4
  vMoreSides = moreSides;
  #endif
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
