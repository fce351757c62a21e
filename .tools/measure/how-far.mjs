// SPDX-License-Identifier: MIT
// Whether "Panels allow … here" is true: on ten meshes, three places each, a drag along the normal whose
// end the page holds back (web/src/solver/edits.ts), let go at once and after frames, against the longest
// target that one solve with the same limit on folds meets, found by bisection. After
// `bash .tools/start/build.sh native wasm`:
//   node .tools/measure/how-far.mjs [FOLDER of meshes]
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { loadCore, loadSources } from "./page-sources.mjs";

const CLI = "build/native/planish";
const SAMPLES = ["roof", "vault", "dome", "freeform"];
const FILES = [
  "pq_static_roof",
  "pq_conical_saddle",
  "pq_lifted_small",
  "hex_dual_tridome",
  "pq_octtorus",
  "pq_six_planarized",
];
const PLACES = 3;
/** Mean edges: as far as a drag asks. */
const ASKED = 4;
const DEGREES = 10;
/** Of the way: as near to its target a handle has met it. */
const MET = 0.05;
const HALVINGS = 7;
/** Of a drag, in equal steps; seconds that one may take, as in the page. */
const FRAMES = 40;
const FRAME_SECONDS = 0.016;

const minus = (a, b) => a.map((x, k) => x - b[k]);
const dot = (a, b) => a.reduce((sum, x, k) => sum + x * b[k], 0);
const cross = (a, b) =>
  [0, 1, 2].map((k) => a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3]);

/** Points, panels, and inner points two rings from the border, of an OBJ. */
function readObj(text) {
  const lines = text.split("\n").map((line) => line.trim().split(/\s+/));
  const points = lines.filter(([kind]) => kind === "v").map(([, ...x]) => x.map(Number));
  const words = lines.filter(([kind]) => kind === "f").map(([, ...face]) => face);
  const faces = words.map((face) => face.map((word) => Number.parseInt(word, 10) - 1));
  const sides = new Map();
  for (const face of faces)
    face.forEach((v, k) => {
      const side = [v, face[(k + 1) % face.length]].toSorted((a, b) => a - b).join();
      sides.set(side, (sides.get(side) ?? 0) + 1);
    });
  const border = [...sides].filter(([, count]) => count === 1);
  let near = new Set(border.flatMap(([side]) => side.split(",").map(Number)));
  for (let ring = 0; ring < 2; ++ring)
    near = new Set([...near, ...faces.filter((f) => f.some((v) => near.has(v))).flat()]);
  const used = [...new Set(faces.flat())].toSorted((a, b) => a - b);
  return { points, faces, inner: used.filter((v) => !near.has(v)) };
}

function normalAt({ points, faces }, vertex) {
  let sum = [0, 0, 0];
  for (const face of faces.filter((f) => f.includes(vertex)))
    face.forEach((v, k) => {
      const [a, b] = [v, face[(k + 1) % face.length]].map((w) => minus(points[w], points[vertex]));
      const area = cross(a, b);
      sum = sum.map((x, axis) => x + area[axis]);
    });
  const length = Math.hypot(...sum);
  return sum.map((x) => x / length);
}

/** Along `normal`, from the base; 0 where it did not move. */
function wayOf(session, { points }, vertex, normal) {
  const place = [...session.moved()].indexOf(vertex);
  if (place < 0) return 0;
  const at = [...session.movedPositions().subarray(3 * place, 3 * place + 3)];
  return dot(minus(at, points[vertex]), normal);
}

class Place {
  constructor(bench, session, mesh, vertex) {
    Object.assign(this, { ...bench, session, mesh, vertex, normal: normalAt(mesh, vertex) });
    this.at = [vertex, ...mesh.points[vertex]];
  }

  target(way) {
    return [this.vertex, ...this.mesh.points[this.vertex].map((x, k) => x + way * this.normal[k])];
  }

  ask(edits, way, mode, limits, limit) {
    const targets = { handles: this.target(way), pins: [] };
    const settings = { ...this.settings, limits };
    const budget = FRAME_SECONDS;
    return edits.edit({
      kind: "edit",
      mode,
      targets,
      settings,
      budget,
      limit,
      reaches: [],
      sought: null,
    });
  }

  reached() {
    return wayOf(this.session, this.mesh, this.vertex, this.normal);
  }

  /** What the page says that panels allow, its target then, steps of solves and seconds; where the last of
   * so many frames before it ended. */
  said(asked, frames) {
    const edits = new this.Edits(this.module, this.session, () => 0);
    const limit = { degrees: DEGREES, short: 0, from: this.at, base: this.at };
    for (let k = 1; k <= frames; ++k) this.ask(edits, (asked * k) / frames, "drag", [], limit);
    const shown = frames > 0 ? this.reached() : 0;
    let steps = 0;
    this.session.onProgress(() => {
      steps += 1;
      return true;
    });
    const start = process.cpuUsage().user;
    const { taken } = this.ask(edits, asked, "release", [], limit);
    const seconds = (process.cpuUsage().user - start) / 1e6;
    this.session.onProgress(() => true);
    const target = taken
      ? dot(minus(taken.slice(1), this.mesh.points[this.vertex]), this.normal)
      : asked;
    return { way: this.reached(), target, shown, steps, seconds };
  }

