// SPDX-License-Identifier: MIT
// A design as a .3dm file, read again by McNeel's own library: the same doubles, panels that Rhino
// calls valid, and the design in it. What is read of files from elsewhere.
import type { File3dm, Mesh, ObjectAttributes, PolylineCurve } from "rhino3dm";
import { beforeAll, describe, expect, it } from "vitest";
import { csvRows } from "../../web/src/rhino/csv-rows.ts";
import { type RhinoModule, unitSystem } from "../../web/src/rhino/model.ts";
import { readModel, writeObj } from "../../web/src/rhino/read-model.ts";
import type { JoinPoints } from "../../web/src/rhino/weld.ts";
import { type Model, writeModel } from "../../web/src/rhino/write-model.ts";
import { plainOptions } from "../../web/src/solver/cutting-options.ts";
import { loadDocuments, loadPlanish } from "./support/planish.ts";
import { loadRhino } from "./support/rhino.ts";

let rhino: RhinoModule;
let join: JoinPoints;
beforeAll(async () => {
  rhino = await loadRhino();
  join = (await loadDocuments()).joinedPoints;
});

const SHOP = plainOptions("m", "m");

/** A sample with one point raised, as the worker would hand it over. */
async function edited(sample: string, size: number, raise: number): Promise<Model> {
  const [planish, shop] = [await loadPlanish(), await loadDocuments()];
  const session = new planish.Session();
  expect(session.openSample(sample, size)).toBe("");
  const positions = session.basePositions();
  const middle = Math.floor(positions.length / 6);
  const [x = 0, y = 0, z = 0] = positions.subarray(3 * middle);
  const handle = Float64Array.of(middle, x, y, z + raise);
  expect(session.edit(planish.EditMode.solve, handle, new Int32Array(), 0, 1)).toBe("");
  const [moved, to] = [session.moved(), session.movedPositions()];
  const [offsets, vertices] = [session.faceOffsets(), session.faceVertices()];
  const parents = new Int32Array();
  const design = { base: positions, offsets, vertices, moved, movedPositions: to, parents };
  const { problem, csv } = shop.panelRows(design, SHOP);
  expect(problem).toBe("");
  moved.forEach((v, k) => {
    positions.set(to.subarray(3 * k, 3 * k + 3), 3 * v);
  });
  session.delete();
  const rows = csvRows(csv);
  const faces = rows.map((_, f) => vertices.subarray(offsets[f], offsets[f + 1]));
  return { positions, faces, rows, unit: "m", design: `{"of":"${sample} – “ü”"}` };
}

interface Item {
  readonly layer: string;
  readonly attributes: ObjectAttributes;
  readonly geometry: ReturnType<ReturnType<ReturnType<File3dm["objects"]>["get"]>["geometry"]>;
}

function itemsOf(bytes: Uint8Array): readonly Item[] {
  const file = rhino.File3dm.fromByteArray(bytes);
  return Array.from({ length: file.objects().count }, (_, k) => {
    const object = file.objects().get(k);
    const attributes = object.attributes();
    const layer = file.layers().findIndex(attributes.layerIndex).fullPath;
    return { layer, attributes, geometry: object.geometry() };
  });
}

const on = (items: readonly Item[], layer: string): readonly Item[] =>
  items.filter((item) => item.layer === `Planish::${layer}`);

const SAMPLES = ["vault", "dome", "freeform", "hex", "trihex", "roof"];

