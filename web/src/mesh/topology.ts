// SPDX-License-Identifier: MIT
// What is next to what, from the face list alone; built once per mesh.

/** Rows of different lengths, one after the other. */
export interface Rows {
  readonly offsets: Int32Array;
  readonly values: Int32Array;
}

export interface Topology {
  /** Two vertices per edge, each edge once. */
  readonly edges: Int32Array;
  /** Edge ends at a vertex: 2 · edge + (0 or 1). */
  readonly edgeEnds: Rows;
  /** Positions in the face list at which a vertex occurs. */
  readonly corners: Rows;
  /** 1 where the vertex lies on an edge that only one face uses. */
  readonly boundary: Uint8Array;
}

export const row = (rows: Rows, index: number): Int32Array =>
  rows.values.subarray(rows.offsets[index] ?? 0, rows.offsets[index + 1] ?? 0);

/** Groups the indices 0 … of `keys` by their key. */
function groupByKey(keys: Int32Array, count: number): Rows {
  const offsets = new Int32Array(count + 1);
  for (const key of keys) offsets[key + 1] = (offsets[key + 1] ?? 0) + 1;
  for (let k = 0; k < count; ++k) offsets[k + 1] = (offsets[k + 1] ?? 0) + (offsets[k] ?? 0);
  const next = offsets.slice(0, count);
  const values = new Int32Array(keys.length);
  keys.forEach((key, index) => {
    const at = next[key] ?? 0;
    values[at] = index;
    next[key] = at + 1;
  });
  return { offsets, values };
}

/** One number per corner that names the edge to the next corner, whichever way it runs. */
function edgeKeys(offsets: Int32Array, vertices: Int32Array, vertexCount: number): Float64Array {
  const keys = new Float64Array(vertices.length);
  for (let f = 0; f + 1 < offsets.length; ++f) {
    const begin = offsets[f] ?? 0;
    const end = offsets[f + 1] ?? 0;
    for (let c = begin; c < end; ++c) {
      const a = vertices[c] ?? 0;
      const b = vertices[c + 1 < end ? c + 1 : begin] ?? 0;
      keys[c] = Math.min(a, b) * vertexCount + Math.max(a, b);
    }
  }
  return keys;
}

export function buildTopology(
  offsets: Int32Array,
  vertices: Int32Array,
  vertexCount: number,
): Topology {
  const keys = edgeKeys(offsets, vertices, vertexCount).sort();
  const edges: number[] = [];
  const boundary = new Uint8Array(vertexCount);
  for (let k = 0; k < keys.length; ) {
    const key = keys[k] ?? 0;
    let uses = 0;
    while (keys[k] === key) {
      ++uses;
      ++k;
    }
    const a = Math.floor(key / vertexCount);
    const b = key % vertexCount;
    edges.push(a, b);
    if (uses === 1) {
      boundary[a] = 1;
      boundary[b] = 1;
    }
  }
  const ends = Int32Array.from(edges);
  return {
    edges: ends,
    edgeEnds: groupByKey(ends, vertexCount),
    corners: groupByKey(vertices, vertexCount),
    boundary,
  };
}
