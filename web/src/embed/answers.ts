// SPDX-License-Identifier: MIT
// What the page does when the page around it asks.
import type {
  DesignJson,
  EditorLook,
  EditorRequest,
  ExportKind,
  SetOutcome,
} from "../../../wasm/package/src/planish-editor.ts";
import { bytesOf } from "../export/exporting.ts";
import { openFile } from "../state/files.ts";
import {
  hintVertex,
  history,
  notice,
  problem,
  readOnly,
  takePicture,
  unit,
} from "../state/store.ts";
import { isUnit } from "../state/units.ts";

const KINDS: readonly ExportKind[] = ["obj", "off", "ply", "glb", "json", "png"];

/** Shows and takes what the host wants of the page; a unit that is none leaves it as it is. */
export function setLook({ readonly, unit: wanted }: EditorLook): null {
  readOnly.value = readonly;
  document.documentElement.classList.toggle("read-only", readonly);
  if (readonly) hintVertex.value = null;
  if (wanted !== null && isUnit(wanted)) unit.value = wanted;
  return null;
}

/** What the page says went wrong. */
const refusal = (otherwise: string): Error => new Error(problem.value ?? otherwise);

async function fileOf(kind: ExportKind): Promise<Blob> {
  if (!KINDS.includes(kind)) throw new Error(`export: use one of ${KINDS.join(", ")}.`);
  const blob = kind === "png" ? await takePicture.value?.() : await bytesOf(kind);
  if (!blob) throw refusal("The design could not be written.");
  return blob;
}

async function openDesign(design: DesignJson): Promise<SetOutcome> {
  const before = history.value?.present;
  await openFile(new File([JSON.stringify(design)], "design.json"));
  if (history.value?.present === before) throw refusal("The design could not be opened.");
  const verified = problem.value === null && (design.result ?? null) !== null;
  return { verified, sentence: problem.value ?? notice.value ?? "" };
}

/** Rejects with a sentence. */
export async function answer(request: EditorRequest): Promise<unknown> {
  switch (request.kind) {
    case "design":
      return JSON.parse(await (await fileOf("json")).text()) as DesignJson;
    case "set":
      return openDesign(request.given);
    case "export":
      return fileOf(request.given);
    case "look":
      return setLook(request.given);
    default:
      throw new Error("This page does not know what it is asked for.");
  }
}
