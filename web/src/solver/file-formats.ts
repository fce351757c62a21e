// SPDX-License-Identifier: MIT
// The formats of meshes that the core reads and writes; tests/parity/formats.test.ts holds them to it.

/** As names of files end, and as the core calls them. */
export const FILE_FORMATS = ["obj", "off", "ply", "glb"] as const;
export type FileFormat = (typeof FILE_FORMATS)[number];

/** "OBJ, OFF, PLY or GLB", and more of them. */
export function namesOfFormats(...more: readonly string[]): string {
  const names = [...FILE_FORMATS, ...more].map((format) => format.toUpperCase());
  return `${names.slice(0, -1).join(", ")} or ${names.at(-1)}`;
}

/** ".obj,.off,.ply,.glb" and more: what a dialog of files offers. */
export const filesOfFormats = (...more: readonly string[]): string =>
  [...FILE_FORMATS, ...more].map((format) => `.${format}`).join();