describe.each(SAMPLES)("an edited %s", (sample) => {
  it("keeps every double, and every panel is valid and has its row", async () => {
    const model = await edited(sample, 12, 0.3);
    const { bytes, surfaces, withoutSurface } = writeModel(rhino, model);
    expect([surfaces, withoutSurface]).toEqual([true, []]);
    const items = itemsOf(bytes);
    const [outlines, panels] = [on(items, "Outlines"), on(items, "Panels")];
    expect(outlines.length).toBe(model.faces.length);
    expect(panels.map((item) => item.geometry.isValid)).toEqual(model.faces.map(() => true));
    model.faces.forEach((face, f) => {
      const curve = outlines[f]?.geometry as PolylineCurve;
      const corners = [...face, face[0] ?? 0].map((v) => [
        ...model.positions.subarray(3 * v, 3 * v + 3),
      ]);
      expect(curve.isClosed && curve.isValid).toBe(true);
      expect(corners.map((_, k) => curve.point(k))).toEqual(corners);
      for (const { attributes } of [outlines[f], panels[f]] as Item[]) {
        expect(attributes.name).toBe(model.rows[f]?.panel);
        expect(Object.fromEntries(attributes.getUserStrings() as unknown as [string, string][])) //
          .toEqual(model.rows[f]);
      }
    });
    const again = model.rows.filter((row) => row.change !== "unchanged");
    expect(again.length).toBeGreaterThan(0);
    expect(on(items, "Remake").map((item) => item.attributes.name)) //
      .toEqual(again.map((row) => row.panel));
    expect(on(items, "Text").length).toBe(model.faces.length);
  });

  it("has its triangles and quads as a mesh in double precision", async () => {
    const model = await edited(sample, 12, 0.3);
    const small = model.faces.filter((face) => face.length <= 4);
    const [item] = on(itemsOf(writeModel(rhino, model).bytes), "Mesh");
    if (small.length === 0) return expect(item).toBeUndefined();
    const mesh = item?.geometry as Mesh;
    expect(mesh.isValid).toBe(true);
    expect(mesh.faces().count).toBe(small.length);
    small.forEach((face, f) => {
      const corners = mesh.faces().get(f).slice(0, face.length);
      expect(corners.map((v) => mesh.vertices().point3dAt(v))) //
        .toEqual([...face].map((v) => [...model.positions.subarray(3 * v, 3 * v + 3)]));
    });
  });

  it("is read again as the design, and as a mesh once a panel was changed elsewhere", async () => {
    const model = await edited(sample, 12, 0.3);
    const { bytes } = writeModel(rhino, model);
    const read = readModel(rhino, bytes, join);
    expect([read.design, read.unit, read.remarks]).toEqual([model.design, "m", []]);
    const corners = read.mesh.faces.map((face) =>
      face.flatMap((v) => [...read.mesh.points.slice(3 * v, 3 * v + 3)]),
    );
    expect(corners).toEqual(
      model.faces.map((face) =>
        [...face].flatMap((v) => [...model.positions.subarray(3 * v, 3 * v + 3)]),
      ),
    );
    const changed = readModel(rhino, withLiftedCorner(bytes), join);
    expect(changed.design).toBe("");
    expect(changed.remarks[0]).toMatch(/^The panels were changed after the file was saved here/);
    expect(changed.mesh.faces.length).toBe(model.faces.length);
  });
});

/** What somebody may do in Rhino: one corner of one outline, by the last digit of a metre's nanometres. */
function withLiftedCorner(bytes: Uint8Array): Uint8Array {
  const file = rhino.File3dm.fromByteArray(bytes);
  const items = itemsOf(bytes);
  const { attributes, geometry } = on(items, "Outlines")[0] as Item;
  const curve = geometry as PolylineCurve;
  const [x = 0, y = 0, z = 0] = curve.point(1);
  curve.setPoint(1, [x, y, z + 1e-9]);
  file.objects().delete(attributes.id);
  file.objects().addCurve(curve, attributes);
  return file.toByteArray();
}

type Corners = readonly (readonly [number, number, number])[];

function polyline(points: Corners): PolylineCurve {
  const list = new rhino.Point3dList(points.length + 1);
  for (const [x, y, z] of [...points, points[0] ?? [0, 0, 0]]) list.add(x, y, z);
  return new rhino.PolylineCurve(list);
}

function emptyFile(unit: "m" | "in" = "m"): File3dm {
  const file = new rhino.File3dm();
  file.settings().modelUnitSystem = unitSystem(rhino, unit);
  file.settings().modelAbsoluteTolerance = 0.001;
  return file;
}

const plain = (): ObjectAttributes => new rhino.ObjectAttributes();

function mesh(points: Corners, faces: readonly (readonly number[])[]): Mesh {
  const made = new rhino.Mesh();
  made.vertices().useDoublePrecisionVertices = true;
  for (const [x, y, z] of points) made.vertices().addPoint3d(x, y, z);
  for (const [a = 0, b = 0, c = 0, d] of faces)
    if (d === undefined) made.faces().addTriFace(a, b, c);
    else made.faces().addQuadFace(a, b, c, d);
  return made;
}

const readFaces = (file: File3dm) => readModel(rhino, file.toByteArray(), join);

