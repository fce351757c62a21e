// SPDX-License-Identifier: MIT
// A .3dm file as a mesh, or as the design that it came from, and what lies beside it. Every file gives
// one of both or a sentence; what is left out is named.
import type { Curve, File3dm, File3dmObject, Mesh } from "rhino3dm";
import type { Unit } from "../quantity/units.ts";
import type { Context } from "./context.ts";
import { drawnInUnit, fileUnit, inUnit } from "./file-units.ts";
import { joinFans } from "./join-fans.ts";
import {
  DESIGN_KEY,
  type Faces,
  layerPath,
  OUTLINES_KEY,
  outlinesMark,
  type RhinoModule,
  ROOT,
} from "./model.ts";
import { orient } from "./orient.ts";
import { Others } from "./others.ts";
import { type JoinPoints, weld } from "./weld.ts";

export interface ReadModel {
  /** The text of the design whose panels these are to the last bit; "" for none. */
  readonly design: string;
  readonly mesh: Faces;
  /** null where the file has none, or one of its own. */
  readonly unit: Unit | null;
  /** What is no panel, to be drawn behind the panels; null for nothing. */
  readonly context: Context | null;
  /** Sentences: what was done to the mesh, what is context, and what was left out. */
  readonly remarks: readonly string[];
}

/** A file that cannot be read; the message says to the user what is wrong with it. */
export class UnreadableModel extends Error {}

/** Corners, x, y, z one after the other, without the closing point. */
type Outline = readonly number[];

interface Found {
  /** Outlines that the page wrote. */
  readonly own: { readonly name: string; readonly outline: Outline }[];
  readonly polylines: Outline[];
  readonly meshes: Faces[];
  /** Of three and four corners only: for files whose outlines are gone. */
  readonly ownMeshes: Faces[];
  readonly others: Others;
}

/** null for a curve that is no closed polyline. */
function outlineOf(rhino: RhinoModule, curve: Curve): Outline | null {
  if (!curve.isClosed || !curve.isPolyline()) return null;
  const points: number[] = [];
  if (curve instanceof rhino.PolylineCurve) {
    for (let k = 0; k + 1 < curve.pointCount; ++k) points.push(...curve.point(k));
  } else {
    const polyline = curve.tryGetPolyline() as { count: number; get(k: number): number[] } | null;
    for (let k = 0; k + 1 < (polyline?.count ?? 0); ++k) points.push(...(polyline?.get(k) ?? []));
  }
  return points.length >= 9 ? points : null;
}

function facesOf(mesh: Mesh): Faces {
  const points = mesh.vertices().toPoint3dArray().flat();
  const list = mesh.faces();
  const faces = Array.from({ length: list.count }, (_, f) => {
    const [a = 0, b = 0, c = 0, d = 0] = list.get(f);
    return c === d ? [a, b, c] : [a, b, c, d];
  });
  return { points, faces };
}

/** Layers by their index: the path, and whether what is on them is shown. */
function layersOf(file: File3dm): Map<number, { path: string; shown: boolean }> {
  const table = file.layers();
  const all = Array.from({ length: table.count }, (_, k) => table.get(k));
  const shown = (id: string): boolean => {
    const layer = all.find((one) => one.id === id);
    return !layer || (layer.visible && shown(layer.parentLayerId));
  };
  return new Map(
    all.map((layer) => [layer.index, { path: layer.fullPath, shown: shown(layer.id) }]),
  );
}

function search(rhino: RhinoModule, file: File3dm): Found {
  const others = new Others(rhino);
  const found: Found = { own: [], polylines: [], meshes: [], ownMeshes: [], others };
  const layers = layersOf(file);
  const objects = file.objects();
  for (let k = 0; k < objects.count; ++k) {
    const object = objects.get(k);
    const layer = layers.get(object.attributes().layerIndex);
    const path = layer?.path ?? "";
    if (path === layerPath("Outlines")) takeOwn(rhino, object, found);
    else if (path === layerPath("Mesh")) takeOwnMesh(rhino, object, found);
    else if (path !== ROOT && !path.startsWith(`${ROOT}::`))
      take(rhino, object, layer?.shown ?? true, found);
  }
  return found;
}

function takeOwn(rhino: RhinoModule, object: File3dmObject, found: Found): void {
  const geometry = object.geometry();
  const outline = geometry instanceof rhino.Curve ? outlineOf(rhino, geometry) : null;
  if (outline) found.own.push({ name: object.attributes().name, outline });
  else found.others.object(geometry);
}

function takeOwnMesh(rhino: RhinoModule, object: File3dmObject, found: Found): void {
  const geometry = object.geometry();
  if (geometry instanceof rhino.Mesh) found.ownMeshes.push(facesOf(geometry));
  else found.others.object(geometry);
}

function take(rhino: RhinoModule, object: File3dmObject, shown: boolean, found: Found): void {
  const attributes = object.attributes();
  if (attributes.isInstanceDefinitionObject) return; // part of a block, which is counted
  if (!shown || !attributes.visible) {
    found.others.hidden();
    return;
  }
  const geometry = object.geometry();
  if (geometry instanceof rhino.Mesh) {
    found.meshes.push(facesOf(geometry));
    return;
  }
  const outline = geometry instanceof rhino.Curve ? outlineOf(rhino, geometry) : null;
  if (outline) found.polylines.push(outline);
  else found.others.object(geometry);
}

