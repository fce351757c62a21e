// SPDX-License-Identifier: MIT
import { FLAT } from "../state/flatness.ts";
import { stopsShort } from "../state/stopping-short.ts";
import { history, mesh, unit } from "../state/store.ts";
import { formatGap, formatLength } from "../state/units.ts";
import { HoldingPanels } from "./holding-panels.tsx";

/** Why a point does not go where it was asked to: how far it stops short, and what holds it. */
export function RefusedNote() {
  const [design, base] = [history.value?.present, mesh.value?.positions];
  if (!design || !base || !stopsShort(design, base)) return null;
  const { status, handleError, residuals } = design.report;
  const short = formatLength(handleError, unit.value);
  const left = residuals.at(-1);
  const meanEdge = mesh.value?.report.meanEdge ?? 0;
  const impossible = status === "infeasible_handles";
  const limited = design.settings.limits.length > 0;
  return (
    <section class="note warn" aria-label="Why the target is not reached">
      <p>
        {impossible
          ? `The target cannot be reached while every panel stays flat${limited ? " and within the limits" : ""}: the point stops ${short} short. `
          : `The point stops ${short} short of its target. `}
        {`Move it less, let more points follow, ${limited ? "loosen a limit, " : ""}or remove a pin.`}
      </p>
      <HoldingPanels />
      {impossible && left !== undefined && 1000 * left > FLAT && (
        <p class="quiet">{`The last attempt left the panels up to ${formatGap(left * meanEdge, unit.value)} out of flat.`}</p>
      )}
    </section>
  );
}
