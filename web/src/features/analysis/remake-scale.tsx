// SPDX-License-Identifier: MIT

import { remakePlace } from "../../scene/ramp.ts";
import { panelsChanged } from "../../state/panel-rows.ts";
import { usePage } from "../../ui/page-context.ts";
import { ClassScale } from "./class-scale.tsx";

/** By the core's PanelChange, in the order of the ramp. */
const CLASSES = [
  ["unchanged", 0],
  ["new bevel only", 2],
  ["cut again", 1],
] as const;

/** What the shop makes again after the edit. */
export function RemakeScale() {
  const page = usePage();
  const health = page.panelHealth.value;
  const classes = CLASSES.map(([word, change]) => ({
    word,
    place: remakePlace(change),
    panels: health && panelsChanged(health, change),
  }));
  return <ClassScale classes={classes} />;
}
