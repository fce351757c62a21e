// SPDX-License-Identifier: MIT
import { commitSettings, previewSettings } from "../state/editing.ts";
import { decimal } from "../state/flatness.ts";
import { planarise } from "../state/opening.ts";
import { baseFlat, importReport, mesh, ready, settings } from "../state/store.ts";
import { ExactSection } from "./exact-section.tsx";
import { ExploreSection } from "./explore-section.tsx";
import { HandlesTable } from "./handles-table.tsx";
import { later } from "./later.tsx";
import { ReachAndSoftness } from "./reach-and-softness.tsx";
import { Slider } from "./slider.tsx";

function NotFlatNote() {
  const [report, chosen] = [mesh.value?.report, settings.value];
  if (!report || !chosen || baseFlat.value || importReport.value) return null;
  const worst = decimal(report.worstMmPerM);
  return (
    <div class="note warn">
      <p>
        {`This mesh has panels that are not flat: up to ${worst} mm/m, with a tolerance of ${chosen.tolerance} mm/m. Points can be moved once they are.`}
      </p>
      <button type="button" class="button primary" onClick={() => void planarise()}>
        Planarise
      </button>
      <AcceptTolerance />
    </div>
  );
}

function Weights() {
  const { locality = 1, smoothness = 1, softness = 0 } = settings.value ?? {};
  const disabled = !ready.value || softness > 0; // softness stands for both
  return (
    <>
      <Slider
        label="Locality"
        value={locality}
        min={0}
        max={10}
        step={0.1}
        shown={`${locality.toFixed(1)} ×`}
        spoken={`${locality.toFixed(1)} times the default weight`}
        disabled={disabled}
        ends={["more points follow", "fewer follow"]}
        onInput={(value) => previewSettings({ locality: value })}
        onCommit={(value, burst) => commitSettings({ locality: value }, burst)}
      />
      <Slider
        label="Smoothness"
        value={smoothness}
        min={0}
        max={10}
        step={0.1}
        shown={`${smoothness.toFixed(1)} ×`}
        spoken={`${smoothness.toFixed(1)} times the default weight`}
        disabled={disabled}
        ends={["sharp, close by", "gentle, wider"]}
        onInput={(value) => previewSettings({ smoothness: value })}
        onCommit={(value, burst) => commitSettings({ smoothness: value }, burst)}
      />
      {softness > 0 && <p class="quiet small">Softness stands for both weights.</p>}
    </>
  );
}

const AcceptTolerance = later(() =>
  import("./accept-tolerance.tsx").then((part) => part.AcceptTolerance),
);
const ImportReport = later(() => import("./import-report.tsx").then((part) => part.ImportReport));
const RefusedNote = later(() => import("./refused-note.tsx").then((part) => part.RefusedNote));
const Advanced = later(() => import("./advanced.tsx").then((part) => part.Advanced));
const LastSolve = later(() => import("./last-solve.tsx").then((part) => part.LastSolve));
const SnapshotsSection = later(() =>
  import("./snapshots-section.tsx").then((part) => part.SnapshotsSection),
);

export function Inspector() {
  return (
    <aside class="inspector" aria-label="Inspector">
      <ImportReport />
      <section class="step edit-step" aria-labelledby="step-edit">
        <h2 id="step-edit">
          <span class="step-number">1</span> Edit
        </h2>
        <NotFlatNote />
        <HandlesTable />
        <ReachAndSoftness />
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
