// SPDX-License-Identifier: MIT
// Where the bytes of the solver come from: beside this file, over the network or from the disk.

const PLACE = new URL("./planish_package.wasm", import.meta.url);

async function fetched(): Promise<ArrayBuffer> {
  const response = await fetch(PLACE);
  if (!response.ok) throw new Error(`${PLACE.href}: ${response.status} ${response.statusText}`);
  return response.arrayBuffer();
}

/** How they are read; node.ts puts another reader here. */
export const wasmSource: { read: (place: URL) => Promise<Uint8Array | ArrayBuffer> } = {
  read: fetched,
};

export const wasmBytes = (): Promise<Uint8Array | ArrayBuffer> => wasmSource.read(PLACE);
