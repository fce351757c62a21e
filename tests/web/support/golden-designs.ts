// SPDX-License-Identifier: MIT
// Designs that links and records are made of in tests.
import { crc32 } from "../../../web/src/bytes/crc32.ts";
import { DEFAULT_SETTINGS, type Design } from "../../../web/src/design/design.ts";
import type { SavedRecord } from "../../../web/src/design/saved-record.ts";
import type { Source } from "../../../web/src/solver/protocol.ts";

const content = new TextEncoder().encode("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");

export const FILE: Extract<Source, { kind: "file" }> = {
  kind: "file",
  name: "röof <b>.obj",
  format: "obj",
  bytes: new Blob([content]),
  crc: crc32(content),
};

const shape = {
  moved: Int32Array.of(3, 7, 220),
  positions: Float64Array.of(0.1, 0.2, 0.3, 1 / 3, -0, 5e-324, 1e300, Math.PI, -1e-9),
};

export const EDITED: Design = {
  source: { kind: "sample", name: "vault", size: 21 },
  planarised: null,
  handles: [
    { vertex: 220, target: [10.1, 9.9, 1 / 3], pinned: false },
    { vertex: 5, target: [0, 0, 0], pinned: true },
  ],
  settings: { ...DEFAULT_SETTINGS, smoothness: 0.5, keepShape: false },
  shape,
  report: {
    status: "converged",
    movedVertices: 3,
    maxDisplacement: 1.25,
    worstGap: 1e-16,
    worstMmPerM: 1e-12,
    worstExcess: 1e-12,
    sharpestFold: null,
    handleError: 0.5,
    objective: 12.5,
    iterations: 7,
    seconds: 0.02,
    residuals: [],
    optimality: {},
  },
  variation: {
    coefficients: [0.5, -0.25, 0],
    centre: { moved: shape.moved.slice(), positions: shape.positions.map((x) => x / 2) },
    earlier: [{ coefficients: [1 / 3], asked: 1, eigenbasis: true }],
    asked: 4,
    eigenbasis: false,
    exact: true,
  },
};

/** Of whatever result. */
export const MARK = { hash: 0x12345678, moved: 3, probes: [3, 0.1, 0.2, 0.3] };

export const OPENED: Design = {
  ...EDITED,
  source: FILE,
  planarised: {
    smooth: 0,
    keepBoundary: false,
    keepShape: false,
    constraints: [],
    within: 0,
    flat: 0,
  },
  handles: [],
  shape: { moved: new Int32Array(0), positions: new Float64Array(0) },
  report: { ...EDITED.report, movedVertices: 0 },
  variation: null,
};

export const RECORD: SavedRecord = {
  figure: null,
  time: 1_790_000_000_000,
  unit: "mm",
  camera: { position: [1, 2, 3], target: [0, -0.5, 0.25] },
  present: EDITED,
  snapshots: [
    { id: "a", name: "Low roof", time: 1, picture: "data:image/webp;base64,AAAA", design: OPENED },
    { id: "b", name: "", time: 2, picture: "", design: EDITED },
  ],
  views: [],
  note: "",
  section: null,
  groups: null,
  steps: { past: [], future: [] },
};
