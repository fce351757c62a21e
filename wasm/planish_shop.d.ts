// SPDX-License-Identifier: MIT
// What shop_bindings.cpp lists, by hand.

/** The core's CuttingOptions; lengths in `unit`. */
export interface CuttingOptions {
  readonly name: string;
  readonly modelUnit: string;
  readonly unit: string;
  readonly gap: number;
  /** 0: not known. */
  readonly thickness: number;
  /** Both 0: no sheets. */
  readonly sheetWidth: number;
  readonly sheetHeight: number;
  /** Draws only what must be made again. */
  readonly remakeOnly: boolean;
}

/** With `problem` not empty the rest is absent. */
export interface WrittenPackage {
  readonly problem: string;
  readonly zip: Uint8Array;
  /** package.json without its tables. */
  readonly header: string;
}

export interface ShopModule {
  /** Against `base`; `moved`: the vertices that lie elsewhere, with their positions. */
  cuttingPackage(
    base: Float64Array,
    offsets: Int32Array,
    vertices: Int32Array,
    moved: Int32Array,
    movedPositions: Float64Array,
    options: CuttingOptions,
  ): WrittenPackage;
}

export default function createPlanishShop(options?: object): Promise<ShopModule>;
