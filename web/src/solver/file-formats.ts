// SPDX-License-Identifier: MIT
// The formats of meshes that the core reads and writes, from its table.
import { formats } from "virtual:core-defaults";
import type { MeshFormat } from "@wasm/planish.mjs";

export type FileFormat = MeshFormat;

/** As names of files end, and as the core calls them. */
export const FILE_FORMATS = Object.keys(formats) as readonly FileFormat[];

/** "OBJ, … or GLB", and more of them. */
export function namesOfFormats(...more: readonly string[]): string {
  const names = [...FILE_FORMATS, ...more].map((format) => format.toUpperCase());
  return `${names.slice(0, -1).join(", ")} or ${names.at(-1)}`;
}

/** ".obj,…,.glb" and more: what a dialog of files offers. */
export const filesOfFormats = (...more: readonly string[]): string =>
  [...FILE_FORMATS, ...more].map((format) => `.${format}`).join();
