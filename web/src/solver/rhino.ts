// SPDX-License-Identifier: MIT
// Rhino's models are read and written by McNeel's own library, fetched when it is needed for the
// first time: a megabyte after gzip.
import type { Session } from "@wasm/planish.mjs";
import rhinoUrl from "rhino3dm/rhino3dm.wasm?url";
import type { Unit } from "../quantity/units.ts";
import { csvRows } from "../rhino/csv-rows.ts";
import type { RhinoModule } from "../rhino/model.ts";
import { readModel, UnreadableModel, writeObj } from "../rhino/read-model.ts";
import type { JoinPoints } from "../rhino/weld.ts";
import { type WrittenModel, writeModel } from "../rhino/write-model.ts";
import type { OpenedModel } from "./protocol.ts";
import { aboutFile } from "./reading.ts";
import { panelRows } from "./shop.ts";

/** A new instance for each file: its memory, which only grows, goes when the file is done. */
async function loadRhino(): Promise<RhinoModule> {
  try {
    const { default: create } = await import("rhino3dm/rhino3dm.module.js");
    return await create({ locateFile: () => rhinoUrl, print: () => {}, printErr: () => {} });
  } catch {
    throw new Error("The part that reads and writes 3DM could not be loaded. Try again online.");
  }
}

/** A mesh or a design; throws a sentence if the file has neither. */
export async function openRhino(
  name: string,
  bytes: Uint8Array,
  join: JoinPoints,
): Promise<OpenedModel> {
  const rhino = await loadRhino();
  try {
    const { mesh, ...others } = readModel(rhino, bytes, join);
    return { ...others, mesh: writeObj(mesh) };
  } catch (error) {
    const what = error instanceof UnreadableModel ? error.message : "It is damaged, or too large.";
    throw new Error(aboutFile(name, what));
  }
}

/** The design shown, with its rows of panels.csv in model units, and as text. */
export async function writeRhino(
  session: Session,
  unit: Unit,
  design: string,
): Promise<WrittenModel> {
  const rows = csvRows(await panelRows(session, unit));
  const rhino = await loadRhino();
  const [offsets, vertices] = [session.faceOffsets(), session.faceVertices()];
  const faces = rows.map((_, f) => vertices.subarray(offsets[f], offsets[f + 1]));
  const positions = session.basePositions();
  const moved = session.movedPositions();
  session.moved().forEach((v, k) => {
    positions.set(moved.subarray(3 * k, 3 * k + 3), 3 * v);
  });
  try {
    return writeModel(rhino, { positions, faces, rows, unit, design });
  } catch {
    throw new Error("There is not enough memory for this model in the browser.");
  }
}
