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
export function groupByKey(keys: Int32Array, count: number): Rows {
  const offsets = new Int32Array(count + 1);
  for (const key of keys) offsets[key + 1] = (offsets[key + 1] ?? 0) + 1;
  for (let k = 0; k < count; ++k) offsets[k + 1] = (offsets[k + 1] ?? 0) + (offsets[k] ?? 0);
  const next = offsets.slice(0, count);
  const values = new Int32Array(keys.length);
  for (let index = 0; index < keys.length; ++index) {
    const key = keys[index] ?? 0;
    const at = next[key] ?? 0;
    values[at] = index;
    next[key] = at + 1;
  }
  return { offsets, values };
}

/** The edges from every corner to the next, whichever way they run: their lower and higher ends. */
function edgesOfCorners(
  offsets: Int32Array,
  vertices: Int32Array,
): readonly [Int32Array, Int32Array] {
  const [low, high] = [new Int32Array(vertices.length), new Int32Array(vertices.length)];
  for (let f = 0; f + 1 < offsets.length; ++f) {
    const begin = offsets[f] ?? 0;
    const end = offsets[f + 1] ?? 0;
    for (let c = begin; c < end; ++c) {
      const a = vertices[c] ?? 0;
      const b = vertices[c + 1 < end ? c + 1 : begin] ?? 0;
      low[c] = Math.min(a, b);
      high[c] = Math.max(a, b);
    }
  }
  return [low, high];
}

/** The corners in the order of their edges, by grouping twice: no comparison sort keeps up with that. */
function byEdge(low: Int32Array, high: Int32Array, vertexCount: number): Int32Array {
  const byHigh = groupByKey(high, vertexCount).values;
  const lows = byHigh.map((corner) => low[corner] ?? 0);
  return groupByKey(lows, vertexCount).values.map((place) => byHigh[place] ?? 0);
}

export function buildTopology(
  offsets: Int32Array,
  vertices: Int32Array,
  vertexCount: number,
): Topology {
  const [low, high] = edgesOfCorners(offsets, vertices);
  const order = byEdge(low, high, vertexCount);
  const edges = new Int32Array(2 * vertices.length);
  const boundary = new Uint8Array(vertexCount);
  let count = 0;
  for (let k = 0; k < order.length; ) {
    const first = order[k] ?? 0;
    const [a, b] = [low[first] ?? 0, high[first] ?? 0];
    const begin = k;
    while (k < order.length && low[order[k] ?? 0] === a && high[order[k] ?? 0] === b) ++k;
    edges[count++] = a;
    edges[count++] = b;
    if (k - begin > 1) continue;
    boundary[a] = 1;
    boundary[b] = 1;
  }
  const ends = edges.slice(0, count);
  return {
    edges: ends,
    edgeEnds: groupByKey(ends, vertexCount),
    corners: groupByKey(vertices, vertexCount),
    boundary,
  };
}
