// SPDX-License-Identifier: MIT
import { HandlesTable } from "./handles-table.tsx";
import { AboveHandles, UnderHandles, UnderRules } from "./places.ts";
import { ReachAndSoftness } from "./reach-and-softness.tsx";
import { Rules } from "./rules.tsx";

/** What moves points, and what an edit keeps to. */
export function EditSection() {
  return (
    <section class="step edit-step" aria-labelledby="step-edit">
      <h2 id="step-edit" class="visually-hidden">
        Edit
      </h2>
      <AboveHandles />
      <HandlesTable />
      <UnderHandles />
      <ReachAndSoftness />
      <Rules />
      <UnderRules />
    </section>
  );
}
