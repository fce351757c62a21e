// SPDX-License-Identifier: MIT
// What the workshop gets is written by a module of its own, fetched when it is needed for the first time.
import type { Session } from "@wasm/planish.mjs";
import type {
  CuttingOptions,
  CuttingPreview,
  ShopDesign,
  ShopModule,
  ShopOrder,
  Written,
} from "@wasm/planish_shop.mjs";
import shopUrl from "@wasm/planish_shop.wasm?url";
import { plainOptions } from "./cutting-options.ts";

/** A new instance for each order: its memory, which only grows, goes when the order is done. */
async function loadShop(): Promise<ShopModule> {
  try {
    const { default: create } = await import("@wasm/planish_shop.mjs");
    return await create({ locateFile: () => shopUrl });
  } catch {
    throw new Error("The part that writes for the workshop could not be loaded. Try again online.");
  }
}

const designOf = (session: Session): ShopDesign => ({
  base: session.basePositions(),
  offsets: session.faceOffsets(),
  vertices: session.faceVertices(),
  moved: session.moved(),
  movedPositions: session.movedPositions(),
});

/** The design shown against its base; throws a sentence if it is refused. */
export async function writeForShop(session: Session, order: ShopOrder): Promise<Written> {
  const shop = await loadShop();
  const written = shop.write(designOf(session), order);
  if (written.problem) throw new Error(written.problem);
  return written;
}

/** What a package would hold. `face`: the panel to draw; `map`: whether the map is wanted. */
export async function previewPackage(
  session: Session,
  options: CuttingOptions,
  face: number,
  map: boolean,
): Promise<CuttingPreview> {
  const shop = await loadShop();
  return shop.cuttingPreview(designOf(session), options, face, map);
}

/** panels.csv in the model's own unit. */
export async function panelRows(session: Session, unit: string): Promise<string> {
  const shop = await loadShop();
  const { problem, csv } = shop.panelRows(designOf(session), plainOptions(unit, unit));
  if (problem) throw new Error(`The table of panels was refused: ${problem}.`);
  return csv;
}
