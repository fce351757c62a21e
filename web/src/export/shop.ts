// SPDX-License-Identifier: MIT
// Files for the workshop: written by the core, the same bytes as from the command line.
import type {
  CuttingHeader,
  CuttingOptions,
  DrawingOptions,
  DrawnHeader,
  ShopOrder,
} from "../solver/protocol.ts";
import { run } from "../state/connection.ts";
import { designName, mesh, selectedPanel, selection, unit } from "../state/store.ts";
import { inTurn } from "../state/turns.ts";
import { designLink } from "./design-link.ts";
import { save } from "./exporting.ts";
import { linkCode } from "./link-code.ts";

/** Which panels are drawn. */
export type Scope = "all" | "remake" | "selected";

/** What the user chooses; the rest follows from the design. */
export type PanelChoice = Omit<CuttingOptions, "name" | "modelUnit" | "remakeOnly" | "panels"> & {
  readonly scope: Scope;
};
export type PackageChoice = PanelChoice & { readonly withLink: boolean };
export type DrawingChoice = Omit<DrawingOptions, "name" | "modelUnit">;

const named = () => ({
  name: designName.value.replace(/\.[a-z]+$/i, ""),
  modelUnit: unit.value,
});

/** The panel that is selected; else those at the selected points. */
export function selectedPanels(): number[] {
  if (selectedPanel.value !== null) return [selectedPanel.value];
  const opened = mesh.value;
  if (!opened || selection.value.length === 0) return [];
  const chosen = new Set(selection.value);
  const panels: number[] = [];
  for (let panel = 0; panel + 1 < opened.offsets.length; ++panel) {
    const corners = opened.vertices.subarray(opened.offsets[panel], opened.offsets[panel + 1]);
    if (corners.some((vertex) => chosen.has(vertex))) panels.push(panel);
  }
  return panels;
}

export function cuttingOptions({ scope, ...choice }: PanelChoice): CuttingOptions {
  const panels = scope === "selected" ? selectedPanels() : [];
  return { ...choice, ...named(), remakeOnly: scope === "remake", panels };
}

type Header = CuttingHeader | DrawnHeader;

const isDrawn = (header: Header): header is DrawnHeader => "missed" in header;

/** Once all that was asked for is done; the header, null if it was refused. */
async function make(
  doing: string,
  order: () => Promise<ShopOrder>,
  type: string,
  ending: string,
): Promise<Header | null> {
  let header: Header | null = null;
  await inTurn(async () => {
    const answer = await run(doing, { kind: "shop", order: await order() }, "made");
    if (!answer) return;
    save(new Blob([answer.file], { type }), ending);
    header = answer.header;
  });
  return header;
}

export async function exportPackage({
  withLink,
  ...choice
}: PackageChoice): Promise<CuttingHeader | null> {
  const order = async (): Promise<ShopOrder> => ({
    what: "package",
    options: cuttingOptions(choice),
    code: linkCode((withLink && (await designLink(null))) || ""),
  });
  const header = await make("writing the package", order, "application/zip", "-package.zip");
  return header && !isDrawn(header) ? header : null;
}

export async function exportIfc(choice: PanelChoice): Promise<CuttingHeader | null> {
  const order = async (): Promise<ShopOrder> => ({ what: "ifc", options: cuttingOptions(choice) });
  const header = await make("writing IFC", order, "application/x-step", ".ifc");
  return header && !isDrawn(header) ? header : null;
}

export async function exportDrawings(choice: DrawingChoice): Promise<DrawnHeader | null> {
  const order = async (): Promise<ShopOrder> => ({
    what: "drawings",
    options: { ...choice, ...named() },
  });
  const header = await make("drawing", order, "application/zip", "-drawings.zip");
  return header && isDrawn(header) ? header : null;
}
