// SPDX-License-Identifier: MIT
// What a drag and its end cost on large meshes: a vault of each size, three places, 40 frames along the
// normal as the page asks for them (web/src/solver/dispatch.ts), then the release. Seconds are of the
// processor; frames have 16 ms of the clock, so on a busy machine they get less far. After
// `bash .tools/build.sh wasm`:
//   node .tools/measure/large-release.mjs [SIDES, as 100,316,1000] [MEAN EDGES, as 1,4]
import { loadCore, loadSources } from "./page-sources.mjs";

const numbers = (text) => text.split(",").map(Number);
const SIDES = numbers(process.argv[2] ?? "100,316,1000");
const PULLS = numbers(process.argv[3] ?? "1,4");
/** Rows and columns, shares of the side. */
const PLACES = [
  [0.5, 0.5],
  [0.25, 0.4],
  [0.7, 0.2],
];
const DEGREES = 10;
const FRAMES = 40;
const FRAME_SECONDS = 0.016;

const minus = (a, b) => a.map((x, k) => x - b[k]);
const cross = (a, b) =>
  [0, 1, 2].map((k) => a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3]);
const median = (list) => list.toSorted((a, b) => a - b)[list.length >> 1];

class Bench {
  constructor(Dispatcher, module, page) {
    Object.assign(this, page);
    this.dispatcher = new Dispatcher(module, (reply) => this.hear(reply));
  }

  hear(reply) {
    if (reply.kind !== "progress") this.answer = reply;
  }

  async ask(question) {
    const start = process.cpuUsage().user;
    await this.dispatcher.handle({ job: 1, ...question });
    if (this.answer.kind === "failed") throw new Error(this.answer.message);
    return { answer: this.answer, seconds: (process.cpuUsage().user - start) / 1e6 };
  }

  async open(size) {
    const source = { kind: "sample", name: "vault", size };
    const question = { kind: "open", source, planarise: null, symmetry: null, cuts: [] };
    const { answer, seconds } = await this.ask(question);
    this.mesh = answer.mesh;
    return seconds;
  }

  at(vertex) {
    return [...this.mesh.positions.subarray(3 * vertex, 3 * vertex + 3)];
  }

  async back() {
    const shape = { moved: new Int32Array(), positions: new Float64Array() };
    const targets = { handles: [], pins: [] };
    await this.ask({ kind: "restore", targets, settings: this.settings, shape, keep: false });
  }
}

/** What is on screen: where points are that moved, model units. */
class View {
  points = new Map();

  constructor(bench) {
    this.bench = bench;
  }

  apply({ changes }) {
    const { scale, centre } = this.bench.mesh.report;
    for (let k = 0; k < changes.length; k += 4) {
      const place = [...changes.subarray(k + 1, k + 4)].map((x, axis) => x / scale + centre[axis]);
      this.points.set(changes[k], place);
    }
  }

  place(vertex) {
    return this.points.get(vertex) ?? this.bench.at(vertex);
  }

  copy() {
    const other = new View(this.bench);
    other.points = new Map(this.points);
    return other;
  }

  apartFrom(other) {
    return Math.max(
      ...[...this.points.keys()].map((v) => Math.hypot(...minus(this.place(v), other.place(v)))),
    );
  }
}

async function dragAndRelease(bench, row, [i, j], edges) {
  const vertex = Math.floor(i * row) * row + Math.floor(j * row);
  const [along, across] = [1, row].map((step) =>
    minus(bench.at(vertex + step), bench.at(vertex - step)),
  );
  const area = cross(along, across);
  const normal = area.map((x) => x / Math.hypot(...area));
  const base = [vertex, ...bench.at(vertex)];
  const limit = { degrees: DEGREES, short: 0, from: base, base };
  const pull = edges * bench.mesh.report.meanEdge;
  const edit = (share, mode) => {
    const handles = base.map((x, k) => (k > 0 ? x + share * pull * normal[k - 1] : x));
    const { settings, reaches } = bench;
    const targets = { handles, pins: [] };
    const common = { settings, budget: FRAME_SECONDS, limit, reaches, sought: null };
    return bench.ask({ kind: "edit", mode, targets, ...common });
  };
  const view = new View(bench);
  const frames = [];
  for (let k = 1; k <= FRAMES; ++k) {
    const frame = await edit(k / FRAMES, "drag");
    view.apply(frame.answer);
    frames.push(frame);
  }
  const shown = view.copy();
  const release = await edit(1, "release");
  view.apply(release.answer);
  const way = (of) => Math.hypot(...minus(of.place(vertex), bench.at(vertex)));
  const seconds = frames.map((one) => one.seconds);
  return {
    vertex,
    pull,
    first: seconds[0],
    frame: median(seconds),
    release: release.seconds,
    shown: way(shown),
    settled: way(view),
    apart: view.apartFrom(shown),
    most: frames.at(-1).answer.report.maxDisplacement,
    left: release.answer.report.maxDisplacement,
    held: release.answer.taken !== null,
  };
}

const [{ Dispatcher }, { FIRST_SETTINGS }, { REACHES }] = await loadSources([
  "/web/src/solver/dispatch.ts",
  "/web/src/design/design.ts",
  "/web/src/solver/reach-steps.ts",
]);
const page = { settings: FIRST_SETTINGS, reaches: REACHES };
const bench = new Bench(Dispatcher, await loadCore(), page);
const columns = [
  "points",
  "place",
  "pull",
  "first frame s",
  "frame s",
  "release s",
  "handle in the last frame",
];
columns.push(
  "settled",
  "points went on by",
  "largest move in the last frame",
  "settled",
  "said to be held",
);
console.log(`| ${columns.join(" | ")} |\n| ${columns.map(() => "---").join(" | ")} |`);
for (const side of SIDES) {
  const opened = await bench.open(side);
  const count = bench.mesh.positions.length / 3;
  console.error(`${count} points opened in ${opened.toFixed(1)} s`);
  for (const place of PLACES) {
    for (const edges of PULLS) {
      const got = await dragAndRelease(bench, Math.round(Math.sqrt(count)), place, edges);
      const { vertex, held, ...figures } = got;
      const { pull, first, frame, release, shown, settled, apart, most, left } = figures;
      const lengths = [shown, settled, apart, most, left].map((x) => x.toPrecision(3));
      const times = [first, frame, release].map((x) => x.toFixed(2));
      console.log(
        `| ${[count, vertex, pull.toPrecision(3), ...times, ...lengths, held].join(" | ")} |`,
      );
      await bench.back();
    }
  }
}
