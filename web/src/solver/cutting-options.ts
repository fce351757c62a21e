// SPDX-License-Identifier: MIT
import type { CuttingOptions } from "@wasm/planish_documents.mjs";

/** Every panel is drawn by itself. */
export const WITHOUT_TYPES = { jointBy: 0, mirrored: false, byType: false } as const;

/** Options of all panels, without joints, thickness, sheets or a name. */
export const plainOptions = (modelUnit: string, unit: string): CuttingOptions => ({
  name: "",
  modelUnit,
  unit,
  gap: 0,
  thickness: 0,
  sheetWidth: 0,
  sheetHeight: 0,
  textHeight: 0,
  ...WITHOUT_TYPES,
  remakeOnly: false,
  panels: [],
});
