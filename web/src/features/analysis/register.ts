// SPDX-License-Identifier: MIT
import { followers } from "../../scene/followers.ts";
import type { Page } from "../../state/page.ts";
import {
  ENDS,
  FigureNotes,
  Histograms,
  LEGENDS,
  PanelFigures,
  StatusNotes,
  Verdicts,
} from "../../ui/places.ts";
import { followLooks } from "./look-follower.ts";

export function register(page: Page): void {
  Verdicts.later(page, "Verdict", () => import("./panel-notes.tsx"));
  FigureNotes.later(page, "DamageNote", () => import("./panel-notes.tsx"));
  StatusNotes.later(page, "RemakeNote", () => import("./panel-notes.tsx"));
  PanelFigures.later(page, "PanelFigure", () => import("./panel-figure.tsx"));
  Histograms.later(page, "Histogram", () => import("./histogram-chart.tsx"));
  LEGENDS.health.later(page, "HealthScale", () => import("./class-scale.tsx"));
  LEGENDS.remake.later(page, "RemakeScale", () => import("./class-scale.tsx"));
  ENDS.planarity.later(page, "PlanarityScale", () => import("./planarity-scale.tsx"));
  followers(page).push(followLooks);
}
