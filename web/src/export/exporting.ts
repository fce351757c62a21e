// SPDX-License-Identifier: MIT
import { formats } from "virtual:core-defaults";
import { done, type Result, refuse } from "../result/result.ts";
import type { Question } from "../solver/client.ts";
import type { FileFormat } from "../solver/file-formats.ts";
import type { DesignValue } from "../solver/protocol.ts";
import { enqueue, type Outcome } from "../state/action-queue.ts";
import { readCamera } from "../state/camera.ts";
import { run } from "../state/connection.ts";
import { changedGroups } from "../state/kept-groups.ts";
import { loadPart } from "../state/later.ts";
import type { Page } from "../state/page.ts";

const MEDIA: Readonly<Record<FileFormat | "json", string>> = {
  ...formats,
  json: "application/json",
};

/** What tells a design from the file that it was made of, whose name it has. */
const DESIGN = "-design";

/** "roof-design.obj" of "roof.obj", "roof-design-2.obj" of "roof-design.obj": never what was opened. */
function savedName(opened: string, ending: string): string {
  const [, stem = opened, design, count = "1", type = ""] =
    /^(.*?)(-design(?:-(\d+))?)?(\.(?:3dm|[a-z]+))?$/i.exec(opened) ?? [];
  const name = stem.replace(/[^\p{L}\p{N}_-]+/gu, "-").toLowerCase();
  const again = design && ending === `${DESIGN}${type.toLowerCase()}`;
  return `${name}${again ? `${DESIGN}-${Number(count) + 1}${type.toLowerCase()}` : ending}`;
}

/** `ending`: what follows the name of what was opened, with the extension. */
export function save(page: Page, blob: Blob, ending: string): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = savedName(page.designName.value, ending);
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}

const textParts = () => loadPart(() => import("./design-text.ts"));

/** What makes the design again. @param whole with the mesh itself */
async function recipe(page: Page, whole: boolean): Promise<Result<DesignValue>> {
  const part = await textParts();
  return part.ok ? part.value.designValue(page, whole) : part;
}

/** What writes a file that opens again, here and on the command line. */
async function glbFile(page: Page): Promise<Result<Question>> {
  const design = await recipe(page, false);
  const offset = page.offsetLayer.value?.positions ?? null;
  return design.ok ? done({ kind: "export", format: "glb", design: design.value, offset }) : design;
}

/** What writes a mesh. OBJ names groups of panels: those of the file, as it has them, unless changed. */
async function meshFile(page: Page, format: Exclude<FileFormat, "glb">): Promise<Result<Question>> {
  const changed = changedGroups(page);
  if (!changed) return done({ kind: "export", format, design: null, groups: null });
  const part = await loadPart(() => import("../design/face-runs.ts"));
  if (!part.ok) return part;
  const groups = part.value.runsOfGroups(changed, page.mesh.value?.report.faces ?? 0);
  return done({ kind: "export", format, design: null, groups });
}

/** The design as text, with all that was written and kept under names here. */
async function textFile(page: Page): Promise<Result<Blob>> {
  const parts = await loadPart(() =>
    Promise.all([import("./design-text.ts"), import("./companions.ts")]),
  );
  if (!parts.ok) return parts;
  const [{ designText }, { EVERYTHING: taken }] = parts.value;
  const camera = readCamera(page);
  const text = await designText(page, { format: "json", label: "writing JSON", camera, taken });
  return text.ok ? done(new Blob([text.value], { type: MEDIA.json })) : text;
}

/** The design as a file, within a queued action. */
async function fileNow(page: Page, format: FileFormat | "json"): Promise<Result<Blob>> {
  if (format === "json") return textFile(page);
  const question = format === "glb" ? await glbFile(page) : await meshFile(page, format);
  if (!question.ok) return question;
  const answer = await run(page, `writing ${format.toUpperCase()}`, question.value, "exported");
  if (!answer.ok) return answer;
  return done(new Blob([answer.value.bytes as BlobPart], { type: MEDIA[format] }));
}

async function exportNow(page: Page, format: FileFormat | "json", ending: string): Outcome {
  const file = await fileNow(page, format);
  if (file.ok) save(page, file.value, ending);
  return file;
}

/** The file of the design for whoever has no use for a download. */
export const bytesOf = (page: Page, format: FileFormat | "json"): Outcome<Blob> =>
  enqueue(page, () => fileNow(page, format));

export const exportDesign = (page: Page): Outcome =>
  enqueue(page, () => exportNow(page, "json", `${DESIGN}.json`));

/** The design, once all that was asked for is done, written by the core in float64. */
export const exportMesh = (page: Page, format: FileFormat): Outcome =>
  enqueue(page, () => exportNow(page, format, `${DESIGN}.${format}`));

const surfaces = (names: readonly string[]): string =>
  `No surface in Rhino for ${names.slice(0, 5).join(", ")}${names.length > 5 ? " and others" : ""}: not flat enough, or crossing itself. Outlines are all there.`;

/** A Rhino model: panels, outlines and a mesh, which opens again here as the design. */
export const exportRhino = (page: Page): Outcome =>
  enqueue(page, async () => {
    const design = await recipe(page, true);
    if (!design.ok) return design;
    const question = { kind: "model", unit: page.unit.value, design: design.value } as const;
    const answer = await run(page, "writing 3DM", question, "modelled");
    if (!answer.ok) return answer;
    const { bytes, withoutSurface, surfaces: withSurfaces } = answer.value.model;
    save(page, new Blob([bytes as BlobPart], { type: "model/vnd.3dm" }), `${DESIGN}.3dm`);
    if (!withSurfaces) page.notice.value = MANY;
    else if (withoutSurface.length > 0) page.notice.value = surfaces(withoutSurface);
    return answer;
  });

const MANY =
  "Above 5,000 panels the Rhino model holds outlines and a mesh; trimmed planes would take long to open.";

export const exportPicture = (page: Page): Outcome =>
  enqueue(page, async () => {
    const blob = (await page.takePicture.value?.()) ?? null;
    if (!blob) return refuse("The picture could not be taken.");
    save(page, blob, `${DESIGN}.png`);
    return undefined;
  });
