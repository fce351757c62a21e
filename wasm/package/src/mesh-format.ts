// SPDX-License-Identifier: MIT

/** Formats that a mesh is written in: for the npm package, the page and the element that shows it. */
export type MeshFormat = "obj" | "off" | "ply" | "glb";