describe("a file from elsewhere", () => {
  it("gives the doubles of a mesh, welded where panels touch", () => {
    const file = emptyFile("in");
    const third = 1 / 3;
    const left: Corners = [
      [0, 0, 0],
      [third, 0, 0],
      [third, 1, 0.1],
      [0, 1, 0],
    ];
    const right: Corners = [
      [third, 0, 0],
      [1, 0, 0],
      [1, 1, 0],
      [third, 1, 0.1],
    ];
    file.objects().addMesh(mesh(left, [[0, 1, 2, 3]]), plain());
    file.objects().addMesh(mesh(right, [[0, 1, 2, 3]]), plain());
    const read = readFaces(file);
    expect(read.mesh.faces).toEqual([
      [0, 1, 2, 3],
      [1, 4, 5, 2],
    ]);
    expect([...read.mesh.points]).toEqual([...left.flat(), 1, 0, 0, 1, 1, 0]);
    expect([read.unit, read.remarks, read.design]).toEqual(["in", [], ""]);
    expect(new TextDecoder().decode(writeObj(read.mesh))).toContain(`v ${third} 1 0.1\n`);
  });

  it("gives polylines as panels of one surface: welded, and turned to one side", () => {
    const file = emptyFile();
    file.objects().addCurve(
      polyline([
        [0, 0, 0],
        [1, 0, 0],
        [1, 1, 0],
        [0, 1, 0],
      ]),
      plain(),
    );
    file.objects().addCurve(
      polyline([
        [1, 0.0004, 0],
        [1, 1, 0],
        [2, 1, 0],
        [2.5, 0.5, 0],
        [2, 0, 0],
      ]),
      plain(),
    );
    const read = readFaces(file);
    expect(read.mesh.faces).toEqual([
      [0, 1, 2, 3],
      [6, 5, 4, 2, 1],
    ]);
    expect(read.remarks).toEqual([
      "1 point became one with a neighbour; the longest way is 0.00040 in the file's unit.",
    ]);
  });
});

describe("a file of triangles or of little", () => {
  it("puts panels together from fans where that is certain, and says where it is not", () => {
    const hexagon = (x: number, z: number): Corners =>
      Array.from({ length: 6 }, (_, k) => [
        x + Math.cos((k * Math.PI) / 3),
        Math.sin((k * Math.PI) / 3),
        z + (x > 0 ? 0.1 : 0) * Math.cos((k * Math.PI) / 3),
      ]);
    const fan = [
      [0, 1, 2],
      [0, 2, 3],
      [0, 3, 4],
      [0, 4, 5],
    ];
    const certain = emptyFile();
    certain.objects().addMesh(mesh(hexagon(0, 0), fan), plain());
    certain.objects().addMesh(mesh(hexagon(5, 1), fan), plain());
    const joined = readFaces(certain);
    expect(joined.mesh.faces.map((face) => face.length)).toEqual([6, 6]);
    expect(joined.remarks).toEqual([
      "2 panels of five and more corners put together from coplanar triangles.",
    ]);
    // Two hexagons in one plane that share a side: any line may be the border of a panel.
    const shared = hexagon(0, 0);
    const beside = hexagon(0, 0).map(([x, y, z]) => [x + 1.5, y + Math.sqrt(3) / 2, z] as const);
    const unclear = emptyFile();
    unclear.objects().addMesh(mesh(shared, fan), plain());
    unclear.objects().addMesh(mesh(beside, fan), plain());
    const left = readFaces(unclear);
    expect(left.mesh.faces.map((face) => face.length)).toEqual(Array(8).fill(3));
    expect(left.remarks.at(-1)).toMatch(/^1 group of coplanar triangles stayed triangles/);
  });

  it("names what it leaves out, or that there is nothing", () => {
    const file = emptyFile();
    file.objects().addCurve(
      polyline([
        [0, 0, 0],
        [1, 0, 0],
        [1, 1, 0],
      ]),
      plain(),
    );
    file.objects().addTextDot("north", [0, 0, 0], plain());
    file.objects().addPoint([1, 2, 3], plain());
    file.objects().addPoint([1, 2, 4], plain());
    const hidden = plain();
    hidden.visible = false;
    file.objects().addPoint([1, 2, 5], hidden);
    expect(readFaces(file).remarks).toEqual([
      "Shown as context, in grey: 2 points.",
      "Left out: 1 text or dimension, 1 hidden object.",
    ]);
    const surface = emptyFile();
    const square = polyline([
      [0, 0, 0],
      [1, 0, 0],
      [1, 1, 0],
      [0, 1, 0],
    ]);
    const plane = { origin: [0, 0, 0], xAxis: [1, 0, 0], yAxis: [0, 1, 0], zAxis: [0, 0, 1] };
    surface.objects().addBrep(rhino.Brep.createTrimmedPlane(plane, square), plain());
    expect(() => readFaces(surface)).toThrow(
      "It holds no mesh and no closed polyline. It holds 1 surface. In Rhino, DupFaceBorder",
    );
    expect(() => readModel(rhino, Uint8Array.of(1, 2, 3), join)).toThrow(/not a Rhino model/);
  });
});

