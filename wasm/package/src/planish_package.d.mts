// SPDX-License-Identifier: MIT
// What package_bindings.cpp lists, by hand. Whatever ends in Handle lives in wasm memory until
// delete(); nothing of it leaves the package.

/** {value}, or why there is none: whose fault it is, and one sentence. */
export type Answer<T> =
  | { readonly value: T; readonly kind?: undefined }
  | {
      readonly kind: "usage" | "mesh" | "internal";
      readonly sentence: string;
      readonly value?: undefined;
    };

/** Whether to go on. */
export type Watch = (step: number, objective: number, residual: number) => boolean;

export interface Handle {
  delete(): void;
}

export interface MeshHandle extends Handle {
  points(): Float64Array;
  faceOffsets(): Int32Array;
  faceVertices(): Int32Array;
  warnings(): string[];
  info(): string;
  bytes(name: string): Answer<Uint8Array>;
}

export interface ShapeHandle extends Handle {
  positions(): Float64Array;
  moved(): Int32Array;
  base(): MeshHandle;
  report(): string;
  messages(): string[];
  bytes(name: string): Answer<Uint8Array>;
}

export interface EditHandle extends Handle {
  shape(): Answer<ShapeHandle>;
  bytes(name: string): Answer<Uint8Array>;
}

export interface FamilyHandle extends Handle {
  dimension(): number;
}

export interface VariationHandle extends EditHandle {
  exact(watch: Watch | null): Answer<VariationHandle>;
}

export interface ReplayHandle extends Handle {
  shape(): ShapeHandle;
  bytes(name: string): Answer<Uint8Array>;
}

export interface DesignHandle extends Handle {
  text(): string;
  replay(base: MeshHandle | null, watch: Watch | null): Answer<ReplayHandle>;
}

/** One vertex in one direction, as the core's MobilityRow. */
export interface MobilityValue {
  readonly vertex: number;
  /** Of length 1. */
  readonly direction: readonly [number, number, number];
  /** Model units. */
  readonly distance: number;
  /** "range", "shape", "search", or the name of a limit. */
  readonly limit: string;
  /** Panels to be made again. */
  readonly remake: number;
  /** Degrees. */
  readonly sharpestFold: number;
}

export interface MobilityHandle extends Handle {
  /** Four rows for each vertex, in their order. */
  measure(vertices: ArrayLike<number>): Answer<MobilityValue[]>;
  /** The file of rows that were measured: .json, .csv or .glb. */
  bytes(rows: readonly MobilityValue[], name: string): Answer<Uint8Array>;
}

export interface TypesHandle extends Handle {
  report(): string;
  messages(): string[];
  bytes(name: string): Answer<Uint8Array>;
}

export interface OptionRow {
  /** "--keep-boundary" */
  readonly name: string;
  /** What follows it, "N" for example; "" for a switch. */
  readonly value: string;
  readonly help: string;
}

export interface PackageModule {
  meshOfArrays(
    points: Float64Array,
    faceOffsets: Int32Array,
    faceVertices: Int32Array,
  ): Answer<MeshHandle>;
  sampleMesh(name: string): Answer<MeshHandle>;
  readMesh(name: string, bytes: Uint8Array): Answer<MeshHandle>;
  edit(mesh: MeshHandle, asked: string, watch: Watch | null): Answer<EditHandle>;
  explore(edit: EditHandle, asked: string, watch: Watch | null): Answer<FamilyHandle>;
  variation(family: FamilyHandle, asked: string): Answer<VariationHandle>;
  project(
    mesh: MeshHandle,
    asked: string,
    reference: MeshHandle | null,
    watch: Watch | null,
  ): Answer<ShapeHandle>;
  convert(mesh: MeshHandle, asked: string): Answer<MeshHandle>;
  offset(mesh: MeshHandle, asked: string): Answer<ShapeHandle>;
  mobility(mesh: MeshHandle, asked: string): Answer<MobilityHandle>;
  types(mesh: MeshHandle, asked: string): Answer<TypesHandle>;
  readDesign(text: string): Answer<DesignHandle>;
  options(command: string): Answer<OptionRow[]>;
}

export default function createPackage(options: {
  readonly wasmBinary: Uint8Array | ArrayBuffer;
}): Promise<PackageModule>;
