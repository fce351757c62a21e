// SPDX-License-Identifier: MIT
import type { Page } from "../../state/page.ts";
import { usePage } from "../../ui/page-context.ts";
import "./last-solve.css";
import { planarisingWords } from "../../design/planarising.ts";
import { convert, formatLength } from "../../quantity/units.ts";

const WIDTH = 280;

const HEIGHT = 72;
/** Smaller residuals are rounding. */
const FLOOR = 1e-16;

const power = (residual: number): number => Math.log10(Math.max(residual, FLOOR));

/** Mean edges, as the solver counts, in millimetres; below a ten-thousandth there is nothing to see. */
function inMillimetres(page: Page, meanEdges: number): string {
  const mm = convert(meanEdges * (page.mesh.value?.report.meanEdge ?? 1), page.unit.value, "mm");
  return mm < 1e-4 ? "less than 0.0001 mm" : `${Number(mm.toPrecision(2))} mm`;
}

/** How far panels are out of flat after every step, on a logarithmic scale. */
function Curve({ residuals }: { residuals: readonly number[] }) {
  const page = usePage();
  const powers = residuals.map(power);
  const [low, high] = [Math.min(...powers), Math.max(...powers)];
  const place = (value: number, k: number): string => {
    const x = (WIDTH * k) / Math.max(1, powers.length - 1);
    const y = 4 + ((HEIGHT - 8) * (high - value)) / Math.max(high - low, 1e-9);
    return `${x.toFixed(1)},${y.toFixed(1)}`;
  };
  const [first = 0, last = 0] = [residuals[0], residuals.at(-1)];
  const words = `Residual of ${residuals.length} steps, from ${inMillimetres(page, first)} to ${inMillimetres(page, last)}`;
  return (
    <figure class="curve">
      <svg viewBox={`0 0 ${WIDTH} ${HEIGHT}`} role="img" aria-label={words}>
        <polyline points={powers.map(place).join(" ")} />
      </svg>
      <figcaption class="quiet">
        {words}, logarithmic: how far panels still were out of flat.
      </figcaption>
    </figure>
  );
}

/** How many ways are left to move together the points that move. */
function freedomFacts(page: Page): readonly (readonly [string, string])[] {
  const report = page.freedom.value;
  if (!report) return [];
  const { points, equations, rank, freedom: ways } = report;
  return [
    ["Points that may move", `${points} (${3 * points} coordinates)`],
    ["Flatness equations on them", `${equations}, rank ${rank}`],
    ["Independent ways left", String(ways)],
  ];
}

function planarisingFact(page: Page): readonly (readonly [string, string])[] {
  const report = page.mesh.value?.report;
  const words = report ? planarisingWords(report, page.unit.value) : "";
  return words ? [["Planarised first", words]] : [];
}

/** The certificate in one word: "converged" is within 1e-4 of a first-order point. */
function certificateFact(page: Page): readonly (readonly [string, string])[] {
  const { optimality, status } = page.figures.value;
  if (status === "nearest_confined") {
    return [
      [
        "Local minimum",
        "not sought: the nearest flat mesh of the surroundings, or within the limits",
      ],
    ];
  }
  if (!("certifiedVertices" in optimality)) return [];
  const { stationarity, outside, complementarity } = optimality;
  const far = Math.max(stationarity ?? Number.POSITIVE_INFINITY, outside ?? 0, complementarity);
  const words = Number.isFinite(far) ? `to ${far.toPrecision(1)}` : "not known";
  return [["Local minimum", `${status === "converged" ? "proven" : "not proven"}, ${words}`]];
}

/** The worst in the design of what is kept beside planarity. */
const violationFacts = (page: Page): readonly (readonly [string, string])[] =>
  Object.entries(page.figures.value.violations ?? {}).map(([kind, { after }]) => [
    `Worst, of ${kind}`,
    `${Number(after.toPrecision(2))}°`,
  ]);

function facts(page: Page): readonly (readonly [string, string])[] {
  const { iterations, objective, handleError } = page.figures.value;
  return [
    ["Degrees of freedom of the mesh", String(page.mesh.value?.report.degreesOfFreedom ?? "–")],
    ...freedomFacts(page),
    ...planarisingFact(page),
    ["Steps", String(iterations)],
    ["Objective", objective.toPrecision(5)],
    ...certificateFact(page),
    ...violationFacts(page),
    ["Furthest from a target now", formatLength(handleError, page.unit.value)],
  ];
}

/** How the last solve went, and what it leaves free. */
export function LastSolveSection() {
  const page = usePage();
  const { residuals } = page.figures.value;
  return (
    <details
      class="step folded"
      onToggle={({ currentTarget }) => {
        page.watchFreedom.value = currentTarget.open;
      }}
    >
      <summary>Last solve</summary>
      <dl class="facts">
        {facts(page).map(([name, value]) => (
          <div key={name}>
            <dt>{name}</dt>
            <dd>{value}</dd>
          </div>
        ))}
      </dl>
      <p class="quiet small">
        Degrees of freedom: in how many independent ways points could move with every panel flat.
        Objective: what the solver makes small, without a unit. Local minimum: no small change of
        the design has a lower objective; the number is what is left of the slope.
      </p>
      {residuals.length > 1 && <Curve residuals={residuals} />}
    </details>
  );
}
