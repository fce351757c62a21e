// SPDX-License-Identifier: MIT
// Designs as text: every recipe of the paper's page is read, and whatever else comes gives a design
// or one sentence that names the field.
import { readdirSync, readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";
import { fromDesign } from "../../web/src/design/design-value.ts";
import { loadDocuments } from "../parity/support/planish.ts";
import { Damage } from "./support/mutations.ts";

const INPUTS = Number(process.env.PLANISH_FUZZ_INPUTS ?? 5_000);
const SEED = Number(process.env.PLANISH_SEED ?? 20_260_101);

/** As the page reads one: the core by its module for files, then what the page can show of it. */
const core = await loadDocuments();
const readDesign = (text: string) => fromDesign(core.readDesign(text));

const FOLDER = new URL("../../docs/scenes/", import.meta.url);
const TEXTS = readdirSync(FOLDER)
  .filter((name) => /^figure-.*\.json$/.test(name))
  .map((name) => readFileSync(new URL(name, FOLDER), "utf8"));

const GIVEN = { sample: "vault", size: 9 };
const text = (change: object): string =>
  JSON.stringify({ format: "planish-design", version: 1, source: GIVEN, ...change });
const reason = (given: string): string => {
  const read = readDesign(given);
  return read.ok ? "" : read.reason;
};

it("reads every recipe of the paper's figures", () => {
  expect(TEXTS.length).toBeGreaterThan(20);
  for (const recipe of TEXTS) expect(reason(recipe)).toBe("");
});

it("takes what may be left out as it is documented", () => {
  const read = readDesign(text({}));
  if (!read.ok) throw new Error(read.reason);
  const { mark, handles, families, unit, planarised, settings } = read.value;
  expect([mark, handles, families, unit, planarised]).toEqual([null, [], [], "m", null]);
  expect([settings.attraction, settings.sparsity, settings.tolerance]).toEqual([1000, "l21", 1e-6]);
});

it("reads what points stand on, as the core says it", () => {
  const slides = (supports?: string[]) => {
    const read = readDesign(text({ supports }));
    return read.ok ? read.value.settings.supports : read.reason;
  };
  expect(slides()).toEqual([]);
  for (const known of [
    [],
    ["level=z:boundary"],
    ["outline:boundary"],
    ["level=x:3,4,5", "level=y:3", "outline:boundary"],
    ["plane=1,0,0,-0.5:3", "line=0,0,1e-07,0,0,1:4", "level=z:all"],
  ])
    expect(slides(known)).toEqual(known);
  expect(slides(["level:boundary"])).toEqual(["level=z:boundary"]);
});

it("reads the steps of an edit, and refuses what are none", () => {
  const steps = (continuation?: unknown) => {
    const read = readDesign(text({ continuation }));
    return read.ok ? read.value.settings.continuation : read.reason;
  };
  expect([steps(), steps(0), steps(16)]).toEqual([0, 0, 16]);
  for (const odd of [-1, 1.5, 1001, "8"]) expect(steps(odd)).toMatch(/^continuation must be /);
});

it("reads limits that the page has controls for, as the core says them", () => {
  const limits = (bounds?: unknown, more: object = {}) => {
    const read = readDesign(text({ options: { bounds }, ...more }));
    return read.ok ? read.value.settings.limits : read.reason;
  };
  expect(limits()).toEqual([]);
  const all = ["fold=25", "fold=+5", "angle=60:120", "edge=0.5:2", "area=0.001", "sheet=2x3"];
  expect(limits(all)).toEqual(all);
  expect(limits(["area=1e-3"])).toEqual(["area=0.001"]);
  expect(limits(["flat=2"])).toMatch(/^options\.bounds\[0\] must be one of fold=MAX/);
  expect(limits(["fold=25", "fold=30"])).toMatch(/^options\.bounds: this page knows each/);
  expect(limits(["fold=-5"])).toMatch(/^options: bounds: fold must be greater than 0/);
  expect(limits(["edge=2"])).toMatch(/^options\.bounds\[0\] must be one of fold=MAX/);
  expect(limits([5])).toMatch(/^options\.bounds\[0\] must be a text/);
  expect(limits("fold=25")).toMatch(/^options\.bounds must be a list/);
  const variations = [{ dimension: 1, coefficients: [1], exact: true }];
  expect(limits(["fold=25"], { variations })).toEqual(["fold=25"]);
});

it("reads the kinds that are kept, each with its tolerance", () => {
  const kinds = (constraints?: unknown, more: object = {}) => {
    const read = readDesign(text({ options: { constraints }, ...more }));
    return read.ok ? read.value.settings.constraints : read.reason;
  };
  const circular = { kind: "circular", tolerance: 1e-9 };
  expect(kinds()).toEqual([]);
  const both = [circular, { kind: "conical", tolerance: 0.001 }];
  expect(kinds(both)).toEqual(["circular:1e-9", "conical:0.001"]);
  const odd = [
    [circular, circular],
    [{ kind: "conical", tolerance: 0 }],
    [{ kind: "circular" }],
    5,
  ];
  for (const constraints of odd) expect(kinds(constraints)).toMatch(/^options(\.|: )constraints/);
  const variations = [{ dimension: 1, coefficients: [1], exact: true }];
  expect(kinds([circular], { variations })).toEqual(["circular:1e-9"]);
});

it("reads how a mesh became flat, and what older designs mean by true", () => {
  const how = (planarised: unknown) => {
    const read = readDesign(text({ planarised }));
    return read.ok ? read.value.planarised : read.reason;
  };
  expect(how(false)).toBe(null);
  expect(how(true)).toEqual({
    smooth: 0,
    keepBoundary: false,
    keepShape: false,
    constraints: [],
    within: 0,
    flat: 0,
  });
  expect(how({ smooth: 10, shape: true })).toEqual({
    smooth: 10,
    keepBoundary: false,
    keepShape: true,
    constraints: [],
    within: 0,
    flat: 0,
  });
  const circular = { kind: "circular", tolerance: 1e-9 };
  expect(how({ constraints: [circular] })).toMatchObject({ constraints: ["circular:1e-9"] });
  const twice = how({ constraints: [circular, circular] });
  expect(twice).toMatch(/^planarised: constraints: circular is given twice/);
  expect(how({ smooth: -1 })).toMatch(/smooth must be a number of at least 0/);
  expect(how({ fair: 1 })).toMatch(/fair is not a field/);
});

it("takes the mesh that rides along", async () => {
  const mesh = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
  const source = { file: "a.obj", hash: "0012abcd", format: "obj", bytes: btoa(mesh) };
  const read = readDesign(text({ source }));
  if (!read.ok || read.value.source?.kind !== "file") throw new Error("no file");
  expect(await read.value.source.bytes.text()).toBe(mesh);
  expect(read.value.baseHash).toBe(0x12abcd);
  const beside = readDesign(text({ source: { file: "a.obj", hash: "0012abcd" } }));
  expect(beside.ok && [beside.value.source, beside.value.meshName]).toEqual([null, "a.obj"]);
});

describe("names the field that is wrong", () => {
  const cases: readonly (readonly [string, RegExp])[] = [
    ["{", /not JSON/],
    ["[]", /^the design must be an object/],
    ['{"a":1}', /^format is missing: it must be planish-design/],
    ["{}", /^format is missing/],
    ['{"format":"plan"}', /^format must be planish-design/],
    [text({ version: 7 }), /version 7/],
    [text({ version: { toString: null } }), /version/],
    [text({ handel: [] }), /handel is not a field/],
    [
      text({ options: { constraints: [{ kind: "round", tolerance: 1e-9 }] } }),
      /^options: constraints: a kind must be one of circular, conical/,
    ],
    [text({ supports: ["level=w:boundary"] }), /^supports\[0\] must be one of level:POINTS/],
    [text({ supports: "level=z:boundary" }), /^supports must be a list/],
    [text({ options: { keep_out: ["selves"] } }), /^options\.keep_out\[0\] must be one of below=Z/],
    [text({ symmetry: ["x,y"] }), /^symmetry\[0\] must be x, y, z or axis/],
    [text({ symmetry: "x" }), /^symmetry must be a list/],
    [text({ handles: [[1, 2, 3]] }), /handles\[0\]/],
    [text({ handles: {} }), /handles/],
    [text({ pins: [-1] }), /pins/],
    [text({ unit: "furlong" }), /unit must be/],
    [text({ options: { solver: "magic" } }), /options\.solver/],
    [text({ options: { locality: -1 } }), /^options: locality must be a number of at least 0/],
    [
      text({ variations: [{ dimension: 99, coefficients: [] }] }),
      /^variations\[0\]: dimension must be 1 to 24/,
    ],
    [text({ variations: [{ dimension: 1, coefficients: [1, 2] }] }), /coefficients/],
    [text({ variations: Array(33).fill({}) }), /variations must be a list of at most 32/],
    [text({ result: { hash: "xyz" } }), /result\.hash/],
    [text({ source: { sample: "vault" } }), /source/],
    [text({ source: { file: "a", format: "dwg", bytes: "AA==" } }), /source\.format/],
    [text({ source: { file: "a", format: "obj", bytes: "é" } }), /source\.bytes/],
    [text({ source: { file: "a", hash: 5 } }), /source\.hash/],
  ];
  it.each(cases)("%s", (given, sentence) => {
    expect(reason(given)).toMatch(sentence);
  });
});

it("any damage gives a design or a short sentence", () => {
  const damage = new Damage(SEED);
  let refused = 0;
  for (let k = 0; k < INPUTS; ++k) {
    const whole = damage.pick(TEXTS);
    const bytes = new TextEncoder().encode(whole);
    const given = damage.chance(0.7)
      ? JSON.stringify(damage.json(JSON.parse(whole)))
      : new TextDecoder().decode(damage.bytes(bytes, bytes));
    const said = reason(given);
    if (said) refused += 1;
    if (said) expect(said).toMatch(/^[^\n]{10,200}\.$/);
  }
  expect(refused).toBeGreaterThan(INPUTS / 4);
});
