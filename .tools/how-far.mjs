// SPDX-License-Identifier: MIT
// Whether "Panels allow … here" is true: on ten meshes, three places each, a drag along the normal that the
// page's own search takes back (web/src/solver/edits.ts), against the longest target that one solve with the same
// limit on folds meets, found by bisection. After `bash .tools/build.sh native wasm`:
//   node .tools/how-far.mjs [FOLDER of meshes]
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { createServer, runnerImport } from "vite";

const CLI = "build/native/planish";
const WASM = resolve("build/wasm/wasm");
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
  }

  question(way, limits, limit) {
    const to = this.mesh.points[this.vertex].map((x, axis) => x + way * this.normal[axis]);
    const settings = { ...this.settings, limits };
    const targets = { handles: [this.vertex, ...to], pins: [] };
    const mode = limit ? "release" : "solve";
    return { kind: "edit", mode, targets, settings, budget: 10, limit, fairWay: null };
  }

  /** What the page says that panels allow. */
  said(asked) {
    const edits = new this.Edits(this.module, this.session);
    const from = [this.vertex, ...this.mesh.points[this.vertex]];
    const limit = { degrees: DEGREES, short: Number.POSITIVE_INFINITY, from };
    edits.edit(this.question(asked, [], limit));
    return wayOf(this.session, this.mesh, this.vertex, this.normal);
  }

  /** Whether the solve with the limit gets there. */
  meets(way) {
    const edits = new this.Edits(this.module, this.session);
    edits.edit(this.question(way, [`fold=+${DEGREES}`], null));
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

/** The page's own files, asked without a page. */
async function loadPage(names) {
  const { module } = await runnerImport(resolve("web/core-defaults.ts"));
  const server = await createServer({
    root: process.cwd(),
    configFile: false,
    logLevel: "error",
    resolve: { alias: { "@wasm": WASM } },
    plugins: [module.coreDefaults(`${WASM}/`, (url) => import(url))],
    server: { middlewareMode: true, watch: null },
    optimizeDeps: { noDiscovery: true },
  });
  try {
    return await Promise.all(names.map((name) => server.ssrLoadModule(name)));
  } finally {
    await server.close();
  }
}

async function loadBench() {
  const { default: create } = await import(pathToFileURL(join(WASM, "planish.mjs")).href);
  const module = await create({ wasmBinary: readFileSync(join(WASM, "planish.wasm")) });
  const [{ Edits }, { FIRST_SETTINGS }] = await loadPage([
    "/web/src/solver/edits.ts",
    "/web/src/design/design.ts",
  ]);
  return { module, Edits, settings: FIRST_SETTINGS };
}

const bench = await loadBench();
const scratch = mkdtempSync(join(tmpdir(), "how-far-"));
const shares = [];
console.log("| mesh | place | asked | the page says | the bounded solve meets | share |");
console.log("| --- | --- | --- | --- | --- | --- |");
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
    const [said, bounded] = [place.said(asked), place.bounded(asked)];
    shares.push(said / bounded);
    const cells = [name, vertex, asked, said, bounded, said / bounded];
    console.log(
      `| ${cells.map((x) => (typeof x === "number" && !Number.isInteger(x) ? x.toPrecision(3) : x)).join(" | ")} |`,
    );
  }
  session.delete();
}
const within = shares.filter((share) => Math.abs(share - 1) <= 0.05).length;
const middle = shares.toSorted((a, b) => a - b)[shares.length >> 1];
console.log(`\n${within} of ${shares.length} within 5 %; share, median ${middle.toFixed(2)}`);
rmSync(scratch, { recursive: true });
