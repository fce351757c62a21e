// SPDX-License-Identifier: MIT
// Files for the workshop: written by the core, the same bytes as from the command line.

import { NOTHING } from "../../export/companions.ts";
import { designLink } from "../../export/design-link.ts";
import { save } from "../../export/exporting.ts";
import { linkCode } from "../../export/link-code.ts";
import type {
  CuttingHeader,
  CuttingOptions,
  DrawingOptions,
  DrawnHeader,
  LinkCode,
  ShopOrder,
} from "../../solver/protocol.ts";
import { enqueue } from "../../state/action-queue.ts";
import { run } from "../../state/connection.ts";
import type { Page } from "../../state/page.ts";

/** Which panels are drawn. */
export type Scope = "all" | "remake" | "selected";

/** What the user chooses; the rest follows from the design. */
export type PanelChoice = Omit<CuttingOptions, "name" | "modelUnit" | "remakeOnly" | "panels"> & {
  readonly scope: Scope;
};

export type PackageChoice = PanelChoice & { readonly withLink: boolean };

export type DrawingChoice = Omit<DrawingOptions, "name" | "modelUnit">;

const named = (page: Page) => ({
  name: page.designName.value.replace(/\.[a-z]+$/i, ""),
  modelUnit: page.unit.value,
});

/** The panel that is selected; else those at the selected points. */
export function selectedPanels(page: Page): number[] {
  if (page.selectedPanel.value !== null) return [page.selectedPanel.value];
  const opened = page.mesh.value;
  if (!opened || page.selection.value.length === 0) return [];
  const chosen = new Set(page.selection.value);
  const panels: number[] = [];
  for (let panel = 0; panel + 1 < opened.offsets.length; ++panel) {
    const corners = opened.vertices.subarray(opened.offsets[panel], opened.offsets[panel + 1]);
    if (corners.some((vertex) => chosen.has(vertex))) panels.push(panel);
  }
  return panels;
}

export function cuttingOptions(page: Page, { scope, ...choice }: PanelChoice): CuttingOptions {
  const panels = scope === "selected" ? selectedPanels(page) : [];
  return { ...choice, ...named(page), remakeOnly: scope === "remake", panels };
}

type Header = CuttingHeader | DrawnHeader;

const isDrawn = (header: Header): header is DrawnHeader => "missed" in header;

/** Once all that was asked for is done; the header, null if it was refused. */
async function make(
  page: Page,
  doing: string,
  order: () => Promise<ShopOrder>,
  type: string,
  ending: string,
): Promise<Header | null> {
  const made = await enqueue(page, async () => {
    const answer = await run(page, doing, { kind: "shop", order: await order() }, "made");
    if (answer.ok) save(page, new Blob([answer.value.file], { type }), ending);
    return answer;
  });
  return made?.ok ? made.value.header : null;
}

/** The link that opens the design shown, as a code; without one where it is too long. */
async function codeOfDesign(page: Page): Promise<LinkCode> {
  const link = await designLink(page, null, NOTHING);
  return linkCode(link.ok ? link.value : "");
}

/** Whether labels can carry the link. */
export const hasCode = async (page: Page): Promise<boolean> => (await codeOfDesign(page)).size > 0;

export async function exportPackage(
  page: Page,
  { withLink, ...choice }: PackageChoice,
): Promise<CuttingHeader | null> {
  const order = async (): Promise<ShopOrder> => {
    const code = withLink ? await codeOfDesign(page) : linkCode("");
    return { what: "package", options: cuttingOptions(page, choice), code };
  };
  const header = await make(page, "writing the package", order, "application/zip", "-package.zip");
  return header && !isDrawn(header) ? header : null;
}

export async function exportIfc(page: Page, choice: PanelChoice): Promise<CuttingHeader | null> {
  const order = async (): Promise<ShopOrder> => ({
    what: "ifc",
    options: cuttingOptions(page, choice),
  });
  const header = await make(page, "writing IFC", order, "application/x-step", ".ifc");
  return header && !isDrawn(header) ? header : null;
}

export async function exportDrawings(
  page: Page,
  choice: DrawingChoice,
): Promise<DrawnHeader | null> {
  const order = async (): Promise<ShopOrder> => ({
    what: "drawings",
    options: { ...choice, ...named(page) },
  });
  const header = await make(page, "drawing", order, "application/zip", "-drawings.zip");
  return header && isDrawn(header) ? header : null;
}
