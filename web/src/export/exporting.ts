// SPDX-License-Identifier: MIT
import type { FileFormat } from "../solver/protocol.ts";
import { run } from "../state/connection.ts";
import { fetchPart } from "../state/later.ts";
import { recipeOf } from "../state/recipe.ts";
import { designName, history, mesh, notice, problem, unit } from "../state/store.ts";
import { inTurn } from "../state/turns.ts";

const MEDIA: Readonly<Record<FileFormat, string>> = {
  obj: "model/obj",
  off: "text/plain",
  ply: "application/octet-stream",
  glb: "model/gltf-binary",
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

/** What makes the design again, as text; `whole` with the mesh itself. */
async function recipe(whole: boolean): Promise<string> {
  const text = await fetchPart(() => import("../share/design-text.ts"));
  const [design, base] = [history.value?.present, mesh.value];
  if (!text || !design || !base) return "";
  const { source } = design;
  const bytes =
    whole && source.kind === "file" ? new Uint8Array(await source.bytes.arrayBuffer()) : null;
  return text.writeDesign(recipeOf(design, unit.value, null), base, bytes);
}

/** The design as a file that opens again, here and on the command line. */
export const exportDesign = (): Promise<void> =>
  inTurn(async () => {
    const text = await recipe(true);
    if (text) save(new Blob([text], { type: "application/json" }), "-design.json");
  });

async function exportNow(format: FileFormat): Promise<void> {
  const question = {
    kind: "export",
    format,
    design: format === "glb" ? await recipe(false) : "",
  } as const;
  const answer = await run(`writing ${format.toUpperCase()}`, question, "exported");
  if (answer) save(new Blob([answer.bytes as BlobPart], { type: MEDIA[format] }), `.${format}`);
}

/** The design, once all that was asked for is done, written by the core in float64. */
export const exportMesh = (format: FileFormat): Promise<void> => inTurn(() => exportNow(format));

const surfaces = (names: readonly string[]): string =>
  `No surface in Rhino for ${names.slice(0, 5).join(", ")}${names.length > 5 ? " and others" : ""}: not flat enough, or crossing itself. Outlines are all there.`;

/** A Rhino model: panels, outlines and a mesh, which opens again here as the design. */
export const exportRhino = (): Promise<void> =>
  inTurn(async () => {
    const question = { kind: "model", unit: unit.value, design: await recipe(true) } as const;
    const answer = await run("writing 3DM", question, "modelled");
    if (!answer) return;
    const { bytes, withoutSurface } = answer.model;
    save(new Blob([bytes as BlobPart], { type: "model/vnd.3dm" }), ".3dm");
    if (!answer.model.surfaces) notice.value = MANY;
    else if (withoutSurface.length > 0) notice.value = surfaces(withoutSurface);
  });

const MANY =
  "Above 5,000 panels the Rhino model holds outlines and a mesh; trimmed planes would take long to open.";

type TakePicture = () => Promise<Blob | null>;
let takePicture: TakePicture | null = null;

/** The viewport says how to take a picture of itself. */
export function providePicture(take: TakePicture | null): void {
  takePicture = take;
}

export const exportPicture = (): Promise<void> =>
  inTurn(async () => {
    const blob = (await takePicture?.()) ?? null;
    if (blob) save(blob, ".png");
    else problem.value = "The picture could not be taken.";
  });
