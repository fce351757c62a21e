// SPDX-License-Identifier: MIT
// What else there is where panels stay bent or points go far: one press each, with its cost.
import { useEffect } from "preact/hooks";
import { decimal } from "../../design/flatness.ts";
import type { Trial } from "../../design/planarising.ts";
import { counted } from "../../quantity/counted.ts";
import { formatLength, type Unit } from "../../quantity/units.ts";
import type { OpenedMesh, Planarising } from "../../solver/protocol.ts";
import { usePage } from "../../ui/page-context.ts";
import { EAGER_POINTS } from "./planarise-preview.ts";
import { MOST_BENT, nearerWay } from "./stops.ts";
import { byCost, type Cost, type OtherWay, type WayCosts } from "./way-costs.ts";

/** Of all panels, percent: as few of them as are found are split. */
const SPLIT = 50;

/** The costs are tried once nothing else is about to be. */
const TRIED_AFTER_MS = 400;

export interface OtherWaysProps {
  readonly opened: OpenedMesh;
  /** What was asked for. */
  readonly wish: Planarising;
  /** Percent of the panels that may be split by now. */
  readonly share: number;
  /** Whether panels can be split, and are not yet. */
  readonly splits: boolean;
  readonly costs: WayCosts;
  readonly onTake: (way: OtherWay) => void;
}

/** Those that are soon tried come first. @param trial what is shown, where it is flat; null: panels stay bent */
export function otherWays(
  { opened, wish, share, splits }: Omit<OtherWaysProps, "costs" | "onTake">,
  trial: Trial | null,
  unit: Unit,
): readonly OtherWay[] {
  const ways: OtherWay[] = [];
  const add = (label: string, changed: Partial<Planarising>, percent = share): void =>
    void ways.push({ label, how: { ...wish, ...changed }, share: percent });
  if (wish.keepBoundary) add("Let the boundary move", { keepBoundary: false });
  if (wish.within > 0 && !trial) add("Let points move farther", { within: 0 });
  if (wish.flat < MOST_BENT && opened.report.worstMmPerM > MOST_BENT)
    add(`Flat to within ${MOST_BENT} mm/m`, { flat: MOST_BENT });
  if (trial) {
    const near = nearerWay(wish, opened, trial.mesh.report.planarising.largest);
    const label = `Move points by ${formatLength(near.within, unit)} at most`;
    add(label, { within: near.within, flat: near.flat });
  }
  if (splits) add(`Split up to ${SPLIT} % of the panels`, { flat: 0 }, SPLIT);
  return ways;
}

/** "moves up to 33 mm, 212 panels bent by up to 18.2 mm/m, 64 panels split" */
export function costWords({ move, mmPerM, bent, split }: Cost, unit: Unit): string {
  const panels = bent === null ? "panels" : counted(bent, "panel");
  return [
    `moves up to ${formatLength(move, unit)}`,
    mmPerM > 0 ? `${panels} bent by up to ${decimal(mmPerM)} mm/m` : "all flat",
    ...(split > 0 ? [`${counted(split, "panel")} split`] : []),
  ].join(", ");
}

/** Sorted once all costs are known, so that no button goes from under the pointer. */
export function OtherWays({ trial, ...props }: OtherWaysProps & { trial: Trial | null }) {
  const page = usePage();
  const { opened, costs, onTake } = props;
  const shown = page.planariseTrial.value;
  const ways = otherWays(props, trial, page.unit.value);
  useEffect(() => {
    if (opened.report.vertices > EAGER_POINTS) return;
    const timer = setTimeout(() => void costs.find(ways), TRIED_AFTER_MS);
    return () => {
      clearTimeout(timer);
      costs.end();
    };
  }, [costs, shown, JSON.stringify(ways)]);
  if (ways.length === 0) return null;
  const found = costs.now.value;
  return (
    <fieldset class="ways-on" aria-label="What else there is" aria-busy={found?.done === false}>
      {(found?.done ? byCost(ways, found.known) : ways).map((way) => {
        const cost = found?.known.get(way.label);
        return (
          <span key={way.label} class="way-on other-way">
            <button type="button" class="button small" onClick={() => onTake(way)}>
              {way.label}
            </button>
            {cost && <span class="quiet small">{costWords(cost, page.unit.value)}</span>}
          </span>
        );
      })}
    </fieldset>
  );
}
