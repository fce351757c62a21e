// SPDX-License-Identifier: MIT
// Panels that an edit, a variation or planarising has spoilt, although each of them is flat.

import { newSliver } from "virtual:core-defaults";
import { computed } from "@preact/signals";
import { PER_PANEL } from "../solver/protocol.ts";
import { formatDegrees } from "./fold.ts";
import { kept } from "./page.ts";

/** Words for one panel and for several: by the core's PanelDamage, the most serious first; then new slivers. */
export const DAMAGES: readonly (readonly [string, string])[] = [
  ["", ""],
  ["crosses itself", "cross themselves"],
  ["is turned over", "are turned over"],
  ["has collapsed", "have collapsed"],
  ["became concave", "became concave"],
  ["became a sliver", "became slivers"],
];
/** " (corner 12°)", " (corners from 9°)": the sharpest of them; "" without measured panels. */
function sharpestWords(damage: Uint8Array, health: Float32Array | null): string {
  if (!health) return "";
  const angles = Array.from(damage).flatMap((kind, panel) => {
    const angle = health[PER_PANEL.health * panel + 2];
    return kind === newSliver && angle !== undefined ? [angle] : [];
  });
  const sharpest = formatDegrees(Math.min(...angles));
  return angles.length > 1 ? ` (corners from ${sharpest})` : ` (corner ${sharpest})`;
}

/** Spoilt panels, the most serious damage first, then by number. */
export function spoiltPanels(damage: Uint8Array): readonly number[] {
  const classes = DAMAGES.map((): number[] => []);
  damage.forEach((kind, panel) => {
    if (kind > 0) classes[kind]?.push(panel);
  });
  return classes.flat();
}

/** "1 panel crosses itself, 3 became concave, 1 became a sliver (corner 12°)"; "" where nothing is spoilt. */
export function damageWords(damage: Uint8Array, health: Float32Array | null = null): string {
  const counts = DAMAGES.map(() => 0);
  for (const kind of damage) counts[kind] = (counts[kind] ?? 0) + 1;
  const parts = DAMAGES.flatMap(([one, several], kind) => {
    const count = kind > 0 ? (counts[kind] ?? 0) : 0;
    const words = count === 1 ? one : several;
    const angle = count > 0 && kind === newSliver ? sharpestWords(damage, health) : "";
    return count > 0 ? [{ count, words: words + angle }] : [];
  });
  return parts
    .map(({ count, words }, k) => {
      const noun = k > 0 ? "" : count === 1 ? " panel" : " panels";
      return `${count}${noun} ${words}`;
    })
    .join(", ");
}

/** The damage of the design shown; null while it changes or is not measured yet. */
export const damage = kept((page) =>
  computed(() =>
    page.draft.value === page.history.value?.present ? page.panelDamage.value : null,
  ),
);

/** The core's figures of each panel, measured together with the damage: those of the design shown, or null
 * (`panelHealth` itself is an earlier design's until the next is measured). */
export const healthShown = kept((page) =>
  computed(() => (damage(page).value === null ? null : page.panelHealth.value)),
);
