// SPDX-License-Identifier: MIT
// planish.d.ts is written by hand; this holds it to what the module really has.
import { readFileSync } from "node:fs";
import { expect, it } from "vitest";
import { loadAnalysis, loadPlanish } from "./support/planish.ts";

const read = (name: string): string =>
  readFileSync(new URL(`../../wasm/${name}.d.ts`, import.meta.url), "utf8");
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
  expect(session.setLimits("fold=80")).toBe("");
  expect(session.edit(module.EditMode.solve, target, new Int32Array(0), 0, 1)).toBe("");
  const shape = session.shapeReport();
  expect(fields(shape)).toEqual(declared("ShapeReport", reports));
  expect(fields(shape.sharpestFold)).toEqual(declared("SharpestFold", reports));
  expect(fields(shape.optimality)).toEqual(declared("Optimality", reports));
  expect(fields(shape.bounds)).toEqual(["fold"]);
  expect(shape.movedVertices).toBe(session.moved().length);
  expect(shape.residuals.every((residual) => residual >= 0)).toBe(true);
  expect(structuredClone(shape)).toEqual(shape);
  expect(session.setLimits("")).toBe("");
  expect(session.edit(module.EditMode.solve, target, new Int32Array(0), 0, 1)).toBe("");
  const options = {
    dimension: 2,
    fairnessWeight: 3,
    sparsityWeight: 1,
    closenessWeight: 0,
    correlation: 0.95,
    reach: 2,
    eigenbasis: false,
    fairness: module.FairnessKind.second,
    engine: module.Engine.newton,
  };
  expect(session.explore(options)).toBe("");
  const variations = session.variationsReport();
  expect(fields(variations)).toEqual(declared("VariationsReport", reports));
  expect(variations.supportSizes.length).toBe(variations.dimension);
  session.delete();
});

it("declares every bound member of Analysis; it measures what a session shows", async () => {
  const { Session } = await loadPlanish();
  const { Analysis, FairnessKind } = await loadAnalysis();
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

it.each(["EditMode", "Engine", "FairnessKind", "Sparsity"] as const)(
  "declares every value of %s",
  async (name) => {
    const module = await loadPlanish();
    const line = new RegExp(`${name}: \\{(.*)\\};`).exec(declarations)?.[1] ?? "";
    const names = [...line.matchAll(/(\w+): EnumValue/g)].map((match) => match[1]);
    const values = module[name] as Record<string, { value?: number }>;
    const bound = Object.keys(values).filter((key) => typeof values[key]?.value === "number");
    expect(bound.filter((key) => key !== "values").sort()).toEqual(names.sort());
  },
);

it("stays a page long", () => {
  expect(declarations.split("\n").length).toBeLessThanOrEqual(110);
});
