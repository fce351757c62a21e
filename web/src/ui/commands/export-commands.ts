// SPDX-License-Identifier: MIT
// Every way out of the page but the link, as the menu Export and the palette offer them.
import { fetchPart } from "../../state/later.ts";
import { kept, type Page } from "../../state/page.ts";
import { type Command, notReady } from "./command.ts";

type Exporting = typeof import("../../export/exporting.ts");

export interface ExportCommand extends Command {
  readonly name: string;
  readonly about: string;
}

/** Writes a file by a part that is fetched when something is exported. */
const file = (
  name: string,
  about: string,
  write: (part: Exporting, page: Page) => Promise<unknown>,
): ExportCommand => ({
  label: `Export ${name}`,
  name,
  about,
  refusal: notReady,
  run: async (page) => {
    const part = await fetchPart(page, () => import("../../export/exporting.ts"));
    if (part) await write(part, page);
  },
});

export const EXPORT_COMMANDS = {
  obj: file("OBJ", "Polygons, every digit", (part, page) => part.exportMesh(page, "obj")),
  glb: file("GLB", "3D scene, polygons kept", (part, page) => part.exportMesh(page, "glb")),
  rhino: file("3DM", "Rhino, opens again", (part, page) => part.exportRhino(page)),
  ply: file("PLY", "Polygons, binary", (part, page) => part.exportMesh(page, "ply")),
  json: file("JSON", "The design itself: save it, open it again", (part, page) =>
    part.exportDesign(page),
  ),
  png: file("PNG", "Picture of this view", (part, page) => part.exportPicture(page)),
} as const;

/** Those of features, too, which come last. */
export const exportCommands = kept((): ExportCommand[] => Object.values(EXPORT_COMMANDS));
