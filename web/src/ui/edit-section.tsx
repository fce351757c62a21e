// SPDX-License-Identifier: MIT
// What moves points, and what an edit keeps to.

import { decimal } from "../design/flatness.ts";
import { goToTab } from "../state/inspector.ts";
import { planarise } from "../state/opening.ts";
import { COMMANDS } from "./commands/commands.ts";
import { HandlesTable } from "./handles-table.tsx";
import { later } from "./later.tsx";
import { usePage } from "./page-context.ts";
import { ReachAndSoftness } from "./reach-and-softness.tsx";
import { Rules } from "./rules.tsx";

const AcceptTolerance = later(() =>
  import("../features/planarising/accept-tolerance.tsx").then((part) => part.AcceptTolerance),
);

const PlanariseStep = later(() =>
  import("../features/planarising/planarise-step.tsx").then((part) => part.PlanariseStep),
);

const SettledNote = later(() =>
  import("../features/stopping/settled-note.tsx").then((part) => part.SettledNote),
);

const StoppedNote = later(() =>
  import("../features/stopping/stopped-note.tsx").then((part) => part.StoppedNote),
);

const KeptKinds = later(() =>
  import("../features/constraints/kept-kinds.tsx").then((part) => part.KeptKinds),
);

const Advanced = later(() =>
  import("../features/advanced/advanced.tsx").then((part) => part.Advanced),
);

function NotFlatNote() {
  const page = usePage();
  const [report, chosen] = [page.mesh.value?.report, page.settings.value];
  if (!report || !chosen || page.baseFlat.value || page.importReport.value) return null;
  const worst = decimal(report.worstMmPerM);
  return (
    <div class="note warn">
      <p>
        {`This mesh has panels that are not flat: up to ${worst} mm/m, with a tolerance of ${chosen.tolerance} mm/m. Points can be moved once they are, or once you choose to edit it as it is.`}
      </p>
      <PlanariseStep live={false} />
      <button type="button" class="button primary" onClick={() => void planarise(page)}>
        Planarise
      </button>
      <AcceptTolerance />
    </div>
  );
}

/** What is done after an edit is in the other tabs. */
function NextSteps() {
  const page = usePage();
  if (!page.ready.value || page.figures.value.movedVertices === 0) return null;
  return (
    <div class="next-steps">
      <span class="quiet small">Next:</span>
      <button
        type="button"
        class="button small"
        onClick={() => void COMMANDS.findVariations.run(page)}
      >
        {COMMANDS.findVariations.label}
      </button>
      <button type="button" class="button small" onClick={() => goToTab(page, "check")}>
        Check its panels
      </button>
    </div>
  );
}

export function EditSection() {
  return (
    <section class="step edit-step" aria-labelledby="step-edit">
      <h2 id="step-edit" class="visually-hidden">
        Edit
      </h2>
      <NotFlatNote />
      <HandlesTable />
      <StoppedNote />
      <SettledNote />
      <NextSteps />
      <ReachAndSoftness />
      <Rules />
      <KeptKinds offered={true} />
      <Advanced />
    </section>
  );
}
