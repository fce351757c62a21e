// SPDX-License-Identifier: MIT
import { decimal } from "../../design/flatness.ts";
import { planarise } from "../../state/opening.ts";
import { usePage } from "../../ui/page-context.ts";
import { AcceptTolerance } from "./accept-tolerance.tsx";
import { PlanariseStep } from "./planarise-step.tsx";

/** Why points of a mesh that is not flat cannot be moved yet, and the ways to where they can. */
export function NotFlatNote() {
  const page = usePage();
  const [report, chosen] = [page.mesh.value?.report, page.settings.value];
  if (!report || !chosen || page.baseFlat.value || page.importReport.value) return null;
  const worst = decimal(report.worstMmPerM);
  return (
    <div class="note">
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
