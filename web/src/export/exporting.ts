// SPDX-License-Identifier: MIT
import type { Question } from "../solver/client.ts";
import type { DesignValue, FileFormat } from "../solver/protocol.ts";
import { run } from "../state/connection.ts";
import { fetchPart } from "../state/later.ts";
import { markOf } from "../state/marking.ts";
import { recipeOf } from "../state/recipe.ts";
import {
  designName,
  history,
  notice,
  offsetLayer,
  problem,
  takePicture,
  unit,
} from "../state/store.ts";
import { inTurn } from "../state/turns.ts";

const MEDIA: Readonly<Record<FileFormat | "json", string>> = {
  obj: "model/obj",
  off: "text/plain",
  ply: "application/octet-stream",
  glb: "model/gltf-binary",
  json: "application/json",
};

/** `ending`: what follows the design's name, with the extension. */
export function save(blob: Blob, ending: string): void {
  const name = designName.value.replace(/\.[a-z]+$/i, "").replace(/[^\p{L}\p{N}_-]+/gu, "-");
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = `${name.toLowerCase()}${ending}`;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}

/** What makes the design again; `whole` with the mesh itself. */
async function recipe(whole: boolean): Promise<DesignValue | null> {
  const parts = await fetchPart(() => import("../share/design-value.ts"));
  const design = history.value?.present;
  const mark = parts && design && (await markOf(design.shape));
  if (!mark) return null;
  const { source } = design;
  const bytes =
    whole && source.kind === "file" ? new Uint8Array(await source.bytes.arrayBuffer()) : undefined;
  return parts.toDesign(recipeOf(design, unit.value, null, mark), bytes);
}

/** Of a file that opens again, here and on the command line. */
async function designFile(format: "glb" | "json"): Promise<Question | null> {
  const design = await recipe(format === "json");
  const offset = offsetLayer.value?.positions ?? null;
  return design && { kind: "export", format, design, offset };
}

/** The design as a file, within a turn; null if it was refused, which has been said then. */
async function fileNow(format: FileFormat | "json"): Promise<Blob | null> {
  const question: Question | null =
    format === "glb" || format === "json"
      ? await designFile(format)
      : { kind: "export", format, design: null };
  const answer = question && (await run(`writing ${format.toUpperCase()}`, question, "exported"));
  return answer && new Blob([answer.bytes as BlobPart], { type: MEDIA[format] });
}

async function exportNow(format: FileFormat | "json", ending: string): Promise<void> {
  const file = await fileNow(format);
  if (file) save(file, ending);
}

/** The same for whoever has no use for a download. */
export async function bytesOf(format: FileFormat | "json"): Promise<Blob | null> {
  let file: Blob | null = null;
  await inTurn(async () => {
    file = await fileNow(format);
  });
  return file;
}

export const exportDesign = (): Promise<void> => inTurn(() => exportNow("json", "-design.json"));

/** The design, once all that was asked for is done, written by the core in float64. */
export const exportMesh = (format: FileFormat): Promise<void> =>
  inTurn(() => exportNow(format, `.${format}`));

const surfaces = (names: readonly string[]): string =>
  `No surface in Rhino for ${names.slice(0, 5).join(", ")}${names.length > 5 ? " and others" : ""}: not flat enough, or crossing itself. Outlines are all there.`;

/** A Rhino model: panels, outlines and a mesh, which opens again here as the design. */
export const exportRhino = (): Promise<void> =>
  inTurn(async () => {
    const design = await recipe(true);
    if (!design) return;
    const question = { kind: "model", unit: unit.value, design } as const;
    const answer = await run("writing 3DM", question, "modelled");
    if (!answer) return;
    const { bytes, withoutSurface } = answer.model;
    save(new Blob([bytes as BlobPart], { type: "model/vnd.3dm" }), ".3dm");
    if (!answer.model.surfaces) notice.value = MANY;
    else if (withoutSurface.length > 0) notice.value = surfaces(withoutSurface);
  });

const MANY =
  "Above 5,000 panels the Rhino model holds outlines and a mesh; trimmed planes would take long to open.";

export const exportPicture = (): Promise<void> =>
  inTurn(async () => {
    const blob = (await takePicture.value?.()) ?? null;
    if (blob) save(blob, ".png");
    else problem.value = "The picture could not be taken.";
  });
