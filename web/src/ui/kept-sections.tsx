// SPDX-License-Identifier: MIT
// What is kept under names, and what few need, at the end of the inspector.

import { SnapshotsSection } from "../features/comparing/snapshots-section.tsx";
import { CutSection } from "../features/cut/cut-section.tsx";
import { GroupsSection } from "../features/groups/groups-section.tsx";
import { NoteSection } from "../features/notes/note-section.tsx";
import { NumbersSection } from "../features/numbers/numbers-section.tsx";
import { SectionPlaneSection } from "../features/section/section-controls.tsx";
import { ViewsSection } from "../features/views/views-section.tsx";

export const KeptSections = () => (
  <>
    <GroupsSection />
    <SnapshotsSection />
    <ViewsSection />
    <SectionPlaneSection />
    <CutSection />
    <NumbersSection />
    <NoteSection />
  </>
);
