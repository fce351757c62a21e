// SPDX-License-Identifier: MIT
// Cutting packages are written by a module of its own, fetched when it is needed for the first time.
import type { Session } from "@wasm/planish.mjs";
import type { CuttingOptions, ShopModule, WrittenPackage } from "@wasm/planish_shop.mjs";
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

/** The design shown against its base; throws a sentence if it is refused. */
export async function writePackage(
  session: Session,
  options: CuttingOptions,
): Promise<WrittenPackage> {
  const shop = await loadShop();
  const written = shop.cuttingPackage(
    session.basePositions(),
    session.faceOffsets(),
    session.faceVertices(),
    session.moved(),
    session.movedPositions(),
    options,
  );
  if (written.problem) throw new Error(written.problem);
  return written;
}
