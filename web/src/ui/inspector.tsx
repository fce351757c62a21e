// SPDX-License-Identifier: MIT

import { useSignalEffect } from "@preact/signals";
import { decimal } from "../design/flatness.ts";
import { planarise } from "../state/opening.ts";
import { Ask } from "./ask.tsx";
import { ExactSection } from "./exact-section.tsx";
import { ExploreSection } from "./explore-section.tsx";
import { HandlesTable } from "./handles-table.tsx";
import { later } from "./later.tsx";
import { usePage } from "./page-context.ts";
import { ReachAndSoftness } from "./reach-and-softness.tsx";

function NotFlatNote() {
  const page = usePage();
  const [report, chosen] = [page.mesh.value?.report, page.settings.value];
  if (!report || !chosen || page.baseFlat.value || page.importReport.value) return null;
  const worst = decimal(report.worstMmPerM);
  return (
    <div class="note warn">
      <p>
        {`This mesh has panels that are not flat: up to ${worst} mm/m, with a tolerance of ${chosen.tolerance} mm/m. Points can be moved once they are.`}
      </p>
      <PlanariseStep live={false} />
      <button type="button" class="button primary" onClick={() => void planarise(page)}>
        Planarise
      </button>
      <AcceptTolerance />
    </div>
  );
}

const AcceptTolerance = later(() =>
  import("../features/planarising/accept-tolerance.tsx").then((part) => part.AcceptTolerance),
);

const PlanariseStep = later(() =>
  import("../features/planarising/planarise-step.tsx").then((part) => part.PlanariseStep),
);

const ImportReport = later(() =>
  import("../features/import-report/import-report.tsx").then((part) => part.ImportReport),
);

const StoppedNote = later(() =>
  import("../features/stopping/stopped-note.tsx").then((part) => part.StoppedNote),
);

const Limits = later(() =>
  import("../features/constraints/limits.tsx").then((part) => part.Limits),
);

const KeptKinds = later(() =>
  import("../features/constraints/kept-kinds.tsx").then((part) => part.KeptKinds),
);

const Advanced = later(() =>
  import("../features/advanced/advanced.tsx").then((part) => part.Advanced),
);

const LastSolve = later(() =>
  import("../features/advanced/last-solve.tsx").then((part) => part.LastSolve),
);

const SelectionStrip = later(() =>
  import("../features/selecting/selection-strip.tsx").then((part) => part.SelectionStrip),
);

const CutStrip = later(() => import("../features/cut/cut-strip.tsx").then((part) => part.CutStrip));

const KeptSections = later(() => import("./kept-sections.tsx").then((part) => part.KeptSections));

/** Where several points are selected, or about to be; beside the view, so that it covers none of them. */
function Several() {
  const page = usePage();
  const asked = page.areaTool.value ?? page.typedMove.value;
  return page.selection.value.length > 1 || asked ? <SelectionStrip /> : null;
}

/** Beside the view in which clicks cut. */
function Cutting() {
  return usePage().cutting.value ? <CutStrip /> : null;
}

/** On a telephone the controls are a sheet under the view: folded, they leave it all the room. */
export function SheetFold() {
  const page = usePage();
  const folded = page.sheetFolded;
  // What asks for attention is in there.
  useSignalEffect(() => {
    if (page.importReport.value || page.typedMove.value) folded.value = false;
  });
  return (
    <button
      type="button"
      class="sheet-fold"
      aria-expanded={!folded.value}
      aria-controls="inspector"
      onClick={() => {
        folded.value = !folded.value;
      }}
    >
      Controls
    </button>
  );
}

export function Inspector() {
  return (
    <aside id="inspector" class="inspector" aria-label="Inspector">
      <Several />
      <Cutting />
      <ImportReport />
      <section class="step edit-step" aria-labelledby="step-edit">
        <h2 id="step-edit">
          <span class="step-number">1</span> Edit
        </h2>
        <Ask about="edit" />
        <NotFlatNote />
        <HandlesTable />
        <StoppedNote />
        <ReachAndSoftness />
        <KeptKinds offered={true} />
        <Limits />
        <Advanced />
        <LastSolve />
      </section>
      <ExploreSection />
      <ExactSection />
      <KeptSections />
    </aside>
  );
}
