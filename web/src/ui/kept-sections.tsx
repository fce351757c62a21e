// SPDX-License-Identifier: MIT
// What is kept under names, at the end of the inspector.
import { GroupsSection } from "./groups-section.tsx";
import { NoteSection } from "./note-section.tsx";
import { NumbersSection } from "./numbers-section.tsx";
import { SectionPlaneSection } from "./section-plane.tsx";
import { SnapshotsSection } from "./snapshots-section.tsx";
import { ViewsSection } from "./views-section.tsx";

export const KeptSections = () => (
  <>
    <GroupsSection />
    <SnapshotsSection />
    <ViewsSection />
    <SectionPlaneSection />
    <NumbersSection />
    <NoteSection />
  </>
);
