// SPDX-License-Identifier: MIT
import { counted } from "../../quantity/counted.ts";
import { usePage } from "../../ui/page-context.ts";
import "./mobility-scale.css";
import { effect } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { formatLength } from "../../quantity/units.ts";
import { FLAT_FIRST } from "../../state/dragging.ts";
import { formatDegrees } from "../../state/fold.ts";
import { largest } from "../../state/ramp-ends.ts";
import {
  isOutdated,
  type MobilityRow,
  measureMobility,
  openPlace,
  stopMobility,
} from "./mobility.ts";

/** Measures while someone looks, whichever mesh is open. */
function useMeasuring(): void {
  const page = usePage();
  useEffect(() => {
    const off = effect(() => {
      const opened = page.mesh.value;
      if (page.ready.value && page.baseFlat.value && page.mobility.peek()?.of !== opened)
        measureMobility(page);
    });
    if (page.mobility.peek()?.of === page.mesh.peek()) measureMobility(page);
    return () => {
      off();
      stopMobility(page);
    };
  }, []);
}

function Place({ row }: { row: MobilityRow }) {
  const page = usePage();
  const way = `${row.direction[2] > 0 ? "up" : "down"} ${formatLength(row.distance, page.unit.value)}`;
  const cost = `${counted(row.remake, "panel")} again, folds up to ${formatDegrees(row.sharpestFold)}`;
  return (
    <li>
      <button type="button" title="Open as an edit" onClick={() => void openPlace(page, row)}>
        {`Point ${row.vertex} ${way}`}
        <span>{cost}</span>
      </button>
    </li>
  );
}

/** How far it is, and what stops it or goes on. */
function Progress() {
  const page = usePage();
  const map = page.mobility.value;
  if (!map) return null;
  const points = map.ways.length;
  const done = map.measured === points;
  if (map.problem) return <p class="legend-note">{map.problem}</p>;
  return (
    <div class="mobility-progress">
      <span>
        {done ? `${points} points measured` : `${map.measured} of ${points} points measured`}
      </span>
      {map.running && (
        <button type="button" class="button small" onClick={() => stopMobility(page)}>
          Stop
        </button>
      )}
      {!map.running && (!done || isOutdated(page, map)) && (
        <button type="button" class="button small" onClick={() => measureMobility(page)}>
          {isOutdated(page, map) ? "Measure again" : "Go on"}
        </button>
      )}
    </div>
  );
}

/** How far points get up and down, and where the shape can change most. */
export function MobilityScale() {
  const page = usePage();
  useMeasuring();
  const map = page.mobility.value?.of === page.mesh.value ? page.mobility.value : null;
  if (!page.baseFlat.value) return <p class="legend-note">{FLAT_FIRST}</p>;
  return (
    <>
      <div class="legend-ends">
        <span>stays</span>
        <span>{formatLength(map ? largest(map.ways) : 0, page.unit.value)}</span>
      </div>
      <p class="legend-note">
        How far a point moves up and down before a panel stops it: mean, from the base
      </p>
      <Progress />
      {map && map.best.length > 0 && (
        <>
          <p class="places-head" id="best-places">
            Best places to change the shape
          </p>
          <ol class="places" aria-labelledby="best-places">
            {map.best.map((row) => (
              <Place key={row.vertex} row={row} />
            ))}
          </ol>
        </>
      )}
    </>
  );
}
