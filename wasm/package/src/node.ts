// SPDX-License-Identifier: MIT
// The package in node, which cannot fetch its own files.
import { readFile } from "node:fs/promises";
import { wasmSource } from "./wasm-source.ts";

wasmSource.read = (place) => readFile(place);

export * from "./index.ts";
