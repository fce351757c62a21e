// SPDX-License-Identifier: MIT
import { figures, mesh, unit } from "../state/store.ts";
import { formatLength } from "../state/units.ts";

const WIDTH = 280;
const HEIGHT = 72;
/** Smaller residuals are rounding. */
const FLOOR = 1e-16;

const power = (residual: number): number => Math.log10(Math.max(residual, FLOOR));

/** The constraint residual of every step, on a logarithmic scale. */
function Curve({ residuals }: { residuals: readonly number[] }) {
  const powers = residuals.map(power);
  const [low, high] = [Math.min(...powers), Math.max(...powers)];
  const place = (value: number, k: number): string => {
    const x = (WIDTH * k) / Math.max(1, powers.length - 1);
    const y = 4 + ((HEIGHT - 8) * (high - value)) / Math.max(high - low, 1e-9);
    return `${x.toFixed(1)},${y.toFixed(1)}`;
  };
  const [first = 0, last = 0] = [residuals[0], residuals.at(-1)];
  const words = `Residual of ${residuals.length} steps, from ${first.toExponential(1)} to ${last.toExponential(1)} mean edges`;
  return (
    <figure class="curve">
      <svg viewBox={`0 0 ${WIDTH} ${HEIGHT}`} role="img" aria-label={words}>
        <polyline points={powers.map(place).join(" ")} />
      </svg>
      <figcaption class="quiet">{words}, logarithmic.</figcaption>
    </figure>
  );
}

/** How the last solve went, and what the mesh leaves free. */
export function LastSolve() {
  const { residuals, iterations, objective, handleError } = figures.value;
  const freedom = mesh.value?.report.degreesOfFreedom;
  return (
    <details class="disclosure">
      <summary>Last solve</summary>
      <dl class="facts">
        <div>
          <dt>Degrees of freedom</dt>
          <dd>{freedom ?? "–"}</dd>
        </div>
        <div>
          <dt>Steps</dt>
          <dd>{iterations}</dd>
        </div>
        <div>
          <dt>Objective</dt>
          <dd>{objective.toPrecision(5)}</dd>
        </div>
        <div>
          <dt>Furthest from a target</dt>
          <dd>{formatLength(handleError, unit.value)}</dd>
        </div>
      </dl>
      {residuals.length > 1 && <Curve residuals={residuals} />}
    </details>
  );
}
