// SPDX-License-Identifier: MIT
// Objects of a file that are no panels, counted by what an architect calls them.
import type { GeometryBase } from "rhino3dm";
import type { RhinoModule } from "./model.ts";

type Words = readonly [one: string, several: string];

const HIDDEN: Words = ["hidden object", "hidden objects"];
const POLYLINE: Words = ["closed polyline", "closed polylines"];
const MESH: Words = ["mesh", "meshes"];
const SURFACE: Words = ["surface", "surfaces"];
const CURVE: Words = ["open or curved curve", "open or curved curves"];
const POINT: Words = ["point", "points"];
const TEXT: Words = ["text or dimension", "texts and dimensions"];
const BLOCK: Words = ["block", "blocks"];
const LIGHT: Words = ["light", "lights"];
const HATCH: Words = ["hatch", "hatches"];
const OTHER: Words = ["other object", "other objects"];

export class ObjectCount {
  readonly #rhino: RhinoModule;
  readonly #counts = new Map<Words, number>();

  constructor(rhino: RhinoModule) {
    this.#rhino = rhino;
  }

  #add(words: Words): void {
    this.#counts.set(words, (this.#counts.get(words) ?? 0) + 1);
  }

  hidden(): void {
    this.#add(HIDDEN);
  }

  polyline(): void {
    this.#add(POLYLINE);
  }

  mesh(): void {
    this.#add(MESH);
  }

  object(geometry: GeometryBase): void {
    const words = wordsFor(this.#rhino).find(([type]) => type === geometry.objectType);
    this.#add(words?.[1] ?? OTHER);
  }

  /** "2 surfaces, 1 point"; "" for nothing. */
  get words(): string {
    return [...this.#counts]
      .map(([[one, several], times]) => `${times} ${times === 1 ? one : several}`)
      .join(", ");
  }

  get surfaces(): boolean {
    return this.#counts.has(SURFACE);
  }
}

const wordsFor = ({ ObjectType: type }: RhinoModule) =>
  [
    [type.Point, POINT],
    [type.PointSet, POINT],
    [type.Curve, CURVE],
    [type.Surface, SURFACE],
    [type.Brep, SURFACE],
    [type.Extrusion, SURFACE],
    [type.SubD, SURFACE],
    [type.Annotation, TEXT],
    [type.TextDot, TEXT],
    [type.InstanceReference, BLOCK],
    [type.Light, LIGHT],
    [type.Hatch, HATCH],
  ] as const;
