// SPDX-License-Identifier: MIT
// One more way on: a few panels are split. What each further line through a panel gives is shown with its
// price before one of them is taken.

import { useEffect } from "preact/hooks";
import type { Design } from "../../design/design.ts";
import { counted } from "../../quantity/counted.ts";
import { formatLength } from "../../quantity/units.ts";
import type { SplitStanding } from "../../solver/protocol.ts";
import { formatDegrees } from "../../state/fold.ts";
import { settled } from "../../state/shortfall.ts";
import { Ask } from "../../ui/ask.tsx";
import { usePage } from "../../ui/page-context.ts";
import "./split-way.css";
import {
  type Curve,
  canSplit,
  endSearch,
  type Search,
  search,
  searchNow,
  stopSearch,
  takeSplits,
} from "./split-search.ts";

const COLUMNS = ["Lines", "Short by", "Panels changed", "Sharpest fold"] as const;

function Row({ by, asked }: { by: SplitStanding; asked: Design }) {
  const page = usePage();
  const { lines } = by;
  return (
    <tr>
      <th scope="row">{lines}</th>
      <td>{formatLength(by.handleError, page.unit.value)}</td>
      <td>{by.remadePanels}</td>
      <td>{formatDegrees(by.sharpestFold)}</td>
      <td>
        {lines > 0 && (
          <button
            type="button"
            class="button small"
            aria-label={`Split by ${counted(lines, "line")}`}
            title={by.cuts.join(", ")}
            disabled={!page.ready.value || !settled(page).value}
            onClick={() => void takeSplits(page, { asked }, by)}
          >
            Split
          </button>
        )}
      </td>
    </tr>
  );
}

/** Solved at once, and not from where the drag had come, it may arrive as it is. */
function Whole({ by, asked }: { by: SplitStanding; asked: Design }) {
  const page = usePage();
  return (
    <p class="split-search">
      <span class="quiet small">
        {`Solved at once it arrives with no panel split, ${formatLength(by.handleError, page.unit.value)} short, sharpest fold ${formatDegrees(by.sharpestFold)}.`}
      </span>
      <button
        type="button"
        class="button small"
        disabled={!page.ready.value || !settled(page).value}
        onClick={() => void takeSplits(page, { asked }, by)}
      >
        Move it there
      </button>
    </p>
  );
}

const ENDS = {
  running: ", so far",
  arrived: "",
  short: "; more lines bring it no nearer",
  stopped: ", found until it was stopped",
} as const;

function CurveTable({ curve, end }: { curve: Curve; end: keyof typeof ENDS }) {
  const { asked, standings } = curve;
  return (
    <table class="split-curve">
      <caption>{`Panels split by lines between corners${ENDS[end]}`}</caption>
      <thead>
        <tr>
          {COLUMNS.map((name) => (
            <th key={name} scope="col">
              {name}
            </th>
          ))}
          <td />
        </tr>
      </thead>
      <tbody>
        {standings.map((by) => (
          <Row key={by.lines} by={by} asked={asked} />
        ))}
      </tbody>
    </table>
  );
}

function Found({ curve, end }: Extract<Search, { kind: "found" }>) {
  const { asked, standings } = curve;
  const [whole] = standings;
  if (standings.length > 1) return <CurveTable curve={curve} end={end} />;
  if (end === "arrived" && whole) return <Whole by={whole} asked={asked} />;
  const words = "None of the lines through panels that were tried lets it come nearer.";
  return <p class="quiet small">{words}</p>;
}

/** Each line of the table can be taken while it grows. */
function Running({ steps, curve }: Extract<Search, { kind: "running" }>) {
  const page = usePage();
  return (
    <>
      <p class="split-search">
        <span role="status">Trying lines through panels…</span>
        {steps > 0 && <span aria-hidden="true">{`step ${steps}`}</span>}
        <button type="button" class="button small" onClick={() => stopSearch(page)}>
          Stop trying
        </button>
      </p>
      {curve.standings.length > 0 && <CurveTable curve={curve} end="running" />}
    </>
  );
}

/** The way on by parting panels, below the others. */
export function SplitWay({ design }: { design: Design }) {
  const page = usePage();
  useEffect(() => () => endSearch(page), [page, design]);
  const found = searchNow(page);
  if (!canSplit(design)) return null;
  if (found?.kind === "running") return <Running {...found} />;
  if (found?.kind === "found") return <Found {...found} />;
  return (
    <div class="split-search">
      {found && <p class="quiet small">{found.sentence}</p>}
      <button
        type="button"
        class="button small"
        title="Looks for the few panels that let it go further once they are split in two; nothing changes yet"
        disabled={!page.ready.value || !settled(page).value}
        onClick={() => void search(page)}
      >
        Split where needed
      </button>
      <Ask about="splitWhereNeeded" />
    </div>
  );
}
