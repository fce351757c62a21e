// SPDX-License-Identifier: MIT
// The npm package as whoever installs it has it: from the packed file, in a project of its own.
import { execFileSync } from "node:child_process";
import { mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { build, createLogger } from "vite";
import { afterAll, beforeAll, expect, it } from "vitest";
import { launch } from "../../.tools/page/browser.mjs";
import { serve } from "../../.tools/page/serve.mjs";
import { DEFAULT_SETTINGS } from "../../web/src/design/design.ts";
import { loadPlanish } from "../parity/support/planish.ts";

const ROOT = resolve(import.meta.dirname, "../..");
const BUILT = join(ROOT, "build/npm");

let project: string;
const inProject = (name: string): string => join(project, name);
const run = (command: string, ...args: string[]): string =>
  execFileSync(command, args, {
    cwd: project,
    encoding: "utf8",
    stdio: ["ignore", "pipe", "pipe"],
  });

/** The result of an ES module in the project: what it prints, as JSON. */
async function script<T>(text: string): Promise<T> {
  await writeFile(inProject("script.mjs"), text);
  return JSON.parse(run("node", "script.mjs")) as T;
}

beforeAll(async () => {
  project = await mkdtemp(join(tmpdir(), "planish-consumer-"));
  const packed = run("npm", "pack", BUILT, "--silent").trim();
  const own = { name: "consumer", private: true, type: "module" };
  await writeFile(inProject("package.json"), JSON.stringify(own));
  run("npm", "install", "--offline", "--no-audit", "--no-fund", `./${packed}`);
});

afterAll(() => rm(project, { recursive: true, force: true }));

const TYPED = `
import { edit, Design, Mesh, options, PlanishError, project, type Report } from "planish";

const points = new Float64Array([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 0, 1, 2, 1, 1]);
const mesh: Mesh = await Mesh.from(points, [0, 4, 8], new Uint32Array([0, 1, 2, 3, 1, 4, 5, 2]));
const result = edit(mesh, {
  handles: [{ vertex: 4, by: [0, 0, 0.1] }],
  cuts: ["strip=1-4@0.4"],
  pins: [0],
  bounds: { angle: [25, 160], shape: true },
  progress: (step, objective, residual) => step < 1000 && objective + residual >= 0,
});
const report: Report = result.report;
const moved: Uint32Array = result.moved;
const text: string = result.design.text;
const again = (await Design.read(text)).replay();
const verified: boolean | null = again.verified;
let kind = "";
try {
  edit(mesh, { handles: [{ vertex: 99, to: [0, 0, 0] }] });
} catch (error) {
  if (error instanceof PlanishError) kind = error.kind;
}
const near = project(result.mesh, { within: 0.01, bounds: { flat: 2, shape: true } });
const known = Object.keys(await options("edit")).includes("keepBoundary");
console.log(JSON.stringify([report.status, moved.length > 0, verified, kind, known, near.report.status]));
`;

it.each([
  ["nodenext", "nodenext"],
  ["esnext", "bundler"],
])(
  "a strict TypeScript project builds without a word and runs (%s)",
  async (module, resolution) => {
    await writeFile(inProject("main.mts"), TYPED);
    const tsc = join(ROOT, "node_modules/.bin/tsc");
    const strict = ["--strict", "--exactOptionalPropertyTypes", "--noUncheckedIndexedAccess"];
    const where = ["--module", module, "--moduleResolution", resolution, "--target", "es2022"];
    const types = ["--types", "", "--lib", "es2022,dom"];
    expect(run(tsc, ...strict, ...where, ...types, "main.mts")).toBe("");
    expect(JSON.parse(run("node", "main.mjs"))).toEqual([
      ...["converged", true, true, "usage", true],
      "converged",
    ]);
  },
);

it("a Vite project builds without a warning, and its page edits", async () => {
  const warnings: string[] = [];
  const logger = createLogger("silent");
  logger.warn = (message) => warnings.push(message);
  await writeFile(
    inProject("index.html"),
    `<output></output><script type="module" src="main.js"></script>`,
  );
  await writeFile(
    inProject("main.js"),
    `import { edit, Mesh } from "planish";
     const mesh = await Mesh.sample("vault", 16);
     const { moved } = edit(mesh, { handles: [{ vertex: 136, by: [0, 0, 0.7] }] });
     document.querySelector("output").textContent = String(moved.length);`,
  );
  const target = { target: "es2022" };
  await build({
    root: project,
    configFile: false,
    customLogger: logger,
    base: "./",
    build: target,
  });
  expect(warnings).toEqual([]);
  const here = await script<number>(`import { edit, Mesh } from "planish";
    const mesh = await Mesh.sample("vault", 16);
    console.log(edit(mesh, { handles: [{ vertex: 136, by: [0, 0, 0.7] }] }).moved.length);`);
  const { server, url } = await serve(inProject("dist"));
  const browser = await launch();
  try {
    const page = await browser.newPage();
    await page.goto(url);
    await expect.poll(() => page.locator("output").textContent()).toBe(String(here));
  } finally {
    await browser.close();
    server.close();
  }
});

it("the examples run as they are", async () => {
  const example = await readFile(inProject("node_modules/planish/examples/node.mjs"), "utf8");
  await writeFile(inProject("example.mjs"), example);
  const said = run("node", "example.mjs").trim();
  expect(said).toMatch(/^converged: \d+ points move; edited\.glb$/);
  expect((await readFile(inProject("edited.glb"))).subarray(0, 4).toString()).toBe("glTF");
  const { server, url } = await serve(inProject("node_modules/planish"));
  const browser = await launch();
  try {
    for (const name of ["page", "worker"]) {
      const page = await browser.newPage();
      await page.goto(new URL(`examples/${name}/`, url).href);
      await expect
        .poll(() => page.locator("output").textContent())
        .toMatch(/^converged: \d+ points move$/);
    }
  } finally {
    await browser.close();
    server.close();
  }
});

/** The options of an edit by the names of the package, all of them said. */
const SAID = {
  attraction: 1000,
  locality: 1,
  smoothness: 1,
  fairness: "second",
  sparsity: "l21",
  solver: "newton",
} as const;

/** Sample, size, point and its displacement. */
type SampleEdit = readonly [string, number, number, readonly [number, number, number]];
const EDITS: readonly SampleEdit[] = [
  ["vault", 16, 136, [0, 0, 0.7]],
  ["dome", 12, 40, [0.1, 0, 0.3]],
  ["hex", 10, 60, [0, 0.2, 0.4]],
];

/** The same edit as the page's solver makes it: moved points and their coordinates. */
async function byThePage([sample, size, vertex, by]: SampleEdit) {
  const module = await loadPlanish();
  const session = new module.Session();
  const done = (refusal: string): void => expect(refusal).toBe("");
  done(session.openSample(sample, size));
  done(
    session.setOptions({
      ...DEFAULT_SETTINGS,
      attraction: SAID.attraction,
      locality: SAID.locality,
      smoothness: SAID.smoothness,
    }),
  );
  const base = session.basePositions();
  const target = by.map((d, c) => (base[3 * vertex + c] ?? 0) + d);
  const handles = Float64Array.of(vertex, ...target);
  done(session.edit(module.EditMode.solve, handles, new Int32Array(), 0, 0));
  const result = [[...session.moved()], [...session.movedPositions()]];
  session.delete();
  return result;
}

it.each(EDITS)(
  "edits of the %s have the page's bits and the command line's figures",
  async (...edit) => {
    const [sample, size, vertex, by] = edit;
    const handle = { vertex, by };
    const options = JSON.stringify({ handles: [handle], ...SAID });
    const [moved, points, total] = await script<[number[], number[], number]>(
      `import { edit, Mesh } from "planish";
     const mesh = await Mesh.sample("${sample}", ${size});
     const { moved, positions, report } = edit(mesh, ${options});
     const points = [...moved].flatMap((v) => [...positions.subarray(3 * v, 3 * v + 3)]);
     console.log(JSON.stringify([[...moved], points, report.objective.total]));`,
    );
    expect([moved, points]).toEqual(await byThePage(edit));
    const words = Object.entries(SAID).flatMap(([name, value]) => [`--${name}`, String(value)]);
    const native = join(ROOT, "build/native/planish");
    const given = [
      "edit",
      `sample:${sample}:${size}`,
      "--handle",
      `${vertex}+=${by.join()}`,
      ...words,
    ];
    run(native, ...given, "-o", "native.obj", "--report", "native.json");
    const report = JSON.parse(await readFile(inProject("native.json"), "utf8"));
    expect(report.moved_vertices).toBe(moved.length);
    expect(Math.abs(report.objective.total / total - 1)).toBeLessThan(1e-9);
  },
);

it("mobility says of each point what the command says, and a watch stops it", async () => {
  const [csv, stopped, kind] = await script<[string, number, string]>(`
    import { mobility, Mesh, PlanishError } from "planish";
    const mesh = await Mesh.sample("vault", 8);
    const where = mobility(mesh, { vertices: [28, 27], bounds: { fold: "+10" } });
    const part = mobility(mesh, { steps: 1, reach: 1, progress: (done) => done < 16 });
    let kind = "";
    try {
      mobility(mesh, { vertices: [64] });
    } catch (error) {
      if (error instanceof PlanishError) kind = error.kind;
    }
    const text = new TextDecoder().decode(where.write("csv"));
    console.log(JSON.stringify([text, part.rows.length, kind]));`);
  expect([stopped, kind]).toEqual([4 * 16, "usage"]);
  const given = ["mobility", "sample:vault:8", "--vertices=27,28", "--bound=fold=+10"];
  run(join(ROOT, "build/native/planish"), ...given, "-o", "native.csv");
  const rows = (text: string): string[][] =>
    text
      .trim()
      .split("\n")
      .map((row) => row.split(","));
  const [own, native] = [rows(csv), rows(await readFile(inProject("native.csv"), "utf8"))];
  expect(own[0]).toEqual(native[0]);
  expect(own).toHaveLength(1 + 2 * 4);
  for (const [k, row] of own.entries()) {
    for (const [column, cell] of row.entries()) {
      const other = native[k]?.[column] ?? "";
      if (Number.isFinite(Number(cell))) expect(Number(cell)).toBeCloseTo(Number(other), 6);
      else expect(cell).toBe(other);
    }
  }
});

it("types are those of the command, and a wrong joint is named", async () => {
  const [report, csv, sentence] = await script<[{ types: object }, string, string]>(`
    import { types, Mesh } from "planish";
    const mesh = await Mesh.sample("vault", 12);
    const alike = types(mesh, { joint: [4, 24], mirrored: true });
    let sentence = "";
    try {
      types(mesh, { joint: [5, 5] });
    } catch (error) {
      sentence = error.message;
    }
    const csv = new TextDecoder().decode(alike.write("csv"));
    console.log(JSON.stringify([alike.report, csv, sentence]));`);
  const given = ["types", "sample:vault:12", "--joint=4:24", "--mirrored"];
  run(join(ROOT, "build/native/planish"), ...given, "-o", "t.csv", "--report", "t.json");
  const native = JSON.parse(await readFile(inProject("t.json"), "utf8"));
  expect(report).toMatchObject({ types: { types: native.types.types, sizes: native.types.sizes } });
  // Of each panel the name, the type, the corner and whether it is turned over; fits differ by rounding.
  const rows = (text: string) =>
    text
      .trim()
      .split("\n")
      .map((row) => row.split(",").slice(0, 5));
  expect(rows(csv)).toEqual(rows(await readFile(inProject("t.csv"), "utf8")));
  expect(sentence).toMatch(/^joint/);
});

it("convert joins points and turns panels, and says how many", async () => {
  const answer = await script<unknown>(`
    import { convert, Mesh, options } from "planish";
    const points = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0, 2, 0, 1, 2, 1, 1];
    const apart = await Mesh.from(points, [0, 4, 8], [0, 1, 2, 3, 4, 5, 7, 6]);
    const whole = convert(apart, { joinPoints: true, orient: true });
    const near = convert(apart, { joinPoints: 0.01 });
    let sentence = "";
    try {
      convert(apart, { joinPoints: 0.9 });
    } catch (error) {
      sentence = error.message;
    }
    console.log(JSON.stringify([
      apart.warnings[0], [...whole.faceVertices], whole.warnings, near.points.length / 3, sentence,
      convert(apart, { joinPoints: false }).points.length / 3, Object.keys(await options("convert")),
    ]));`);
  expect(answer).toEqual([
    expect.stringContaining("convert joinPoints joins them"),
    [0, 1, 2, 3, 1, 4, 5, 2],
    [expect.stringMatching(/^2 vertices were joined/), "1 panel was turned over"],
    6,
    expect.stringContaining("half the shortest side"),
    8,
    ["joinPoints", "orient", "joinTriangles"],
  ]);
});

it("what the solver dropped from its memory comes back with the same bits", async () => {
  const [same, exact, megabytes] = await script<[boolean, boolean, number]>(`
    let memory;
    const { instantiate } = WebAssembly;
    WebAssembly.instantiate = async (...source) => {
      const made = await instantiate(...source);
      const { exports } = made.instance ?? made;
      memory = Object.values(exports).find((entry) => entry instanceof WebAssembly.Memory);
      return made;
    };
    const { edit, Mesh } = await import("planish");
    const mesh = await Mesh.sample("vault", 16);
    const at = (vertex) => edit(mesh, { handles: [{ vertex, by: [0, 0, 0.1] }] });
    const first = at(136);
    const family = first.explore({ dimension: 2 });
    const before = family.at([0.3, 0.2]);
    const design = first.design.text;
    const large = await Mesh.sample("vault", 100);
    for (let k = 0; k < 100; ++k) {
      edit(large, { handles: [{ vertex: 5050 + k, by: [0, 0, 0.1] }], reach: 2 });
    }
    const equal = (a, b) => a.length === b.length && a.every((x, k) => x === b[k]);
    const again = family.at([0.3, 0.2]);
    console.log(JSON.stringify([
      design === first.design.text && equal(before.positions, again.positions),
      equal(before.exact().positions, again.exact().positions),
      memory.buffer.byteLength / 1e6,
    ]));`);
  expect([same, exact]).toEqual([true, true]);
  // Were all results kept, it would be 145.
  expect(megabytes).toBeLessThan(60);
});

it("a watch stops a solve, and what it had is still there afterwards", async () => {
  const [status, length] = await script<[string, number]>(`
    import { edit, Mesh } from "planish";
    const mesh = await Mesh.sample("vault", 16);
    const one = { vertex: 136, by: [0, 0, 0.7] };
    const stopped = edit(mesh, { handles: [one], progress: (step) => step < 1 });
    for (let k = 0; k < 40; ++k) edit(mesh, { handles: [{ vertex: 100 + k, by: [0, 0, 0.1] }] });
    console.log(JSON.stringify([stopped.report.status, stopped.write("obj").length]));`);
  expect(status).toBe("cancelled");
  expect(length).toBeGreaterThan(1000);
});
