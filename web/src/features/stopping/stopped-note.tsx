// SPDX-License-Identifier: MIT

import { formatGap } from "../../quantity/units.ts";
import { settled } from "../../state/shortfall.ts";
import { usePage } from "../../ui/page-context.ts";
import { goOn, stopped } from "./going-on.ts";
import { HoldingPanels } from "./holding-panels.tsx";
import { gotWords, reasonWords, waysOn } from "./way-on.ts";

/** Mean edges: of less a figure in millimetres is all zeros. */
const WORTH_SAYING = 1e-6;

/** Where a point stops on its way to its target, why, and one press for each way on. */
export function StoppedNote() {
  const page = usePage();
  const [design, found] = [page.history.value?.present, stopped(page).value];
  if (!design || !found) return null;
  const { stop, reason, growth } = found;
  const { status, residuals } = design.report;
  const left = residuals.at(-1);
  const meanEdge = page.mesh.value?.report.meanEdge ?? 0;
  return (
    <section class="note warn" aria-label="Why the target is not reached">
      <p>
        <strong>{`${reason === "keep-outs" ? "Keep-outs" : "Panels"} allow ${gotWords(stop, page.unit.value)} here.`}</strong>{" "}
        {reasonWords(reason, growth)}
      </p>
      {reason === "panels" && <HoldingPanels />}
      {status === "infeasible_handles" && left !== undefined && left > WORTH_SAYING && (
        <p class="quiet">{`The last attempt left the panels up to ${formatGap(left * meanEdge, page.unit.value)} out of flat.`}</p>
      )}
      <fieldset class="ways-on" aria-label="Get further">
        {waysOn(design, reason, growth).map((way) => (
          <button
            key={way.label}
            type="button"
            class="button small"
            title={way.title}
            disabled={!page.ready.value || !settled(page).value}
            onClick={() => void goOn(page, way)}
          >
            {way.label}
          </button>
        ))}
      </fieldset>
    </section>
  );
}
