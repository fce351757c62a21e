// SPDX-License-Identifier: MIT
import { panelsOf } from "../state/panel-rows.ts";
import { panelHealth } from "../state/store.ts";
import { ClassScale } from "./class-scale.tsx";

const WORDS = ["convex", "concave", "crosses itself (bow-tie)"] as const;

/** Whether panels can be made. */
export function HealthScale() {
  const health = panelHealth.value;
  const classes = WORDS.map((word, outline) => ({
    word,
    place: outline / 2,
    panels: health && panelsOf(health, "outline", outline),
  }));
  return <ClassScale classes={classes} />;
}
