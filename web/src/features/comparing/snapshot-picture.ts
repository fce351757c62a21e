// SPDX-License-Identifier: MIT

import type { Design } from "../../design/design.ts";
import { drawPatch, patchOf } from "../../scene/patch-drawing.ts";
import type { Page } from "../../state/page.ts";

/** CSS pixels. */
const SIZE = [88, 66] as const;

/** A design of the mesh that is open as a small picture, a data: address; "" if it cannot be drawn. */
export function snapshotPicture(page: Page, { shape }: Design): string {
  const opened = page.mesh.value;
  if (!opened) return "";
  const canvas = document.createElement("canvas");
  drawPatch(canvas, opened, patchOf(opened, [shape]), shape, SIZE);
  return canvas.toDataURL("image/webp", 0.9);
}
