// SPDX-License-Identifier: MIT
import { history, mesh } from "../state/store.ts";
import { drawPatch, patchOf } from "./patch-drawing.ts";

/** CSS pixels. */
const SIZE = [88, 66] as const;

/** The last finished design as a small picture, a data: address; "" if it cannot be drawn. */
export function snapshotPicture(): string {
  const design = history.value?.present;
  const opened = mesh.value;
  if (!design || !opened) return "";
  const canvas = document.createElement("canvas");
  drawPatch(canvas, opened, patchOf(opened, [design.shape]), design.shape, SIZE);
  return canvas.toDataURL("image/webp", 0.9);
}
