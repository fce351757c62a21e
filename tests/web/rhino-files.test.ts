// SPDX-License-Identifier: MIT
// Rhino files of other people: their units, outlines drawn twice, meshes turned both ways, quads that
// are parts of panels.
import { existsSync } from "node:fs";
import { readFile } from "node:fs/promises";
import type { ObjectAttributes } from "rhino3dm";
import { beforeAll, describe, expect, it } from "vitest";
import type { RhinoModule } from "../../web/src/rhino/model.ts";
import { type ReadModel, readModel, writeObj } from "../../web/src/rhino/read-model.ts";
import type { JoinPoints } from "../../web/src/rhino/weld.ts";
import { loadDocuments, loadPlanish } from "../parity/support/planish.ts";
import { loadRhino } from "../parity/support/rhino.ts";

let rhino: RhinoModule;
let join: JoinPoints;
beforeAll(async () => {
  rhino = await loadRhino();
  join = (await loadDocuments()).joinedPoints;
});

type Point = readonly [number, number, number];
const SQUARE: readonly Point[] = [
  [0, 0, 0],
  [1, 0, 0],
  [1, 1, 0],
  [0, 1, 0],
];
const BESIDE: readonly Point[] = SQUARE.map(([x, y, z]) => [x + 1, y, z + 0.1 * x] as const);
const regular = (corners: number): readonly Point[] =>
  Array.from({ length: corners }, (_, k) => [
    Math.cos((k * 2 * Math.PI) / corners),
    Math.sin((k * 2 * Math.PI) / corners),
    0,
  ]);

type Part =
  | { readonly outline: readonly Point[] }
  | { readonly points: readonly Point[]; readonly faces: readonly (readonly number[])[] };

/** A file of these, read again. */
function read(system: string, parts: readonly Part[]): ReadModel {
  const file = new rhino.File3dm();
  const systems = rhino.UnitSystem as unknown as Record<string, never>;
  file.settings().modelUnitSystem = systems[system] as never;
  const attributes = new rhino.ObjectAttributes() as ObjectAttributes;
  for (const part of parts) {
    if ("outline" in part) {
      const list = new rhino.Point3dList(part.outline.length + 1);
      for (const [x, y, z] of [...part.outline, ...part.outline.slice(0, 1)]) list.add(x, y, z);
      file.objects().addCurve(new rhino.PolylineCurve(list), attributes);
      continue;
    }
    const mesh = new rhino.Mesh();
    mesh.vertices().useDoublePrecisionVertices = true;
    for (const [x, y, z] of part.points) mesh.vertices().addPoint3d(x, y, z);
    for (const [a = 0, b = 0, c = 0, d] of part.faces)
      if (d === undefined) mesh.faces().addTriFace(a, b, c);
      else mesh.faces().addQuadFace(a, b, c, d);
    file.objects().addMesh(mesh, attributes);
  }
  return readModel(rhino, file.toByteArray(), join);
}

const QUAD = [[0, 1, 2, 3]];

describe("the unit of a file", () => {
  it.each([
    ["Decimeters", "cm", 10, 1, "decimetres"],
    ["Microns", "mm", 1, 1000, "microns"],
    ["Yards", "ft", 3, 1, "yards"],
    ["Mils", "in", 1, 1000, "mils"],
    ["Hectometers", "m", 100, 1, "hectometres"],
    ["Miles", "ft", 5280, 1, "miles"],
    ["PrinterPoints", "in", 1, 72, "points of printers"],
    ["NauticalMiles", "m", 1852, 1, "nautical miles"],
    ["Parsecs", "km", 30856775814913.7, 1, "parsecs"],
  ])("%s are read in a unit that the page has", (system, unit, times, per, word) => {
    const { mesh, unit: known, remarks } = read(system, [{ points: SQUARE, faces: QUAD }]);
    expect(known).toBe(unit);
    expect([...mesh.points]).toEqual(SQUARE.flat().map((c) => (c * times) / per));
    expect(remarks).toHaveLength(1);
    expect(remarks[0]).toContain(`in ${word}, which the page does not have`);
  });

  it("stays what it is where the page has it", () => {
    for (const [system, unit] of [
      ["Millimeters", "mm"],
      ["Meters", "m"],
      ["Feet", "ft"],
    ] as const) {
      const model = read(system, [{ points: SQUARE, faces: QUAD }]);
      expect([model.unit, model.remarks, [...model.mesh.points]]).toEqual([
        unit,
        [],
        SQUARE.flat(),
      ]);
    }
  });

  it("is asked for where the file has none, or one of its own", () => {
    for (const system of ["None", "CustomUnits", "Unset"]) {
      const model = read(system, [{ points: SQUARE, faces: QUAD }]);
      expect(model.unit).toBeNull();
      expect(model.remarks[0]).toMatch(/does not say its unit, or has one of its own/);
    }
  });

  it("holds for what lies beside the panels", () => {
    const panel = { points: SQUARE, faces: QUAD };
    const { context } = read("Decimeters", [panel, { outline: BESIDE }]);
    expect(Math.max(...(context?.lines ?? []))).toBe(20);
  });
});

