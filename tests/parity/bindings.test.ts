// SPDX-License-Identifier: MIT
// planish.d.ts is written by hand; this holds it to what the module really has.
import { readFileSync } from "node:fs";
import { variationWeights } from "virtual:core-defaults";
import { expect, it } from "vitest";
import { DEFAULT_SETTINGS, FIRST_SETTINGS } from "../../web/src/design/design.ts";
import { KINDS } from "../../web/src/design/kept-kind.ts";
import { loadDocuments, loadPlanish } from "./support/planish.ts";

const read = (name: string, ending = "d.ts"): string =>
  readFileSync(new URL(`../../wasm/${name}.${ending}`, import.meta.url), "utf8");
const declarations = read("planish");

const reports = read("planish_reports");

/** Names that the body of `interface <name>` declares at its first level. */
function declared(name: string, text = declarations): string[] {
  const body = new RegExp(`interface ${name} \\{([\\s\\S]*?)\\n\\}`).exec(text)?.[1] ?? "";
  return [...body.matchAll(/^ {2}(?:readonly )?(\w+)[(:]/gm)].map((match) => match[1] ?? "").sort();
}

const inherited = new Set(["constructor", "isAliasOf", "clone", "isDeleted", "deleteLater"]);

/** Names of what is bound to an object, its prototypes included. */
function boundTo(object: object): string[] {
  const bound = new Set<string>();
  for (let at = object; at !== Object.prototype; at = Object.getPrototypeOf(at)) {
    for (const name of Object.getOwnPropertyNames(at)) {
      if (!inherited.has(name) && name !== "$$") bound.add(name);
    }
  }
  return [...bound].sort();
}

it("declares every bound member of Session and binds every declared one", async () => {
  const { Session } = await loadPlanish();
  const session = new Session();
  expect(boundTo(session)).toEqual(declared("Session"));
  session.delete();
});

it("declares every field of every report", async () => {
  const module = await loadPlanish();
  const session = new module.Session();
  expect(session.openSample("vault", 9)).toBe("");
  const fields = (report: object): string[] => Object.keys(report).sort();
  const mesh = session.meshReport();
  expect(fields(mesh)).toEqual(declared("MeshReport", reports));
  expect(fields(mesh.kinds)).toEqual(["circular", "conical"]);
  for (const kind of Object.values(mesh.kinds))
    expect(fields(kind)).toEqual(declared("KindDefects", reports));
  expect(mesh).toMatchObject({ vertices: 81, faces: 64, faceSizes: { 4: 64 }, warnings: [] });
  const [x = 0, y = 0, z = 0] = session.basePositions().subarray(3 * 40);
  const target = Float64Array.of(40, x, y, z + 0.5);
  expect(session.setOptions({ ...DEFAULT_SETTINGS, limits: ["fold=80"] })).toBe("");
  expect(session.edit(module.EditMode.solve, target, new Int32Array(0), 0, 1)).toBe("");
  const shape = session.shapeReport();
  expect(fields(shape)).toEqual(declared("ShapeReport", reports));
  expect(fields(shape.sharpestFold)).toEqual(declared("SharpestFold", reports));
  expect(fields(shape.motion)).toEqual(declared("MotionRange", reports));
  const few = declared("FewestFound", read("planish_fewest"));
  expect(fields(module.fewestFound(session))).toEqual(few);
  expect(fields(shape.optimality)).toEqual(declared("Optimality", reports));
  expect(fields(shape.bounds)).toEqual(["fold"]);
  expect(shape.movedVertices).toBe(session.moved().length);
  expect(shape.residuals.every((residual) => residual >= 0)).toBe(true);
  expect(structuredClone(shape)).toEqual(shape);
  expect(session.setOptions(DEFAULT_SETTINGS)).toBe("");
  expect(session.edit(module.EditMode.solve, target, new Int32Array(0), 0, 1)).toBe("");
  expect(session.explore({ asked: 2, eigenbasis: false })).toBe("");
  const variations = session.variationsReport();
  expect(fields(variations)).toEqual(declared("VariationsReport", reports));
  session.delete();
});

it("declares every field of a mesh with panels made more alike, and says what is wrong", async () => {
  const session = new (await loadPlanish()).Session();
  expect(session.openSample("vault", 9)).toBe("");
  const documents = await loadDocuments();
  const asked = {
    types: 0,
    within: 0.01,
    move: 0.05,
    mirrored: false,
    keepBoundary: true,
    tolerance: 1e-6,
    limits: ["fold=80"],
  };
  const said: number[] = [];
  const mesh = documents.alike(session.write("obj"), asked, (steps) => said.push(steps));
  expect(Object.keys(mesh).sort()).toEqual(declared("AlikeMesh", read("planish_alike")));
  expect(mesh.after).toBeLessThanOrEqual(mesh.before);
  expect(said.length).toBeGreaterThan(0);
  expect(said).toEqual(said.toSorted((a, b) => a - b));
  const none = { ...asked, within: 0 };
  const { problem } = documents.alike(session.write("obj"), none, () => {});
  expect(problem).toBe("within must be greater than 0");
  session.delete();
});

it("declares every option of the core, in types and words", async () => {
  const session = new (await loadPlanish()).Session();
  for (const reach of [-1, 2.5, 1e20])
    expect(session.setOptions({ ...DEFAULT_SETTINGS, reach })).toMatch(/^reach must be/);
  session.delete();
  const { options: rows, kinds } = (await loadDocuments()).defaults();
  expect(Object.keys(kinds).sort()).toEqual([...KINDS]);
  const values = read("package/src/edit-values", "ts");
  const designs = values + read("planish_designs");
  expect(designs).toContain("interface EditOptions extends EditValues {");
  const own = declared("EditOptions extends EditValues", designs);
  expect(rows.map(({ key }) => key).sort()).toEqual(
    [...own, ...declared("EditValues", values)].sort(),
  );
  for (const { key, usual, words } of rows) {
    const type = new RegExp(`readonly ${key}: ([^;]*);`).exec(designs)?.[1];
    const said = words ? words.map((word) => `"${word}"`).join(" | ") : typeof usual;
    expect(type, key).toBe(Array.isArray(usual) ? "readonly string[]" : said);
  }
});

it("a replay gives the bits of its steps, and is known by its mark", async () => {
  const module = await loadPlanish();
  const [steps, whole] = [new module.Session(), new module.Session()];
  for (const session of [steps, whole]) expect(session.openSample("vault", 15)).toBe("");
  const [x = 0, y = 0, z = 0] = steps.basePositions().subarray(3 * 112);
  const handles = [112, x, y, z + 0.8];
  const { supports: _, continuation: __, symmetry: ___, cuts: ____, ...options } = FIRST_SETTINGS;
  expect(steps.setOptions(options)).toBe("");
  const to = Float64Array.from(handles);
  expect(steps.edit(module.EditMode.solve, to, new Int32Array(0), 0, 1)).toBe("");
  const coefficients = [0.3, -0.2, 0.1];
  const weights = { ...variationWeights, fairness: 8, spread: 3, family: 6 };
  const family = { asked: 3, eigenbasis: true, weights };
  expect(steps.explore({ asked: 3, eigenbasis: true })).toBe("");
  const usual = steps.variationDisplacements();
  expect(steps.explore(family)).toBe("");
  expect(steps.variationDisplacements()).not.toEqual(usual);
  expect(steps.vary(Float64Array.from(coefficients))).toBe("");
  expect(steps.makeExact()).toBe("");
  const mark = module.markOf(steps.moved(), steps.movedPositions());
  const design = {
    source: { sample: "vault", size: 15 },
    planarised: null,
    unit: "m",
    handles,
    pins: [],
    supports: [],
    continuation: 0,
    symmetry: [],
    cuts: [],
    options,
    variations: [{ ...family, coefficients }],
    result: mark,
  };
  expect(whole.replay(design, whole.baseHash())).toBe("");
  expect(whole.movedPositions()).toEqual(steps.movedPositions());
  expect(whole.replayed()).toMatchObject({ directions: Int32Array.of(3), deviation: 0 });
  const glb = await loadDocuments();
  const { design: again } = glb.readDesign(glb.writeDesign(design));
  expect(again).toMatchObject({
    ...design,
    variations: [{ ...design.variations[0], plain: true }],
  });
  for (const session of [steps, whole]) session.delete();
});

it("marks a shape as the first links did", async () => {
  const { markOf } = await loadPlanish();
  const positions = Float64Array.of(0.1, 0.2, 0.3, 1 / 3, 2 / 3, 1);
  expect(markOf(Int32Array.of(3, 7), positions)).toEqual({
    hash: 2756894708,
    moved: 2,
    probes: [3, 0.1, 0.2, 0.3, 7, 0.333333333333, 0.666666666667, 1],
  });
});

it("declares every bound member of MobilityMap; its rows are those of the command line", async () => {
  const { openMap, Session } = await loadPlanish();
  const session = new Session();
  expect(session.openSample("vault", 16)).toBe("");
  const mesh = [session.basePositions(), session.faceOffsets(), session.faceVertices()] as const;
  const settings = { ...DEFAULT_SETTINGS, softness: 5, keepBoundary: true, reach: 6 };
  const { map } = openMap(...mesh, settings);
  if (!map) throw new Error("no map");
  const text = read("planish_mobility");
  expect(boundTo(map)).toEqual(declared("MobilityMap", text));
  const rows = map.measure(100);
  expect(rows.map((row) => Object.keys(row).sort())).toEqual(
    rows.map(() => declared("MobilityValue", read("package/src/planish_package", "d.mts"))),
  );
  // planish mobility vault.obj --vertices 100 --softness 5 --keep-boundary, see 0035 for what it is.
  expect(rows.map(({ remake }) => remake)).toEqual([112, 112, 109, 109]);
  expect(map.best(3)).toEqual([rows[1]]);
  const refused = openMap(...mesh, { ...settings, tolerance: -1 });
  expect(refused.problem).toMatch(/tolerance/);
  map.delete();
  session.delete();
});

it("declares every bound member of Analysis; it measures what a session shows", async () => {
  const { Analysis, FairnessKind, Session } = await loadPlanish();
  const session = new Session();
  expect(session.openSample("vault", 9)).toBe("");
  const analysis = new Analysis(
    session.basePositions(),
    session.faceOffsets(),
    session.faceVertices(),
    session.beforePlanarising(),
  );
  expect(boundTo(analysis)).toEqual(declared("Analysis", read("planish_analysis")));
  const middle = 40;
  const [x = 0, y = 0, z = 0] = session.basePositions().subarray(3 * middle);
  analysis.show(Int32Array.of(middle), Float64Array.of(x, y, z + 0.5));
  const figures = analysis.panelFigures();
  expect(figures.length).toBe(3 * 64);
  expect(figures.filter((mmPerM, k) => k % 3 === 1 && mmPerM > 1).length).toBe(4);
  expect(analysis.panelHealth().filter((flag, k) => k % 4 === 3 && flag === 1).length).toBe(4);
  expect(analysis.panelDamage()).toEqual(new Uint8Array(64));
  analysis.show(Int32Array.of(middle), Float64Array.of(x + 9, y, z));
  expect(analysis.panelDamage().filter((damage) => damage > 0).length).toBeGreaterThan(0);
  analysis.show(Int32Array.of(middle), Float64Array.of(x, y, z + 0.5));
  expect(analysis.vertexBending(FairnessKind.second)[middle]).toBeCloseTo(1, 6);
  const freedom = analysis.freedom(Float64Array.of(middle, x, y, z + 1), new Int32Array(0));
  const declaredFields = declared("FreedomReport", read("planish_analysis"));
  expect(Object.keys(freedom ?? {}).sort()).toEqual(declaredFields);
  analysis.delete();
  session.delete();
});

it.each(["EditMode"] as const)("declares every value of %s", async (name) => {
  const module = await loadPlanish();
  const line = new RegExp(`${name}: \\{(.*)\\};`).exec(declarations)?.[1] ?? "";
  const names = [...line.matchAll(/(\w+): EnumValue/g)].map((match) => match[1]);
  const values = module[name] as Record<string, { value?: number }>;
  const bound = Object.keys(values).filter((key) => typeof values[key]?.value === "number");
  expect(bound.filter((key) => key !== "values").sort()).toEqual(names.sort());
});

it("stays a page long", () => {
  expect(declarations.split("\n").length).toBeLessThanOrEqual(110);
});
