// SPDX-License-Identifier: MIT
import { crc32 } from "./crc32.ts";

/** The base that was edited. */
export interface BaseMesh {
  readonly positions: Float64Array;
  readonly offsets: Int32Array;
  readonly vertices: Int32Array;
}

const bytesOf = (array: Int32Array | Float64Array): Uint8Array =>
  new Uint8Array(array.buffer, array.byteOffset, array.byteLength);

/** The core's mesh_hash(). */
export const meshHash = ({ positions, offsets, vertices }: BaseMesh): number =>
  crc32(bytesOf(vertices), crc32(bytesOf(offsets), crc32(bytesOf(positions))));
