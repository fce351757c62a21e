// SPDX-License-Identifier: MIT
// A design as a .3dm file: its panels as trimmed planes, outlines and a mesh, each with its row of
// panels.csv, and the design itself, so that the file opens again as that.
import type { CommonObject, Layer, ObjectAttributes, PolylineCurve } from "rhino3dm";
import { cross } from "../mesh/vector.ts";
import { convert, type Unit } from "../quantity/units.ts";
import {
  DESIGN_KEY,
  LAYERS,
  type LayerName,
  OUTLINES_KEY,
  outlinesMark,
  type RhinoModule,
  ROOT,
  unitSystem,
} from "./model.ts";

/** A trimmed plane takes five times the room and ten times the time of an outline. */
const MOST_SURFACES = 5_000;

export interface Model {
  /** Of the mesh, x, y, z one after the other, model units. */
  readonly positions: Float64Array;
  /** Per panel, with the vertices of its corners. */
  readonly faces: readonly Int32Array[];
  /** Rows of panels.csv in model units, one a face. */
  readonly rows: readonly Readonly<Record<string, string>>[];
  readonly unit: Unit;
  /** What makes the design again, with its mesh; "" for none. */
  readonly design: string;
}

export interface WrittenModel {
  readonly bytes: Uint8Array;
  readonly surfaces: boolean;
  /** Names of panels that are no trimmed plane: they are not flat, or cross themselves. */
  readonly withoutSurface: readonly string[];
}

type Point = [number, number, number];
type Colour = { readonly r: number; readonly g: number; readonly b: number; readonly a: number };

const COLOURS: Readonly<Record<LayerName, Colour>> = {
  Panels: { r: 150, g: 165, b: 180, a: 255 },
  Outlines: { r: 30, g: 30, b: 30, a: 255 },
  Mesh: { r: 110, g: 120, b: 130, a: 255 },
  Remake: { r: 220, g: 110, b: 20, a: 255 },
  Text: { r: 60, g: 60, b: 60, a: 255 },
};

/** Rhino's own tolerance for what it builds on the model, metres. */
const TOLERANCE_METRES = 1e-6;

const numbers = (cell: string | undefined): Point => {
  const [x = 0, y = 0, z = 0] = (cell ?? "").split(" ").map(Number);
  return [x, y, z];
};

class ModelWriter {
  readonly #rhino: RhinoModule;
  readonly #model: Model;
  readonly #file;
  readonly #layers = new Map<LayerName, number>();
  readonly #withoutSurface: string[] = [];

  readonly #mostSurfaces: number;

  constructor(rhino: RhinoModule, model: Model, mostSurfaces: number) {
    this.#mostSurfaces = mostSurfaces;
    this.#rhino = rhino;
    this.#model = model;
    this.#file = new rhino.File3dm();
    const settings = this.#file.settings();
    settings.modelUnitSystem = unitSystem(rhino, model.unit);
    settings.modelAbsoluteTolerance = convert(TOLERANCE_METRES, "m", model.unit);
    this.#file.applicationName = ROOT;
  }

  write(): WrittenModel {
    const { faces, design } = this.#model;
    const surfaces = faces.length <= this.#mostSurfaces;
    this.#addLayers(surfaces);
    const outlines = faces.map((face) => this.#corners(face));
    outlines.forEach((corners, f) => {
      this.#addPanel(corners, f, surfaces);
    });
    this.#addMesh();
    if (design) {
      this.#file.strings().set(DESIGN_KEY, design);
      this.#file.strings().set(OUTLINES_KEY, outlinesMark(outlines));
    }
    const bytes = this.#file.toByteArray().slice();
    this.#file.destroy();
    return { bytes, surfaces, withoutSurface: this.#withoutSurface };
  }

  #addLayers(surfaces: boolean): void {
    const layers = this.#file.layers();
    const root = this.#layer(ROOT, COLOURS.Outlines);
    const { id } = layers.findIndex(layers.add(root));
    for (const name of LAYERS) {
      const layer = this.#layer(name, COLOURS[name]);
      layer.parentLayerId = id;
      // Two surfaces in one place flicker.
      layer.visible = name !== "Mesh" || !surfaces;
      this.#layers.set(name, layers.add(layer));
    }
  }

  #layer(name: string, colour: Colour): Layer {
    const layer = new this.#rhino.Layer();
    layer.name = name;
    layer.color = colour;
    return layer;
  }

