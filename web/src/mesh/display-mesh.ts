// SPDX-License-Identifier: MIT
// All that the scene needs to draw and pick a mesh. The worker makes it, so that opening a large
// file does not hold up the page.
import { buildTopology, type Topology } from "./topology.ts";
import { triangulate } from "./triangulation.ts";

/** Points in display coordinates, and faces. */
export interface Polygons {
  readonly display: Float32Array;
  readonly offsets: Int32Array;
  readonly vertices: Int32Array;
}

export interface DisplayMesh extends Polygons {
  readonly topology: Topology;
  /** x, y, z of every place in the face list, so that each panel is shaded by itself. */
  readonly corners: Float32Array;
  /** Three places in the face list per triangle. */
  readonly triangles: Uint32Array;
}

function spread(points: Float32Array, vertices: Int32Array): Float32Array {
  const corners = new Float32Array(3 * vertices.length);
  for (let c = 0; c < vertices.length; ++c) {
    const v = 3 * (vertices[c] ?? 0);
    corners[3 * c] = points[v] ?? 0;
    corners[3 * c + 1] = points[v + 1] ?? 0;
    corners[3 * c + 2] = points[v + 2] ?? 0;
  }
  return corners;
}

export function prepareDisplay(polygons: Polygons): DisplayMesh {
  const { display, offsets, vertices } = polygons;
  const corners = spread(display, vertices);
  return {
    display,
    offsets,
    vertices,
    topology: buildTopology(offsets, vertices, display.length / 3),
    corners,
    triangles: triangulate(corners, offsets),
  };
}

/** The memory behind a prepared mesh, to hand over to another thread. */
export function buffersOf({ topology, ...mesh }: DisplayMesh): ArrayBufferLike[] {
  const { edges, edgeEnds, corners, boundary } = topology;
  const arrays = [mesh.display, mesh.offsets, mesh.vertices, mesh.corners, mesh.triangles];
  const rows = [edges, edgeEnds.offsets, edgeEnds.values, corners.offsets, corners.values];
  return [...arrays, ...rows, boundary].map((array) => array.buffer);
}
