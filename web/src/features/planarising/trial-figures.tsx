// SPDX-License-Identifier: MIT
import { flatnessWords } from "../../design/flatness.ts";
import type { Trial } from "../../design/planarising.ts";
import { formatLength } from "../../quantity/units.ts";
import { stepOf } from "../../solver/found-limits.ts";
import type { OpenedMesh } from "../../solver/protocol.ts";
import { formatDegrees } from "../../state/fold.ts";
import type { Page } from "../../state/page.ts";
import { usePage } from "../../ui/page-context.ts";
import { excessesOf } from "./is-met.ts";
import { sharpestFold, spoiltWords, usualFold } from "./planarise-preview.ts";
import { isFar, sizeOf } from "./stops.ts";

/** What it is, of the file, after, and whether that is an alarm. */
type Row = readonly [name: string, file: string, after: string, alarm?: boolean];

const degrees = (fold: number | null): string => (fold === null ? "" : formatDegrees(fold));

function worstWords({ report }: OpenedMesh, page: Page): string {
  const { worstGap, worstMmPerM, worstExcess } = report;
  const { cell } = flatnessWords(worstGap, worstMmPerM, worstExcess, page.unit.value);
  return cell === "flat" ? cell : `${cell} mm/m`;
}

/** How many of them are flat; "" where nobody measured them. */
function flatWords(figures: Float32Array | null | undefined, most: number): string {
  if (!figures) return "";
  const excesses = excessesOf(figures);
  return `${excesses.filter((excess) => excess <= most).length} of ${excesses.length}`;
}

/** "410 mm, 22 % of the size" */
export function moveWords(page: Page, { mesh }: Trial, opened: OpenedMesh): string {
  const { largest } = mesh.report.planarising;
  const length = formatLength(largest, page.unit.value);
  const share = (100 * largest) / sizeOf(opened);
  return share < 0.1 ? length : `${length}, ${share.toPrecision(2)} % of the size`;
}

/** Whether points move farther than anyone expects of making panels flat. */
export const movesFar = ({ mesh }: Trial, opened: OpenedMesh): boolean =>
  isFar(mesh.report.planarising.largest, opened);

function rowsOf(page: Page, trial: Trial, opened: OpenedMesh): readonly Row[] {
  const { moved } = trial.mesh.report.planarising;
  const folds = [page.panelFolds.value, trial.measures?.folds ?? null];
  const usual = folds.map((all) => degrees(all && usualFold(all)));
  const [before = null, after = null] = folds.map((all) => all && sharpestFold(all));
  const creased = before !== null && after !== null && after > before + stepOf(0);
  const { split, how } = trial;
  const flat = Math.max(page.settings.value?.tolerance ?? 0, how.flat);
  const file = flatWords(page.panelFigures.value, flat);
  const flatRow = how.flat > 0 ? `Panels flat to ${how.flat} mm/m` : "Panels that are flat";
  return [
    ["Worst panel", worstWords(opened, page), worstWords(trial.mesh, page)],
    [flatRow, file, flatWords(trial.measures?.figures, flat)],
    ["95 % of panels fold up to", usual[0] ?? "", usual[1] ?? ""],
    ["Sharpest fold", degrees(before), degrees(after), creased],
    ["Panels it spoils", "", spoiltWords(trial)],
    ["Largest move", "", moveWords(page, trial, opened), movesFar(trial, opened)],
    ["Points that move", "", `${moved} of ${opened.report.vertices}`],
    ...(split ? [["Panels split", "", `${split.panels} of ${opened.report.faces}`] as const] : []),
  ];
}

/** The file beside what is tried out. */
export function TrialFigures({ trial, opened }: { trial: Trial; opened: OpenedMesh }) {
  const page = usePage();
  return (
    <table class="planarise-figures">
      <caption class="visually-hidden">Before and after planarising</caption>
      <thead>
        <tr>
          <td />
          <th scope="col">File</th>
          <th scope="col">After</th>
        </tr>
      </thead>
      <tbody>
        {rowsOf(page, trial, opened).map(([name, before, after, alarm]) => (
          <tr key={name}>
            <th scope="row">{name}</th>
            <td>{before}</td>
            <td class={alarm ? "alarm-figure" : ""}>{after}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}