  /** Whether the solve with the limit gets there. */
  meets(way) {
    const edits = new this.Edits(this.module, this.session, () => 0);
    this.ask(edits, way, "solve", [`fold=+${DEGREES}`], null);
    const { handleError, status } = this.session.shapeReport();
    return status !== "infeasible_handles" && handleError <= MET * way;
  }

  /** The longest way that is met. */
  bounded(asked) {
    if (this.meets(asked)) return asked;
    let [low, high] = [0, asked];
    for (let k = 0; k < HALVINGS; ++k) {
      const middle = (low + high) / 2;
      if (this.meets(middle)) low = middle;
      else high = middle;
    }
    return low;
  }
}

function flatMeshes(folder, scratch) {
  const samples = SAMPLES.map((name) => {
    const path = join(scratch, `${name}.obj`);
    execFileSync(CLI, ["sample", name, "--size", "20", "-o", path]);
    return [name, path];
  });
  const files = FILES.map((name) => {
    const path = join(scratch, `${name}.obj`);
    execFileSync(CLI, ["project", join(folder, `${name}.obj`), "--smooth", "100", "-o", path], {
      stdio: "ignore",
    });
    return [name, path];
  });
  return [...samples, ...files];
}

async function loadBench() {
  const module = await loadCore();
  const [{ Edits }, { FIRST_SETTINGS }] = await loadSources([
    "/web/src/solver/edits.ts",
    "/web/src/design/design.ts",
  ]);
  return { module, Edits, settings: FIRST_SETTINGS };
}

const bench = await loadBench();
const scratch = mkdtempSync(join(tmpdir(), "how-far-"));
const places = [];
const columns = ["mesh", "place", "asked", "the page says", "after frames", "last frame"];
columns.push("the bounded solve meets", "share", "of targets", "steps", "s", "after frames");
console.log(`| ${columns.join(" | ")} |\n| ${columns.map(() => "---").join(" | ")} |`);
for (const [name, path] of flatMeshes(process.argv[2] ?? "../shared/meshes", scratch)) {
  const bytes = readFileSync(path);
  const mesh = readObj(bytes.toString());
  const session = new bench.module.Session();
  const problem = session.openFile(bytes, "obj");
  if (problem) throw new Error(`${name}: ${problem}`);
  const asked = ASKED * session.meshReport().meanEdge;
  for (let k = 0; k < PLACES; ++k) {
    const vertex = mesh.inner[Math.floor(((k + 0.5) / PLACES) * mesh.inner.length)];
    const place = new Place(bench, session, mesh, vertex);
    const [once, dragged, bounded] = [
      place.said(asked, 0),
      place.said(asked, FRAMES),
      place.bounded(asked),
    ];
    const [share, targets] = [once.way / bounded, once.target / bounded];
    places.push({ once, dragged, share, targets });
    const ways = [asked, once.way, dragged.way, dragged.shown, bounded, share, targets];
    const price = [once.steps, once.seconds, `${dragged.steps}, ${dragged.seconds.toFixed(1)} s`];
    const cells = [name, vertex, ...ways, ...price];
    console.log(
      `| ${cells.map((x) => (typeof x === "number" && !Number.isInteger(x) ? x.toPrecision(3) : x)).join(" | ")} |`,
    );
  }
  session.delete();
}

const median = (list) => list.toSorted((a, b) => a - b)[list.length >> 1];
const near = (list) => list.filter((share) => Math.abs(share - 1) <= MET).length;
/** Median and most, of the edits let go at once and of those after frames. */
const both = (figure) =>
  ["once", "dragged"]
    .map((way) => places.map((place) => figure(place[way])))
    .map((list) => `${median(list).toPrecision(3)}, at most ${Math.max(...list).toPrecision(3)}`)
    .join("; after frames ");
const [shares, targets] = [places.map(({ share }) => share), places.map((one) => one.targets)];
console.log(`
${near(shares)} of ${shares.length} within 5 %, median ${median(shares).toFixed(2)}; by targets ${near(targets)}, median ${median(targets).toFixed(2)}
steps: ${both(({ steps }) => steps)}
s: ${both(({ seconds }) => seconds)}
after frames it gets less far than the last of them: ${places.filter(({ dragged }) => dragged.way < 0.99 * dragged.shown).length}`);
rmSync(scratch, { recursive: true });