function fromOutlines(outlines: readonly Outline[]): Faces {
  const faces: number[][] = [];
  let first = 0;
  for (const { length } of outlines) {
    faces.push(Array.from({ length: length / 3 }, (_, k) => first + k));
    first += length / 3;
  }
  return { points: outlines.flat(), faces };
}

function together(meshes: readonly Faces[]): Faces {
  const points: number[] = [];
  const faces: number[][] = [];
  for (const mesh of meshes) {
    const first = points.length / 3;
    for (const x of mesh.points) points.push(x);
    for (const face of mesh.faces) faces.push(face.map((v) => first + v));
  }
  return { points, faces };
}

const times = (n: number, one: string, several: string): string =>
  `${n} ${n === 1 ? one : several}`;

/** What is there to read, the surest first. */
function meshOf(found: Found, tolerance: number, join: JoinPoints, remarks: string[]): Faces {
  const own = inOrder(found.own);
  const meshes = [...found.ownMeshes, ...found.meshes];
  const fromMeshes = own.length === 0 && meshes.length > 0;
  const outlines = own.length > 0 ? own : found.polylines;
  if (!fromMeshes && outlines.length === 0) throw new UnreadableModel(found.others.instead());
  if (own.length > 0) for (const mesh of found.meshes) found.others.mesh(mesh);
  if (own.length > 0 || fromMeshes)
    for (const outline of found.polylines) found.others.polyline(outline);
  const whole = fromMeshes ? together(meshes) : fromOutlines(outlines);
  const { points, faces, moved, largest, collapsed } = weld(whole, tolerance, join);
  if (moved > 0) {
    const way = `the longest way is ${largest.toPrecision(2)} in the file's unit`;
    remarks.push(`${times(moved, "point", "points")} became one with a neighbour; ${way}.`);
  }
  if (collapsed > 0)
    remarks.push(`${times(collapsed, "outline", "outlines")} without area left out.`);
  const once = drawnOnce(faces);
  if (once.length < faces.length)
    remarks.push(`${times(faces.length - once.length, "panel", "panels")} drawn twice read once.`);
  const agreeing = orient(once);
  if (!fromMeshes) return { points, faces: agreeing };
  const turned = agreeing.filter((face, f) => face !== once[f]).length;
  if (turned > 0)
    remarks.push(`${times(turned, "face", "faces")} turned over so that neighbours agree.`);
  const joins = joinFans({ points, faces: agreeing });
  if (joins.joined > 0)
    remarks.push(
      `${times(joins.joined, "panel", "panels")} of five and more corners put together from coplanar triangles.`,
    );
  if (joins.uncertain > 0)
    remarks.push(
      `${times(joins.uncertain, "group", "groups")} of coplanar triangles stayed triangles: where their panels end is not certain. Closed polylines around panels say where.`,
    );
  if (joins.quads > 0)
    remarks.push(
      `${times(joins.quads, "group", "groups")} of quads in one plane may be one panel each; they stay as they are. Closed polylines around panels say which.`,
    );
  return { points, faces: joins.faces };
}

/** Faces without those whose corners an earlier one has. */
function drawnOnce(faces: readonly (readonly number[])[]): readonly (readonly number[])[] {
  const seen = new Set<string>();
  return faces.filter((face) => {
    const key = face.toSorted((a, b) => a - b).join(" ");
    return !seen.has(key) && seen.add(key);
  });
}

/** Numbered panels in their order; Rhino may have put them in another. */
const inOrder = (own: Found["own"]): Outline[] =>
  own
    .toSorted((a, b) => Number(a.name.replace(/\D/g, "")) - Number(b.name.replace(/\D/g, "")))
    .map(({ outline }) => outline);

function stringOf(file: File3dm, key: string): string {
  const strings = file.strings();
  for (let k = 0; k < strings.count; ++k) {
    const [name, value] = strings.get(k) as [string, string];
    if (name === key) return value;
  }
  return "";
}

const CHANGED =
  "The panels were changed after the file was saved here: they are opened as a mesh, without the design that they came from.";

/** Throws an UnreadableModel. */
export function readModel(rhino: RhinoModule, bytes: Uint8Array, join: JoinPoints): ReadModel {
  const file = rhino.File3dm.fromByteArray(bytes) as File3dm | null;
  if (!file) throw new UnreadableModel("This is not a Rhino model that can be read.");
  const { modelUnitSystem, modelAbsoluteTolerance } = file.settings();
  const found = search(rhino, file);
  const remarks: string[] = [];
  const mesh = meshOf(found, modelAbsoluteTolerance, join, remarks);
  const stored = stringOf(file, DESIGN_KEY);
  const isSame = outlinesMark(inOrder(found.own)) === stringOf(file, OUTLINES_KEY);
  if (stored && !isSame) remarks.unshift(CHANGED);
  remarks.push(...found.others.remarks());
  const drawn = found.others.context();
  file.destroy();
  const unit = fileUnit(rhino, modelUnitSystem);
  if (unit.remark) remarks.unshift(unit.remark);
  return {
    design: isSame ? stored : "",
    mesh: inUnit(mesh, unit),
    unit: unit.unit,
    context: drawn && drawnInUnit(drawn, unit),
    remarks,
  };
}

/** Every digit of every coordinate. */
export function writeObj({ points, faces }: Faces): Uint8Array {
  const lines: string[] = [];
  for (let k = 0; k < points.length; k += 3)
    lines.push(`v ${points[k]} ${points[k + 1]} ${points[k + 2]}`);
  for (const face of faces) lines.push(`f ${face.map((v) => v + 1).join(" ")}`);
  return new TextEncoder().encode(`${lines.join("\n")}\n`);
}
