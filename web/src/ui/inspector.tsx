// SPDX-License-Identifier: MIT
import { commitSettings, previewSettings } from "../state/editing.ts";
import { planarise } from "../state/opening.ts";
import { figures, mesh, ready, settings, unit } from "../state/store.ts";
import { formatLength } from "../state/units.ts";
import { Advanced } from "./advanced.tsx";
import { ExactSection } from "./exact-section.tsx";
import { ExploreSection } from "./explore-section.tsx";
import { HandlesTable } from "./handles-table.tsx";
import { LastSolve } from "./last-solve.tsx";
import { Slider } from "./slider.tsx";
import { SnapshotsSection } from "./snapshots-section.tsx";

function NotFlatNote() {
  const report = mesh.value?.report;
  if (!report || report.flat) return null;
  return (
    <div class="note warn">
      <p>This mesh has panels that are not flat. Points can be moved once they are.</p>
      <button type="button" class="button primary" onClick={() => void planarise()}>
        Planarise
      </button>
    </div>
  );
}

function Weights() {
  const { locality = 1, smoothness = 1 } = settings.value ?? {};
  return (
    <>
      <Slider
        label="Locality"
        value={locality}
        min={0}
        max={10}
        step={0.1}
        shown={locality.toFixed(1)}
        disabled={!ready.value}
        ends={["more points follow", "fewer follow"]}
        onInput={(value) => previewSettings({ locality: value })}
        onCommit={(value) => void commitSettings({ locality: value })}
      />
      <Slider
        label="Smoothness"
        value={smoothness}
        min={0}
        max={10}
        step={0.1}
        shown={smoothness.toFixed(1)}
        disabled={!ready.value}
        ends={["sharp, close by", "gentle, wider"]}
        onInput={(value) => previewSettings({ smoothness: value })}
        onCommit={(value) => void commitSettings({ smoothness: value })}
      />
    </>
  );
}

/** Why a point does not go where it was asked to. */
function RefusedNote() {
  const { status, handleError } = figures.value;
  if (status !== "infeasible_handles") return null;
  return (
    <div class="note warn">
      <p>
        {`The target cannot be reached while every panel stays flat: the point stops ${formatLength(handleError, unit.value)} short. Move it less, let more points follow, or remove a pin.`}
      </p>
    </div>
  );
}

export function Inspector() {
  return (
    <aside class="inspector" aria-label="Inspector">
      <section class="step" aria-labelledby="step-edit">
        <h2 id="step-edit">
          <span class="step-number">1</span> Edit
        </h2>
        <NotFlatNote />
        <HandlesTable />
        <Weights />
        <RefusedNote />
        <Advanced />
        <LastSolve />
      </section>
      <ExploreSection />
      <ExactSection />
      <SnapshotsSection />
    </aside>
  );
}