const SQUARE: Corners = [
  [0, 0, 0],
  [1, 0, 0],
  [1, 1, 0],
  [0, 1, 0],
];

/** How far the ends of lines are from the origin at most, and at least. */
function distances(ends: Float64Array): readonly [number, number] {
  const all = Array.from({ length: ends.length / 3 }, (_, k) =>
    Math.hypot(...ends.subarray(3 * k, 3 * k + 3)),
  );
  return [Math.min(...all), Math.max(...all)];
}

describe("what lies beside the panels", () => {
  it("is drawn where it runs: curves, edges and meshes of surfaces, points", () => {
    const file = emptyFile();
    const circle = new rhino.Circle(3);
    file.objects().addMesh(mesh(SQUARE, [[0, 1, 2, 3]]), plain());
    file.objects().addCurve(circle.toNurbsCurve(), plain());
    const curved = readFaces(file).context;
    expect(curved?.count).toBe(1);
    expect(curved?.lines.length).toBe(4 * 16 * 6); // four spans
    for (const distance of distances(curved?.lines ?? new Float64Array()))
      expect(distance).toBeCloseTo(3, 9);
    const box = rhino.Brep.createFromBoundingBox(new rhino.BoundingBox([0, 0, 5], [1, 2, 8]));
    file.objects().addBrep(box, plain());
    file.objects().addExtrusion(rhino.Extrusion.create(circle.toNurbsCurve(), 4, true), plain());
    file
      .objects()
      .addSurface(rhino.NurbsSurface.createFromSphere(new rhino.Sphere([0, 0, 0], 2)), plain());
    const cloud = new rhino.PointCloud();
    cloud.add([1, 2, 3]);
    cloud.add([4, 5, 6]);
    file.objects().addPointCloud(cloud, plain());
    file.objects().addTextDot("north", [0, 0, 0], plain());
    file.objects().addCurve(polyline(SQUARE), plain()); // the mesh is read instead
    const { context, remarks, mesh: panels } = readFaces(file);
    expect(panels.faces).toEqual([[0, 1, 2, 3]]);
    expect(context?.count).toBe(6);
    expect([...(context?.points ?? [])]).toEqual([1, 2, 3, 4, 5, 6]);
    expect(remarks).toEqual([
      "Shown as context, in grey: 1 open or curved curve, 3 surfaces, 1 point, 1 closed polyline.",
      "Left out: 1 text or dimension.",
    ]);
  });

  it("stays beside a design of ours, whose own layers are no context", async () => {
    const { bytes } = writeModel(rhino, await edited("roof", 6, 0.3));
    const file = rhino.File3dm.fromByteArray(bytes);
    expect(readModel(rhino, bytes, join).context).toBeNull();
    const layer = new rhino.Layer();
    layer.name = "Site";
    const attributes = plain();
    attributes.layerIndex = file.layers().add(layer);
    file.objects().addMesh(mesh(SQUARE, [[0, 1, 2, 3]]), attributes);
    file.objects().addCurve(new rhino.LineCurve([0, 0, 0], [1, 2, 3]), attributes);
    const read = readFaces(file);
    expect(read.design).not.toBe("");
    expect([...(read.context?.lines ?? [])]).toEqual([0, 0, 0, 1, 2, 3]);
    expect(read.context?.triangles.length).toBe(18);
    expect(read.remarks).toEqual(["Shown as context, in grey: 1 open or curved curve, 1 mesh."]);
  });
});

it("has outlines and a mesh only where trimmed planes would be too many", async () => {
  const { bytes, surfaces } = writeModel(rhino, await edited("vault", 12, 0.3), 100);
  expect(surfaces).toBe(false);
  const items = itemsOf(bytes);
  expect([on(items, "Panels").length, on(items, "Outlines").length]).toEqual([0, 121]);
});
