// SPDX-License-Identifier: MIT
// The optional features, in the order in which their parts stand where several share a place.
import type { Page } from "../state/page.ts";
import * as at from "../ui/places.ts";
import { register as analysis } from "./analysis/register.ts";
import { register as cleanView } from "./clean-view/register.ts";
import { register as comparing } from "./comparing/register.ts";
import { register as context } from "./context/register.ts";
import { register as cut } from "./cut/register.ts";
import { register as exploring } from "./exploring/register.ts";
import { register as help } from "./help/register.ts";
import { register as hiding } from "./hiding/register.ts";
import { register as numbers } from "./numbers/register.ts";
import { PaletteDialog } from "./palette/palette-dialog.tsx";
import { ConjugacyScale } from "./planarising/net-parts.tsx";
import { register as secondLayer } from "./second-layer/register.ts";
import { register as selecting } from "./selecting/register.ts";
import { register as sharing } from "./sharing/register.ts";
import { register as shop } from "./shop/register.ts";
import { register as touch } from "./touch/register.ts";
import { register as views } from "./views/register.ts";

/** Before the page is drawn. A feature of components alone has their places here; one with commands or followers of
 * the view registers itself. */
export function registerFeatures(page: Page): void {
  at.OpenedFile.later(page, "ImportReport", () => import("./import-report/import-report.tsx"));
  at.AboveHandles.later(page, "NotFlatNote", () => import("./planarising/not-flat-note.tsx"));
  at.PreviewWords.later(page, "PreviewWords", () => import("./planarising/preview-words.tsx"));
  at.ENDS.conjugacy.put(page, ConjugacyScale);
  at.UnderTable.later(page, "MeetTargets", () => import("./stopping/stopped-note.tsx"));
  at.UnderHandles.later(page, "StoppedNote", () => import("./stopping/stopped-note.tsx"));
  at.UnderHandles.later(page, "SettledNote", () => import("./stopping/settled-note.tsx"));
  at.HandleGroups.later(page, "HandleGroup", () => import("./handles/handle-group.tsx"));
  at.UnderTable.later(page, "LowerSolution", () => import("./handles/lower-solution.tsx"));
  at.UnderSelected.later(page, "SurfaceMove", () => import("./handles/surface-move.tsx"));
  at.UnderSelected.later(page, "Position", () => import("./handles/position.tsx"));
  exploring(page);
  comparing(page);
  at.UnderSoftness.later(page, "FewPanels", () => import("./few-panels/few-panels.tsx"));
  at.EDITORS.limits.later(page, "Limits", () => import("./constraints/limits.tsx"));
  at.RuleNotes.later(page, "LimitStanding", () => import("./constraints/limits.tsx"));
  at.UnderRules.later(page, "OfferedKinds", () => import("./constraints/kept-kinds.tsx"));
  at.EDITORS.supports.later(page, "PointSupports", () => import("./supports/point-supports.tsx"));
  at.EDITORS.keepOuts.later(page, "KeepOuts", () => import("./keep-outs/keep-outs-section.tsx"));
  at.EDITORS.symmetry.later(page, "SymmetryRule", () => import("./symmetry/symmetry-section.tsx"));
  at.UnderRules.later(page, "Advanced", () => import("./advanced/advanced.tsx"));
  at.SECTIONS.edit.later(page, "GroupsSection", () => import("./groups/groups-section.tsx"));
  at.LEGENDS.groups.later(page, "GroupsScale", () => import("./groups/groups-scale.tsx"));
  analysis(page);
  at.PanelLists.later(page, "PanelsTable", () => import("./panels/panels-table.tsx"));
  at.StatusNotes.later(page, "TypesNote", () => import("./types/types-note.tsx"));
  at.LEGENDS.types.later(page, "TypesScale", () => import("./types/types-scale.tsx"));
  at.ENDS.mobility.later(page, "MobilityScale", () => import("./mobility/mobility-scale.tsx"));
  selecting(page);
  cut(page);
  at.ViewNotes.later(page, "ReceivedNote", () => import("./notes/note-section.tsx"));
  touch(page);
  secondLayer(page);
  at.SECTIONS.check.later(page, "LastSolveSection", () => import("./advanced/last-solve.tsx"));
  at.SECTIONS.check.later(page, "NoteSection", () => import("./notes/note-section.tsx"));
  hiding(page);
  context(page);
  cleanView(page);
  at.ViewSections.later(page, "SectionControls", () => import("./section/section-controls.tsx"));
  numbers(page);
  views(page);
  sharing(page);
  help(page);
  at.BarEnd.put(page, PaletteDialog);
  shop(page);
}
