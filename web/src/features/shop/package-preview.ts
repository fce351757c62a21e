// SPDX-License-Identifier: MIT
// What a cutting package would hold, while its options are chosen: asked for quietly, newest first.

import { Abandoned, Died } from "../../solver/client.ts";
import type { CuttingHeader, CuttingPreview } from "../../solver/protocol.ts";
import { client } from "../../state/connection.ts";
import type { Page } from "../../state/page.ts";
import { cuttingOptions, type PackageChoice } from "./shop.ts";

/** null if another one has been asked for since.
 * @param map whether the map is wanted, which the options do not change */
export async function previewPackage(
  page: Page,
  choice: PackageChoice,
  map: boolean,
): Promise<CuttingPreview | null> {
  const [options, face] = [cuttingOptions(page, choice), page.selectedPanel.value ?? -1];
  try {
    const answer = await client(page).stream({ kind: "preview", options, face, map });
    return answer.kind === "previewed" ? answer.preview : null;
  } catch (error) {
    if (error instanceof Abandoned || error instanceof Died) return null;
    return { ...NOTHING, problem: error instanceof Error ? error.message : String(error) };
  }
}

const NOTHING: CuttingPreview = {
  problem: "",
  panels: 0,
  drawn: 0,
  outline: 0,
  bevel: 0,
  nodesMoved: 0,
  nodesArms: 0,
  flatness: 0,
  excess: 0,
  vanished: [],
  apart: [],
  lostSides: [],
  oversize: [],
  sheets: 0,
  usedFraction: 0,
  types: 0,
  map: "",
  shown: "",
  drawing: "",
};

/** The preview as the header of the package itself would say it. */
export const headerOf = (preview: CuttingPreview, choice: PackageChoice): CuttingHeader => ({
  counts: { panels: preview.panels, drawn: preview.drawn },
  remake: {
    outline: preview.outline,
    bevel: preview.bevel,
    nodes_moved: preview.nodesMoved,
    nodes_arms: preview.nodesArms,
  },
  flatness_mm_per_m: preview.flatness,
  excess_mm_per_m: preview.excess,
  vanished: preview.vanished,
  apart: preview.apart,
  lost_sides: preview.lostSides,
  ...(preview.types > 0 && { types: { types: preview.types } }),
  sheets:
    choice.sheetWidth > 0
      ? {
          count: preview.sheets,
          used_fraction: preview.usedFraction,
          oversize: preview.oversize,
        }
      : null,
});
