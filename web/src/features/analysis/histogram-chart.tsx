// SPDX-License-Identifier: MIT

import type { OpenedMesh } from "../../solver/protocol.ts";
import { movesOn, movesShown } from "../../state/moves.ts";
import type { Page } from "../../state/page.ts";
import { usePage } from "../../ui/page-context.ts";
import type { Histogram as Counts } from "./histogram.ts";
import {
  ofBending,
  ofDefects,
  ofDisplacement,
  ofFolds,
  ofMoves,
  ofPlanarity,
  ofShape,
} from "./histogram.ts";

const WIDTH = 160;

const HEIGHT = 28;

interface Shown {
  readonly counts: Counts;
  /** What is counted, for one and for several, and the word for those at rest. */
  readonly what: readonly [string, string];
  readonly rest: string;
}

/** The histogram of a motion: of a change of shape every point that moved, of a slide those that slid. */
function ofMotion(page: Page, base: OpenedMesh, kind: "shape" | "slide"): Shown {
  const moves = movesShown(page);
  const figures = Array.from(moves?.motions.values() ?? [], (motion) => motion[kind]);
  const total = base.report.vertices;
  return kind === "shape"
    ? {
        counts: ofShape(figures, moves?.endOf(kind) ?? 0, total),
        what: ["point moves", "points move"],
        rest: "untouched",
      }
    : {
        counts: ofMoves(figures, total),
        what: ["point slides", "points slide"],
        rest: "where they were",
      };
}

function shown(page: Page): Shown | null {
  const [design, base, kind] = [page.draft.value, page.mesh.value, page.colourBy.value];
  if (kind === "displacement" && design && base) {
    // Of a finished design the file's own digits are known, while it moves what the view shows.
    const steady = page.figures.value === design.report;
    const { lengths } = movesOn(page, base, design.shape);
    return {
      counts: steady
        ? ofDisplacement(base, design.shape)
        : ofMoves(lengths.values(), base.report.vertices),
      what: ["point moves", "points move"],
      rest: "untouched",
    };
  }
  if ((kind === "shape" || kind === "slide") && base) return ofMotion(page, base, kind);
  if (kind === "planarity" && page.panelFigures.value)
    return {
      counts: ofPlanarity(page.panelFigures.value),
      what: ["panel out of flat", "panels out of flat"],
      rest: "flat",
    };
  if (kind === "fold" && page.panelFolds.value)
    return {
      counts: ofFolds(page.panelFolds.value),
      what: ["panel folds", "panels fold"],
      rest: "flat with their neighbours",
    };
  if (page.kindDefects.value?.kind === kind)
    return {
      counts: ofDefects(page.kindDefects.value.values),
      what:
        kind === "circular"
          ? ["panel misses it", "panels miss it"]
          : ["node misses it", "nodes miss it"],
      rest: kind,
    };
  if (kind === "fairness" && page.bending.value)
    return {
      counts: ofBending(page.bending.value),
      what: ["point bends", "points bend"],
      rest: "smooth",
    };
  return null;
}

/** How many points or panels there are along the legend's colours. */
export function Histogram() {
  const page = usePage();
  const given = shown(page);
  if (!given) return null;
  const { bins, rest } = given.counts;
  const most = Math.max(1, ...bins);
  const width = WIDTH / bins.length;
  const counted = bins.reduce((sum, n) => sum + n, 0);
  const words = `${counted} ${given.what[counted === 1 ? 0 : 1]}, ${rest} ${given.rest}`;
  return (
    <figure class="histogram">
      {counted > 0 && (
        <svg
          viewBox={`0 0 ${WIDTH} ${HEIGHT}`}
          preserveAspectRatio="none"
          role="img"
          aria-label={`Histogram: ${words}`}
        >
          {bins.map((n, k) => {
            const height = n === 0 ? 0 : Math.max(1.5, (HEIGHT * n) / most);
            const x = k * width;
            return (
              <rect key={x} x={x + 0.5} y={HEIGHT - height} width={width - 1} height={height} />
            );
          })}
        </svg>
      )}
      <figcaption>{words}</figcaption>
    </figure>
  );
}