describe("panels of a file", () => {
  it("of meshes drawn twice are read once, too", () => {
    const panel = { points: SQUARE, faces: QUAD };
    const { mesh, remarks } = read("Meters", [panel, { points: BESIDE, faces: QUAD }, panel]);
    expect(mesh.faces).toHaveLength(2);
    expect(remarks).toEqual(["1 panel drawn twice read once."]);
  });

  it("drawn twice are read once, either way round and from any corner", () => {
    const again = [SQUARE, SQUARE.toReversed(), [...SQUARE.slice(1), SQUARE[0] as Point]];
    for (const outline of again) {
      const { mesh, remarks } = read("Meters", [
        { outline: SQUARE },
        { outline: BESIDE },
        { outline },
      ]);
      expect(mesh.faces).toHaveLength(2);
      expect(remarks).toContain("1 panel drawn twice read once.");
    }
  });

  it("are turned so that neighbours agree, which is said of meshes", () => {
    const turned = { points: BESIDE, faces: [[0, 3, 2, 1]] };
    const { mesh, remarks } = read("Meters", [{ points: SQUARE, faces: QUAD }, turned]);
    expect(mesh.faces).toEqual(
      [
        [0, 1, 2, 3],
        [1, 4, 5, 2],
      ].map((face) => expect.arrayContaining(face)),
    );
    expect(remarks).toContain("1 face turned over so that neighbours agree.");
    const alone = { points: SQUARE.map(([x, y, z]) => [x + 9, y, z] as const), faces: QUAD };
    const apart = read("Meters", [{ points: SQUARE, faces: QUAD }, turned, alone]);
    expect(apart.remarks).toContain("1 face turned over so that neighbours agree.");
    const below = { points: BESIDE, faces: [[3, 2, 1, 0]] };
    const first = read("Meters", [{ points: SQUARE, faces: [[3, 2, 1, 0]] }, below, turned]);
    expect(first.remarks[0]).toMatch(/drawn twice read once/);
    const agreeing = read("Meters", [
      { points: SQUARE, faces: QUAD },
      { points: BESIDE, faces: QUAD },
    ]);
    expect(agreeing.remarks).toEqual([]);
  });

  it.each([
    [
      "a hexagon of two quads",
      6,
      [
        [0, 1, 2, 3],
        [0, 3, 4, 5],
      ],
    ],
    [
      "a hexagon of a quad and two triangles",
      6,
      [
        [0, 1, 2, 3],
        [0, 3, 4],
        [0, 4, 5],
      ],
    ],
    [
      "a pentagon of a quad and a triangle",
      5,
      [
        [0, 1, 2, 3],
        [0, 3, 4],
      ],
    ],
    [
      "an octagon of three quads",
      8,
      [
        [0, 1, 2, 3],
        [0, 3, 4, 7],
        [4, 5, 6, 7],
      ],
    ],
  ])("that may be one are named, and stay: %s", (_, corners, faces) => {
    const { mesh, remarks } = read("Meters", [{ points: regular(corners), faces }]);
    expect(mesh.faces.map((face) => face.length)).toEqual(faces.map((face) => face.length));
    expect(remarks[0]).toMatch(/^1 group of quads in one plane may be one panel each/);
  });

  it("that are triangles in one plane are put together, but not around a point inside", () => {
    const points = regular(6);
    const fan = [1, 2, 3, 4].map((k) => [0, k, k + 1]);
    const one = read("Meters", [{ points, faces: fan }]);
    expect(one.mesh.faces.map((face) => face.length)).toEqual([6]);
    expect(one.remarks[0]).toMatch(/^1 panel of five and more corners put together/);
    const around = points.map((_, k) => [6, k, (k + 1) % 6]);
    const wheel = read("Meters", [{ points: [...points, [0, 0, 0]], faces: around }]);
    expect(wheel.mesh.faces.map((face) => face.length)).toEqual(Array(6).fill(3));
    expect(wheel.remarks[0]).toMatch(/^1 group of coplanar triangles stayed triangles/);
  });

  it("that are quads in one plane with a straight or hollow outline are panels", () => {
    const row = { points: SQUARE.map(([x, y]) => [x + 1, y, 0] as const), faces: QUAD };
    expect(read("Meters", [{ points: SQUARE, faces: QUAD }, row]).remarks).toEqual([]);
    const above = { points: SQUARE.map(([x, y]) => [x, y + 1, 0] as const), faces: QUAD };
    expect(read("Meters", [{ points: SQUARE, faces: QUAD }, row, above]).remarks).toEqual([]);
  });
});

const CASES = new URL("../../../shared/cases/", import.meta.url);

/** Of each shared file: its panels, and what is said first. */
const SHARED = [
  ["3dm-in-decimetres.3dm", 4, /in decimetres, which the page does not have/],
  ["3dm-in-microns.3dm", 4, /in microns, which the page does not have/],
  ["3dm-polylines-drawn-twice.3dm", 4, /^4 panels drawn twice read once\.$/],
  ["3dm-hexagons-of-two-quads.3dm", 74, /^37 groups of quads in one plane may be one panel each/],
  ["3dm-meshes-turned-both-ways.3dm", 4, /turned over so that neighbours agree\.$/],
] as const;

describe.skipIf(!existsSync(CASES))("a shared file opens, and says why it looks as it does", () => {
  it.each(SHARED)("%s", async (name, panels, said) => {
    const { mesh, remarks } = readModel(rhino, await readFile(new URL(name, CASES)), join);
    expect(mesh.faces).toHaveLength(panels);
    expect(remarks[0]).toMatch(said);
    const session = new (await loadPlanish()).Session();
    expect(session.openFile(writeObj(mesh), "obj")).toBe("");
    expect(session.meshReport().warnings).toEqual([]);
    session.delete();
  });
});
