// SPDX-License-Identifier: MIT
// Cutting packages are written by a module of its own, fetched when it is needed for the first time.
import type { Session } from "@wasm/planish.mjs";
import type {
  CuttingOptions,
  CuttingPreview,
  ShopModule,
  WrittenPackage,
} from "@wasm/planish_shop.mjs";
import shopUrl from "@wasm/planish_shop.wasm?url";

/** A new instance for each package: its memory, which only grows, goes when the package is done. */
async function loadShop(): Promise<ShopModule> {
  try {
    const { default: create } = await import("@wasm/planish_shop.mjs");
    return await create({ locateFile: () => shopUrl });
  } catch {
    throw new Error("The part that writes cutting packages could not be loaded. Try again online.");
  }
}

/** The design shown, with its base, as the module takes it. */
const meshOf = (session: Session) =>
  [
    session.basePositions(),
    session.faceOffsets(),
    session.faceVertices(),
    session.moved(),
    session.movedPositions(),
  ] as const;

/** The design shown against its base; throws a sentence if it is refused. */
export async function writePackage(
  session: Session,
  options: CuttingOptions,
): Promise<WrittenPackage> {
  const shop = await loadShop();
  const written = shop.cuttingPackage(...meshOf(session), options);
  if (written.problem) throw new Error(written.problem);
  return written;
}

/** What writePackage() would write. `face`: the panel to draw; `map`: whether the map is wanted. */
export async function previewPackage(
  session: Session,
  options: CuttingOptions,
  face: number,
  map: boolean,
): Promise<CuttingPreview> {
  const shop = await loadShop();
  return shop.cuttingPreview(...meshOf(session), options, face, map);
}

/** panels.csv in the model's own unit. */
export async function panelRows(session: Session, unit: string): Promise<string> {
  const shop = await loadShop();
  const options: CuttingOptions = {
    name: "",
    modelUnit: unit,
    unit,
    gap: 0,
    thickness: 0,
    sheetWidth: 0,
    sheetHeight: 0,
    remakeOnly: false,
  };
  const { problem, csv } = shop.panelRows(...meshOf(session), options);
  if (problem) throw new Error(`The table of panels was refused: ${problem}.`);
  return csv;
}
