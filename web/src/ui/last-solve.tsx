// SPDX-License-Identifier: MIT
import "./last-solve.css";
import { planarisingWords } from "../state/planarising.ts";
import { figures, freedom, mesh, unit, watchFreedom } from "../state/store.ts";
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

/** Of the points that move alone: how many ways are left to move them together. */
function freedomFacts(): readonly (readonly [string, string])[] {
  const report = freedom.value;
  if (!report) return [];
  const { points, equations, rank, freedom: ways } = report;
  return [
    ["Points that may move", `${points} (${3 * points} coordinates)`],
    ["Flatness equations on them", `${equations}, rank ${rank}`],
    ["Ways left to move them", String(ways)],
  ];
}

function planarisingFact(): readonly (readonly [string, string])[] {
  const report = mesh.value?.report;
  const words = report ? planarisingWords(report, unit.value) : "";
  return words ? [["Planarised first", words]] : [];
}

function facts(): readonly (readonly [string, string])[] {
  const { iterations, objective, handleError } = figures.value;
  return [
    ["Degrees of freedom of the mesh", String(mesh.value?.report.degreesOfFreedom ?? "–")],
    ...freedomFacts(),
    ...planarisingFact(),
    ["Steps", String(iterations)],
    ["Objective", objective.toPrecision(5)],
    ["Furthest from a target now", formatLength(handleError, unit.value)],
  ];
}

/** How the last solve went, and what it leaves free. */
export function LastSolve() {
  const { residuals } = figures.value;
  return (
    <details
      class="disclosure"
      onToggle={({ currentTarget }) => {
        watchFreedom.value = currentTarget.open;
      }}
    >
      <summary>Last solve</summary>
      <dl class="facts">
        {facts().map(([name, value]) => (
          <div key={name}>
            <dt>{name}</dt>
            <dd>{value}</dd>
          </div>
        ))}
      </dl>
      {residuals.length > 1 && <Curve residuals={residuals} />}
    </details>
  );
}
