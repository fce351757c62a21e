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
import { isUnit } from "../quantity/units.ts";
import { done, GIVEN_UP, type Result } from "../result/result.ts";
import { FILE_FORMATS } from "../solver/file-formats.ts";
import { openFile } from "../state/files.ts";
import type { Page } from "../state/page.ts";

const KINDS: readonly ExportKind[] = [...FILE_FORMATS, "json", "png"];

/** Shows and takes what the host wants of the page; a unit that is none leaves it as it is. */
export function setLook(page: Page, { readonly, unit: wanted }: EditorLook): null {
  page.readOnly.value = readonly;
  document.documentElement.classList.toggle("read-only", readonly);
  if (readonly) page.hintVertex.value = null;
  if (wanted !== null && isUnit(wanted)) page.unit.value = wanted;
  return null;
}

/** A failure in the words that the page says, too. */
const failed = (end: Result<unknown> | undefined, otherwise: string): Error =>
  new Error((end && !end.ok && end.reason) || otherwise);

async function picture(page: Page): Promise<Result<Blob>> {
  const blob = await page.takePicture.value?.();
  return blob ? done(blob) : GIVEN_UP;
}

async function fileOf(page: Page, kind: ExportKind): Promise<Blob> {
  if (!KINDS.includes(kind)) throw new Error(`export: use one of ${KINDS.join(", ")}.`);
  const file = kind === "png" ? await picture(page) : await bytesOf(page, kind);
  if (!file?.ok) throw failed(file, "The design could not be written.");
  return file.value;
}

async function openDesign(page: Page, design: DesignJson): Promise<SetOutcome> {
  const before = page.history.value?.present;
  const end = await openFile(page, new File([JSON.stringify(design)], "design.json"));
  if (page.history.value?.present === before) throw failed(end, "The design could not be opened.");
  const refused = end && !end.ok ? end.reason : "";
  const verified = !refused && (design.result ?? null) !== null;
  return { verified, sentence: refused || (page.notice.value ?? "") };
}

/** Rejects with a sentence. */
export async function answer(page: Page, request: EditorRequest): Promise<unknown> {
  switch (request.kind) {
    case "design":
      return JSON.parse(await (await fileOf(page, "json")).text()) as DesignJson;
    case "set":
      return openDesign(page, request.given);
    case "export":
      return fileOf(page, request.given);
    case "look":
      return setLook(page, request.given);
    default:
      throw new Error("This page does not know what it is asked for.");
  }
}
