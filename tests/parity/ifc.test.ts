// SPDX-License-Identifier: MIT
// IFC models, read again by web-ifc, which knows nothing of ours.
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { afterAll, beforeAll, expect, it } from "vitest";
import {
  IFCCURTAINWALL,
  IFCPLATE,
  IFCPROPERTYSINGLEVALUE,
  IFCRELAGGREGATES,
  IfcAPI,
} from "web-ifc";

const CLI = new URL("../../build/native/planish", import.meta.url).pathname;

const reader = new IfcAPI();
let folder: string;
beforeAll(async () => {
  folder = mkdtempSync(join(tmpdir(), "planish-ifc-"));
  await reader.Init();
});
afterAll(() => rmSync(folder, { recursive: true }));

const command = (words: string) => execFileSync(CLI, words.split(" "), { cwd: folder });
const open = (name: string): number =>
  reader.OpenModel(new Uint8Array(readFileSync(join(folder, name))));
const idsOf = (model: number, type: number): number[] => [
  ...reader.GetLineIDsWithType(model, type),
];

interface Plate {
  readonly guid: string;
  readonly name: string;
  /** Of its triangles as the reader makes them, square metres. */
  readonly surface: number;
}

/** Area of the triangles that web-ifc makes of one plate. */
function surfaceOf(model: number, plate: number): number {
  const flat = reader.GetFlatMesh(model, plate);
  let area = 0;
  for (let k = 0; k < flat.geometries.size(); ++k) {
    const placed = flat.geometries.get(k);
    const geometry = reader.GetGeometry(model, placed.geometryExpressID);
    const corners = reader.GetVertexArray(geometry.GetVertexData(), geometry.GetVertexDataSize());
    const triangles = reader.GetIndexArray(geometry.GetIndexData(), geometry.GetIndexDataSize());
    const scale = Math.hypot(...placed.flatTransformation.slice(0, 3));
    for (let t = 0; t < triangles.length; t += 3) {
      const [a, b, c] = [0, 1, 2].map((i) => {
        const at = 6 * (triangles[t + i] ?? 0); // each with its normal
        return [...corners.subarray(at, at + 3)];
      }) as [number[], number[], number[]];
      const u = b.map((x, i) => x - (a[i] ?? 0)) as [number, number, number];
      const v = c.map((x, i) => x - (a[i] ?? 0)) as [number, number, number];
      const cross = [
        u[1] * v[2] - u[2] * v[1],
        u[2] * v[0] - u[0] * v[2],
        u[0] * v[1] - u[1] * v[0],
      ];
      area += 0.5 * scale * scale * Math.hypot(...cross);
    }
  }
  return area;
}

const platesOf = (model: number): Plate[] =>
  idsOf(model, IFCPLATE).map((id) => {
    const plate = reader.GetLine(model, id);
    return {
      guid: plate.GlobalId.value,
      name: plate.Name.value,
      surface: surfaceOf(model, id),
    };
  });

const propertiesOf = (model: number, name: string) =>
  idsOf(model, IFCPROPERTYSINGLEVALUE)
    .map((id) => reader.GetLine(model, id))
    .filter((line) => line.Name.value === name)
    .map((line) => line.NominalValue.value);

it.each(["vault", "dome", "freeform", "hex", "trihex"])("of %s", (sample) => {
  command(`panels sample:${sample}:10 -o flat.ifc --report r.json`);
  const count = JSON.parse(readFileSync(join(folder, "r.json"), "utf8")).counts.panels;
  const model = open("flat.ifc");
  expect(idsOf(model, IFCCURTAINWALL)).toHaveLength(1);
  const plates = platesOf(model);
  expect(plates).toHaveLength(count);
  expect(new Set(plates.map(({ guid }) => guid)).size).toBe(count);
  const whole = idsOf(model, IFCRELAGGREGATES).map((id) => reader.GetLine(model, id));
  expect(whole.map((line) => line.RelatedObjects.length)).toContain(count);
  const areas = propertiesOf(model, "Area");
  expect(areas).toHaveLength(count);
  // A triangulated panel has the area of its outline: web-ifc has single precision.
  plates.forEach(({ surface }, k) => {
    expect(Math.abs(surface - areas[k]) / areas[k]).toBeLessThan(1e-6);
  });
  expect(propertiesOf(model, "FlatnessMmPerM").every((value) => value < 1e-6)).toBe(true);
  reader.CloseModel(model);
});

it("solid plates have both faces and their edges", () => {
  command("panels sample:hex:8 -o flat.ifc");
  command("panels sample:hex:8 -o solid.ifc --thickness 10 --unit mm");
  const [flat, solid] = [open("flat.ifc"), open("solid.ifc")];
  const [thin, thick] = [platesOf(flat), platesOf(solid)];
  expect(thick.map(({ guid }) => guid)).toEqual(thin.map(({ guid }) => guid));
  command("panels sample:hex:8 -o p.zip");
  execFileSync("python3", ["-m", "zipfile", "-e", "p.zip", "."], { cwd: folder });
  const { panels } = JSON.parse(readFileSync(join(folder, "package.json"), "utf8"));
  thick.forEach(({ surface }, k) => {
    const expected = (2 * panels[k].area + 10 * panels[k].perimeter) / 1e6;
    expect(Math.abs(surface - expected) / expected).toBeLessThan(1e-5);
  });
});

it("identifiers stay when the design is edited and saved again", () => {
  command("edit sample:dome:10 --handle 44+=0,0,0.3 --design d.json -o d.glb");
  command("panels d.json -o edited.ifc");
  command("panels sample:dome:10 -o base.ifc");
  const [edited, base] = [open("edited.ifc"), open("base.ifc")];
  expect(platesOf(edited).map(({ guid, name }) => [guid, name])).toEqual(
    platesOf(base).map(({ guid, name }) => [guid, name]),
  );
  const changes = propertiesOf(edited, "Change");
  expect(changes.filter((change) => change === "outline").length).toBeGreaterThan(3);
  expect(propertiesOf(base, "Change")).toEqual([]);
});
