// SPDX-License-Identifier: MIT
// Takes hold of points, or of an arrow at them, and holds the drag to what the tools say.

import { type Ray, Vector3 } from "three";
import { askedPoint, beginDrag, frameAt } from "../state/dragging.ts";
import { selectOnly } from "../state/selection.ts";
import { typedPull } from "../state/typed-pull.ts";
import { displayPlace } from "./display-place.ts";
import { DragSession, type HeldDrag } from "./drag-session.ts";
import { pixelSlope } from "./framing.ts";
import type { DragKeys, Hold } from "./pointer.ts";
import type { Sight } from "./sight.ts";

/** Pixels within which a snapped drag goes back to the base position. */
const HOME = 10;

/** The chosen points move with the one that was taken hold of; null if they cannot be moved. */
export function grip(sight: Sight, { vertex, arrow }: Hold, press: Ray): DragSession | null {
  const { page, shell, stage } = sight;
  if (!page.selection.value.includes(vertex)) selectOnly(page, vertex);
  const frame = frameAt(page, vertex);
  const others = page.selection.value.filter((v) => v !== vertex);
  const drag = beginDrag(page, [...others, vertex]);
  if (!shell || !frame || !drag) return null;
  return new DragSession(drag, {
    start: new Vector3(...displayPlace(page, askedPoint(page, vertex))),
    base: new Vector3().fromArray(shell.base, 3 * vertex),
    press,
    view: stage.camera.getWorldDirection(new Vector3()),
    frame,
    scale: page.mesh.value?.report.scale ?? 1,
    arrow,
  });
}

/** What holds a drag now; Ctrl turns snapping on, or off where it is on. */
export function holdOf(
  { page, stage }: Sight,
  { snap, free, through, coarse }: DragKeys,
): HeldDrag {
  const steps =
    page.snapping.value === snap
      ? null
      : { step: page.snapDistance.value, reach: HOME * stage.pixel() };
  const pixel = pixelSlope(stage.camera);
  const [lock, typed] = [page.lock.value, typedPull(page)];
  return { lock, snap: steps, free, through, pixel, byFinger: coarse, typed };
}
