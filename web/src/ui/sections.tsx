// SPDX-License-Identifier: MIT
// The sections of the controls, each with its place, in their order: a tab of the inspector, or the options of
// the view.
import type { ComponentType } from "preact";
import type { Tab } from "../state/inspector.ts";
import { EditSection } from "./edit-section.tsx";
import { ExactSection } from "./exact-section.tsx";
import { ExploreSection } from "./explore-section.tsx";
import { later } from "./later.tsx";

type Place = Tab | "view";

interface Section {
  readonly place: Place;
  readonly name: string;
  readonly Content: ComponentType;
}

/** A section that comes once the page can be used: the component `Name` of a module of its feature. */
const section = <Name extends string>(
  place: Place,
  name: Name,
  load: () => Promise<Readonly<Record<Name, ComponentType>>>,
): Section => ({ place, name, Content: later(() => load().then((part) => part[name])) });

export const SECTIONS: readonly Section[] = [
  section("edit", "ImportReport", () => import("../features/import-report/import-report.tsx")),
  { place: "edit", name: "Edit", Content: EditSection },
  section("edit", "CutSection", () => import("../features/cut/cut-section.tsx")),
  section("edit", "GroupsSection", () => import("../features/groups/groups-section.tsx")),
  { place: "explore", name: "Explore", Content: ExploreSection },
  section(
    "explore",
    "SnapshotsSection",
    () => import("../features/comparing/snapshots-section.tsx"),
  ),
  { place: "check", name: "Exact", Content: ExactSection },
  section("check", "LayerSection", () => import("../features/second-layer/layer-section.tsx")),
  section("check", "LastSolveSection", () => import("../features/advanced/last-solve.tsx")),
  section("check", "NoteSection", () => import("../features/notes/note-section.tsx")),
  section("view", "CleanSection", () => import("../features/clean-view/clean-section.tsx")),
  section("view", "SectionPlaneSection", () => import("../features/section/section-controls.tsx")),
  section("view", "NumbersSection", () => import("../features/numbers/numbers-section.tsx")),
  section("view", "ViewsSection", () => import("../features/views/views-section.tsx")),
];
