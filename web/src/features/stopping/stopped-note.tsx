// SPDX-License-Identifier: MIT

import { useEffect } from "preact/hooks";
import type { Design } from "../../design/design.ts";
import { counted } from "../../quantity/counted.ts";
import { formatGap } from "../../quantity/units.ts";
import { commitSettings } from "../../state/editing.ts";
import { settled, shortfalls, varied } from "../../state/shortfall.ts";
import { usePage } from "../../ui/page-context.ts";
import { PanelButton } from "../../ui/panel-button.tsx";
import { catchUp, isCatchingUp } from "./catching-up.ts";
import { goOn, type Stopped, stopped } from "./going-on.ts";
import { SplitWay } from "./split-way.tsx";
import { endTries, gainsNow, tryWays } from "./way-gains.ts";
import {
  byGain,
  gainWords,
  gotWords,
  type Reason,
  reasonWords,
  type Sought,
  sharedWords,
  waysOn,
} from "./way-on.ts";

/** Ways listed at most: more would not help to decide what to change. */
const MOST = 4;

/** The panels that hold the targets back, each to be looked at. */
function HoldingPanels() {
  const page = usePage();
  const report = page.freedom.value;
  if (!report || report.holding.length === 0) return null;
  const { holding, borne } = report;
  return (
    <p>
      {`${holding.length === 1 ? "One panel bears" : "These panels bear"} ${Math.round(100 * borne)} % of the pull, the first most: `}
      {holding.slice(0, MOST).map((panel) => (
        <PanelButton key={panel} panel={panel} />
      ))}
      {holding.length > MOST && `and ${holding.length - MOST} more`}
    </p>
  );
}

/** Mean edges: of less a figure in millimetres is all zeros. */
const WORTH_SAYING = 1e-6;

/** What lets the handle go as far as it does. */
const allowing = (reason: Reason, sought: Sought): string => {
  if (sought === "dragged") return "Held back at";
  if (reason === "unknown") return "It stops at";
  return `${reason === "keep-outs" ? "Keep-outs" : reason === "slides" ? "Slides" : "Panels"} allow`;
};

/** The figures are tried once nothing else is about to be. */
const TRIED_AFTER_MS = 400;

/** Sorted by what they gain once all of it is known, so that no button goes from under the pointer. */
function WaysOn({ design, found }: { design: Design; found: Stopped }) {
  const page = usePage();
  const { stop, reason, growth, sought } = found;
  const quiet = page.ready.value && settled(page).value;
  const catching = isCatchingUp(page);
  const ways = waysOn(design, reason, growth, sought);
  useEffect(() => {
    if (!quiet || catching) return;
    const begin = () => void (isCatchingUp(page) || tryWays(page, ways));
    const timer = setTimeout(begin, TRIED_AFTER_MS);
    return () => clearTimeout(timer);
  }, [page, found, quiet, catching]);
  useEffect(() => () => endTries(page), [page, found]);
  const gains = gainsNow(page);
  return (
    <fieldset class="ways-on" aria-label="Get further" aria-busy={gains?.done === false}>
      {(gains?.done ? byGain(ways, gains.known, stop) : ways).map((way) => {
        const gain = gains?.known.get(way.label);
        return (
          <span key={way.label} class="way-on">
            <button
              type="button"
              class="button small"
              title={way.title}
              disabled={!quiet}
              onClick={() => void goOn(page, way)}
            >
              {way.label}
            </button>
            {gain && (
              <span class="quiet small" title="How far it gets, and the sharpest fold there">
                {gainWords(gain, stop, page.unit.value)}
              </span>
            )}
            {gain && gain.spoilt > 0 && (
              <strong class="way-damage small" title={gain.damage}>
                {`spoils ${counted(gain.spoilt, "panel")}`}
              </strong>
            )}
          </span>
        );
      })}
    </fieldset>
  );
}

/** Where a point stops on its way to its target, why, and one press for each way on. */
export function StoppedNote() {
  const page = usePage();
  const [design, found] = [page.history.value?.present, stopped(page).value];
  const idle = page.ready.value && !page.busy.value;
  useEffect(() => {
    if (idle) void catchUp(page);
  }, [page, found, idle]);
  if (!design || !found) return null;
  const { stop, reason, growth, sought } = found;
  const { unit } = page;
  const gains = gainsNow(page);
  // Said as the ways are sorted, so that no button goes from under the pointer twice.
  const shared = gains?.done ? sharedWords(gains.known, stop, unit.value) : "";
  const { status, residuals } = design.report;
  const left = residuals.at(-1);
  const meanEdge = page.mesh.value?.report.meanEdge ?? 0;
  return (
    <section class="note" aria-label="Why the target is not reached">
      <p>
        <strong>{`${allowing(reason, sought)} ${gotWords(stop, unit.value)} here${shared}.`}</strong>{" "}
        {reasonWords(reason, growth, sought)}
      </p>
      {reason === "panels" && <HoldingPanels />}
      {status === "infeasible_handles" && left !== undefined && left > WORTH_SAYING && (
        <p class="quiet">{`The last attempt left the panels up to ${formatGap(left * meanEdge, unit.value)} out of flat.`}</p>
      )}
      <WaysOn design={design} found={found} />
      <SplitWay design={design} />
    </section>
  );
}

/** The way on below handles that stop a little short of their targets; where it is more, a note has all. */
export function MeetTargets() {
  const page = usePage();
  const exactly = page.history.value?.present.settings.hardHandles;
  if (shortfalls(page).value.length === 0 || varied(page).value || exactly || stopped(page).value)
    return null;
  return (
    <button
      type="button"
      class="button small meet-targets"
      title="Points go all the way to what is typed or dragged, where the panels let them"
      disabled={!page.ready.value}
      onClick={() => void commitSettings(page, { hardHandles: true })}
    >
      Meet the targets exactly
    </button>
  );
}
