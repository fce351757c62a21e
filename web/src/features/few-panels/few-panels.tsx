// SPDX-License-Identifier: MIT

import { useSignal, useSignalEffect } from "@preact/signals";
import { type Design, leftBehind, toTargets } from "../../design/design.ts";
import { foldGrowth } from "../../solver/found-limits.ts";
import { healthShown } from "../../state/damage.ts";
import { formatDegrees } from "../../state/fold.ts";
import type { Page } from "../../state/page.ts";
import { usePage } from "../../ui/page-context.ts";
import { Slider } from "../../ui/slider.tsx";
import {
  type CurvePoint,
  cutAgain,
  growthOf,
  pointWords,
  priceWords,
  worthChoosing,
} from "./edit-curve.ts";
import {
  curve,
  type EditCurve,
  findCurve,
  look,
  stopSearch,
  stopWhereLeft,
  take,
} from "./few-panels-search.ts";
import "./few-panels.css";

/** What the design shown costs; "" while it is not measured. */
function presentPrice(page: Page, design: Design): string {
  const health = healthShown(page).value;
  if (!health) return "";
  return priceWords(cutAgain(health), Math.max(0, foldGrowth(design.report)));
}

/** A slider from the edit as it is to the one with fewest panels, through those worth choosing. */
function Control({ found, design }: { found: EditCurve; design: Design }) {
  const page = usePage();
  const looked = useSignal<CurvePoint | null>(null);
  const stops = worthChoosing(found.points);
  const present = found.points.find((point) => point.design === design);
  // What is on the curve and not worth choosing stands beside the next one with as few panels.
  const next = stops.findIndex(({ panels }) => panels <= (present?.panels ?? panels));
  const at = Math.max(0, present && stops.includes(present) ? stops.indexOf(present) : next);
  const price = looked.value ? pointWords(looked.value) : presentPrice(page, design);
  return (
    <>
      <Slider
        label="Few panels"
        value={at}
        min={0}
        max={Math.max(1, stops.length - 1)}
        step={1}
        shown={looked.value?.label ?? stops[at]?.label ?? "As it is"}
        spoken={price}
        disabled={!page.ready.value || stops.length < 2}
        ends={["gentle", "few panels"]}
        onInput={(value) => {
          looked.value = stops[value] ?? null;
          look(page, looked.value);
        }}
        onCommit={async (value, burst) => {
          const point = stops[value];
          if (point) await take(page, point, burst);
          looked.value = null;
        }}
      />
      <p class="quiet small effect" aria-live="polite">
        {price}
      </p>
    </>
  );
}

/** Of the longest side, so that no point lies on the edge. */
const [MARGIN, ROOM] = [6, 88];

/** Percent of the picture from the left and from below. */
function placesOf(points: readonly CurvePoint[]): (point: CurvePoint) => readonly [number, number] {
  const fold = Math.max(1, ...points.map(growthOf));
  const most = Math.max(1, ...points.map(({ panels }) => panels));
  return (point) => [
    MARGIN + (ROOM * growthOf(point)) / fold,
    MARGIN + (ROOM * point.panels) / most,
  ];
}

/** Panels cut again against the sharpest fold; each point is a design, one press away. */
function Picture({ found, design }: { found: EditCurve; design: Design }) {
  const page = usePage();
  // An edit that another betters in both figures is none to take, unless it is the one shown.
  const worth = worthChoosing(found.points);
  const points = found.points.filter((point) => worth.includes(point) || point.design === design);
  const place = placesOf(points);
  const line = [...worth]
    .sort((a, b) => growthOf(a) - growthOf(b))
    .map((point) => place(point))
    .map(([x, y]) => `${x},${100 - y}`)
    .join(" ");
  return (
    <div class="edit-curve">
      <svg viewBox="0 0 100 100" preserveAspectRatio="none" aria-hidden="true">
        <polyline points={line} />
      </svg>
      <ul aria-label="Panels cut again against the sharpest fold">
        {points.map((point) => {
          const [left, bottom] = place(point);
          return (
            <li key={point.label} style={{ left: `${left}%`, bottom: `${bottom}%` }}>
              <button
                type="button"
                class="curve-point"
                aria-label={`${point.label}: ${pointWords(point)}`}
                aria-pressed={point.design === design}
                title={`${point.label}: ${pointWords(point)}`}
                disabled={!page.ready.value}
                onClick={() => void take(page, point)}
                onPointerEnter={() => look(page, point)}
                onPointerLeave={() => look(page, null)}
                onFocus={() => look(page, point)}
                onBlur={() => look(page, null)}
              />
            </li>
          );
        })}
      </ul>
      <span class="curve-panels">{Math.max(...points.map(({ panels }) => panels))} panels</span>
      <span class="curve-folds">{`+${formatDegrees(Math.max(...points.map(growthOf)))}`}</span>
    </div>
  );
}

/** How far the search is, and what stops it. */
function Doing({ found }: { found: EditCurve }) {
  const page = usePage();
  if (found.doing === null) return null;
  return (
    <div class="beside" role="status">
      <span class="quiet small">
        {`${Math.min(found.done + 1, found.planned)} of ${found.planned}: ${found.doing}, step ${found.step}`}
      </span>
      <button type="button" class="button small" onClick={() => stopSearch(page)}>
        Stop
      </button>
    </div>
  );
}

function Problems({ found }: { found: EditCurve }) {
  return (
    <>
      {found.problems.map((sentence) => (
        <p key={sentence} class="quiet small">
          {sentence}
        </p>
      ))}
    </>
  );
}

/** Finds all edits of the curve, or the one alone that stops at so many panels. */
function Find() {
  const page = usePage();
  const typed = useSignal("");
  const most = Math.max(0, Math.round(Number(typed.value)));
  return (
    <form
      class="few-panels-find"
      onSubmit={(event) => {
        event.preventDefault();
        void findCurve(page, most);
      }}
    >
      <button
        type="submit"
        class="button small"
        title="The same edit with fewer panels to cut again, for sharper folds: computed beside what you do"
        disabled={!page.ready.value}
      >
        Find edits with fewer panels
      </button>
      <input
        type="number"
        aria-label="At most"
        placeholder="at most"
        title="How many panels may be cut again: only that edit is computed, which folds more gently"
        min={1}
        step={1}
        value={typed.value}
        onInput={({ currentTarget }) => {
          typed.value = currentTarget.value;
        }}
      />
    </form>
  );
}

/** The present edit with fewer panels made again, for sharper folds. */
export function FewPanels() {
  const page = usePage();
  useSignalEffect(() => stopWhereLeft(page));
  const [design, found] = [page.history.value?.present, curve(page).value];
  if (!design || design.shape.moved.length === 0 || leftBehind(design)) return null;
  if (toTargets(design.handles).handles.length === 0) return null;
  return (
    <section class="few-panels" aria-label="Few panels">
      {found && <Control found={found} design={design} />}
      {found && found.points.length > 1 && <Picture found={found} design={design} />}
      {found && <p class="quiet small">Panels that only get a new bevel are not counted.</p>}
      {found && <Doing found={found} />}
      {found && <Problems found={found} />}
      {!found && <p class="quiet small">{presentPrice(page, design)}</p>}
      {found?.doing == null && <Find />}
    </section>
  );
}
