// SPDX-License-Identifier: MIT

import { drawPatch, patchOf } from "../../scene/patch-drawing.ts";
import type { Page } from "../../state/page.ts";

/** CSS pixels. */
const SIZE = [88, 66] as const;

/** The last finished design as a small picture, a data: address; "" if it cannot be drawn. */
export function snapshotPicture(page: Page): string {
  const design = page.history.value?.present;
  const opened = page.mesh.value;
  if (!design || !opened) return "";
  const canvas = document.createElement("canvas");
  drawPatch(canvas, opened, patchOf(opened, [design.shape]), design.shape, SIZE);
  return canvas.toDataURL("image/webp", 0.9);
}
