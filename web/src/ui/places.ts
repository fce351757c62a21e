// SPDX-License-Identifier: MIT
// Where features put their controls and notes; features/all-features.ts has the order of those that share a place.
import type { Signal } from "@preact/signals";
import type { HandleRow } from "../design/design.ts";
import type { Rule } from "../state/inspector.ts";
import { type Place, place } from "./place.tsx";

export interface HandleGroupProps {
  readonly rows: readonly HandleRow[];
  /** "pinned", "handles". */
  readonly kind: string;
  /** Whether they are listed one by one as well. */
  readonly listed: Signal<boolean>;
}

/** Buttons of the top bar, with the dialogs that they open. */
export const BarEnd = place();

/** By tab; those of Edit stand under what moves points. */
export const SECTIONS = { edit: place(), explore: place(), check: place() };
export const ViewSections = place();
/** What is said of a file that was opened, over all that edits. */
export const OpenedFile = place();
/** What is going on in the view, over the sections. */
export const Strips = place();
/** Tools in the strip of the selected points that change the view alone. */
export const SelectionSight = place();

export const AboveHandles = place();
/** In place of handles that are too many to be listed. */
export const HandleGroups = place<HandleGroupProps>();
export const UnderTable = place();
export const UnderSelected = place();
export const UnderHandles = place();
export const UnderSoftness = place();
/** What states a rule, where it is unfolded. */
export const EDITORS: Readonly<Record<Rule, Place>> = {
  limits: place(),
  supports: place(),
  keepOuts: place(),
  symmetry: place(),
};
/** What has become of the rules of an edit. */
export const RuleNotes = place();
export const UnderRules = place();

/** Whether the panels are flat and sound. */
export const Verdicts = place();
export const PanelLists = place();

/** Drag tools that clicks in the view are for. */
export const ClickTools = place();
export const LastTools = place();
export const PanelFigures = place();
/** What the view shows while a way to make a mesh flat is tried out. */
export const PreviewWords = place();
export const ViewNotes = place();

export const Histograms = place();
/** All that the legend says of a colour. */
export const LEGENDS = { health: place(), remake: place(), types: place(), groups: place() };
/** What stands under the bar of a colour. */
export const ENDS = { planarity: place(), mobility: place(), conjugacy: place() };

/** In the line of figures, and after it. */
export const FigureNotes = place();
export const StatusNotes = place();
/** Notes of the file that is open. */
export const FileNotes = place();
