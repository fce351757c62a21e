// SPDX-License-Identifier: MIT
import { figures, unit } from "../state/store.ts";
import { formatLength } from "../state/units.ts";
import { HoldingPanels } from "./holding-panels.tsx";

/** Why a point does not go where it was asked to: how far it stops short, and what holds it. */
export function RefusedNote() {
  const { status, handleError, residuals } = figures.value;
  if (status !== "infeasible_handles") return null;
  const left = residuals.at(-1);
  return (
    <section class="note warn" aria-label="Why the target is not reached">
      <p>
        {`The target cannot be reached while every panel stays flat: the point stops ${formatLength(handleError, unit.value)} short. Move it less, let more points follow, or remove a pin.`}
      </p>
      <HoldingPanels />
      {left !== undefined && (
        <p class="quiet">{`The last attempt left the panels ${left.toExponential(1)} mean edges out of flat.`}</p>
      )}
    </section>
  );
}