  #attributes(layer: LayerName, name: string): ObjectAttributes {
    const attributes = new this.#rhino.ObjectAttributes();
    attributes.name = name;
    attributes.layerIndex = this.#layers.get(layer) ?? 0;
    return attributes;
  }

  #corners(face: Int32Array): number[] {
    const { positions } = this.#model;
    return [...face].flatMap((v) => [...positions.subarray(3 * v, 3 * v + 3)]);
  }

  #addPanel(corners: readonly number[], f: number, surfaces: boolean): void {
    const row = this.#model.rows[f] ?? {};
    const name = row.panel ?? "";
    const outline = this.#outline(corners);
    const attributes = this.#attributes("Outlines", name);
    for (const [key, value] of Object.entries(row)) attributes.setUserString(key, value);
    this.#file.objects().addCurve(outline, attributes);
    if (surfaces) this.#addSurface(outline, row, attributes);
    if (row.change && row.change !== "unchanged") {
      const again = this.#attributes("Remake", name);
      again.setUserString("change", row.change);
      this.#file.objects().addCurve(outline, again);
      release(again);
    }
    const label = this.#attributes("Text", name);
    this.#file.objects().addTextDot(name, middle(corners), label);
    release(outline, attributes, label);
  }

  #outline(corners: readonly number[]): PolylineCurve {
    const points = new this.#rhino.Point3dList(corners.length / 3 + 1);
    for (let k = 0; k <= corners.length; k += 3) {
      const [x = 0, y = 0, z = 0] = corners.slice(k % corners.length);
      points.add(x, y, z);
    }
    const curve = new this.#rhino.PolylineCurve(points);
    release(points as unknown as CommonObject);
    return curve;
  }

  /** A plane with the panel's own frame, trimmed by its outline. */
  #addSurface(
    outline: PolylineCurve,
    row: Readonly<Record<string, string>>,
    attributes: ObjectAttributes,
  ): void {
    const [xAxis, zAxis] = [numbers(row.x_axis), numbers(row.normal)];
    const plane = { origin: numbers(row.origin), xAxis, yAxis: cross(zAxis, xAxis), zAxis };
    const surface = this.#rhino.Brep.createTrimmedPlane(plane, outline);
    if (surface?.isValid) {
      attributes.layerIndex = this.#layers.get("Panels") ?? 0;
      this.#file.objects().addBrep(surface, attributes);
    } else this.#withoutSurface.push(row.panel ?? "");
    if (surface) release(surface);
  }

  /** Panels of three and four corners: a mesh in Rhino's JavaScript has no others. */
  #addMesh(): void {
    const { positions, faces } = this.#model;
    const mesh = new this.#rhino.Mesh();
    const places = new Map<number, number>();
    const place = (v: number): number => {
      const known = places.get(v);
      if (known !== undefined) return known;
      const [x = 0, y = 0, z = 0] = positions.subarray(3 * v, 3 * v + 3);
      places.set(v, places.size);
      mesh.vertices().addPoint3d(x, y, z); // add() would round to single precision
      return places.size - 1;
    };
    mesh.vertices().useDoublePrecisionVertices = true;
    for (const face of faces) {
      const [a = 0, b = 0, c = 0, d = 0] = face.length <= 4 ? [...face].map(place) : [];
      if (face.length === 3) mesh.faces().addTriFace(a, b, c);
      if (face.length === 4) mesh.faces().addQuadFace(a, b, c, d);
    }
    const attributes = this.#attributes("Mesh", "Mesh");
    if (places.size > 0) this.#file.objects().addMesh(mesh, attributes);
    release(mesh, attributes);
  }
}

/** Frees what the module holds of them; its types leave the method out. */
function release(...objects: readonly CommonObject[]): void {
  for (const object of objects) (object as CommonObject & { delete(): void }).delete();
}

/** Of the corners. */
function middle(corners: readonly number[]): Point {
  const sum: Point = [0, 0, 0];
  corners.forEach((x, k) => {
    sum[k % 3] = (sum[k % 3] ?? 0) + x;
  });
  return sum.map((x) => (3 * x) / corners.length) as Point;
}

/** Writes the version of Rhino that the library is of; every Rhino from it on reads that. */
export const writeModel = (
  rhino: RhinoModule,
  model: Model,
  mostSurfaces = MOST_SURFACES,
): WrittenModel => new ModelWriter(rhino, model, mostSurfaces).write();
