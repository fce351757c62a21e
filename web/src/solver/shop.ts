// SPDX-License-Identifier: MIT
// What the workshop gets is written by the module of documents.
import type { Session } from "@wasm/planish.mjs";
import type {
  CuttingOptions,
  CuttingPreview,
  MeshOffset,
  OffsetKind,
  PanelTypes,
  ShopDesign,
  ShopModule,
  ShopOrder,
  Written,
} from "@wasm/planish_documents.mjs";
import { plainOptions } from "./cutting-options.ts";
import { loadDocuments } from "./documents.ts";
import type { Shape } from "./protocol.ts";

/** A new instance for each order: its memory, which only grows, goes when the order is done. */
async function loadPart(): Promise<ShopModule> {
  try {
    return await loadDocuments();
  } catch {
    throw new Error("The part that writes for the workshop could not be loaded. Try again online.");
  }
}

/** `shape`: null for the one shown. */
const designOf = (session: Session, shape: Shape | null = null): ShopDesign => ({
  base: session.basePositions(),
  offsets: session.faceOffsets(),
  vertices: session.faceVertices(),
  moved: shape ? shape.moved : session.moved(),
  movedPositions: shape ? shape.positions : session.movedPositions(),
  parents: session.panelParents(),
});

export interface ShopFile {
  /** The page hands it on without ever holding its bytes. */
  readonly file: Blob;
  readonly header: Written["header"];
}

/** The design shown against its base; throws a sentence if it is refused. */
export async function writeForShop(session: Session, order: ShopOrder): Promise<ShopFile> {
  const shop = await loadPart();
  const pieces: Blob[] = [];
  const { problem, header } = shop.write(designOf(session), order, (piece) => {
    pieces.push(new Blob([piece as BlobPart]));
  });
  if (problem) throw new Error(problem);
  return { file: new Blob(pieces), header };
}

/** What a package would hold. `face`: the panel to draw; `map`: whether the map is wanted. */
export async function previewPackage(
  session: Session,
  options: CuttingOptions,
  face: number,
  map: boolean,
): Promise<CuttingPreview> {
  const shop = await loadPart();
  return shop.cuttingPreview(designOf(session), options, face, map);
}

/** Which panels are alike, within a share of the mean edge. `shape`: null for the design shown. */
export async function panelTypes(
  session: Session,
  shape: Shape | null,
  share: number,
  mirrored: boolean,
): Promise<PanelTypes> {
  const shop = await loadPart();
  return shop.panelTypes(designOf(session, shape), share, mirrored);
}

/** The design shown at a distance, model units. `kind`: "" for the first that it has. */
export async function offsetOf(
  session: Session,
  distance: number,
  kind: OffsetKind | "",
): Promise<MeshOffset> {
  const shop = await loadPart();
  return shop.offsetMesh(designOf(session), distance, kind);
}

/** panels.csv in the model's own unit. */
export async function panelRows(session: Session, unit: string): Promise<string> {
  const shop = await loadPart();
  const { problem, csv } = shop.panelRows(designOf(session), plainOptions(unit, unit));
  if (problem) throw new Error(`The table of panels was refused: ${problem}.`);
  return csv;
}
