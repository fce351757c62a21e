// SPDX-License-Identifier: MIT
// What came of trying to make a mesh flat, and what else there is, each by one press.
import { decimal } from "../../design/flatness.ts";
import type { Preview, Trial } from "../../design/planarising.ts";
import { formatLength, type Unit } from "../../quantity/units.ts";
import type { OpenedMesh, Planarising } from "../../solver/protocol.ts";
import type { Page } from "../../state/page.ts";
import { usePage } from "../../ui/page-context.ts";
import { isMet } from "./is-met.ts";
import { MOST_BENT, nearWay, sizeOf } from "./stops.ts";
import { movesFar, moveWords, TrialFigures } from "./trial-figures.tsx";

/** Of all panels, percent: as few of them as are found are split. */
const SPLIT = 50;

/** Of the size: from here on few would call it the same shape. */
const ANOTHER = 0.05;

export interface OutcomeProps {
  readonly opened: OpenedMesh;
  /** What was asked for. */
  readonly wish: Planarising;
  /** Whether panels can be split, and are not yet. */
  readonly splits: boolean;
  readonly onTry: (changed: Partial<Planarising>) => void;
  /** Percent. */
  readonly onSplit: (share: number) => void;
}

type Way = readonly [label: string, act: () => void];

/** What else there is where panels stay bent or points go far.
 * @param trial what is shown, where it is flat; null: panels stay bent */
function waysOf(
  { opened, wish, splits, onTry, onSplit }: OutcomeProps,
  trial: Trial | null,
  unit: Unit,
): readonly Way[] {
  const near = nearWay(wish, opened);
  const ways: Way[] = [];
  if (wish.keepBoundary) ways.push(["Let the boundary move", () => onTry({ keepBoundary: false })]);
  if (wish.within > 0 && !trial) ways.push(["Let points move farther", () => onTry({ within: 0 })]);
  if (wish.flat < MOST_BENT && opened.report.worstMmPerM > MOST_BENT)
    ways.push([`Flat to within ${MOST_BENT} mm/m`, () => onTry({ flat: MOST_BENT })]);
  if (splits) ways.push([`Split up to ${SPLIT} % of the panels`, () => onSplit(SPLIT)]);
  if (trial && near.within < trial.mesh.report.planarising.largest) {
    const label = `Move points by ${formatLength(near.within, unit)} at most`;
    ways.push([label, () => onTry({ within: near.within, flat: near.flat })]);
  }
  return ways;
}

function Ways({ trial, ...props }: OutcomeProps & { trial: Trial | null }) {
  const ways = waysOf(props, trial, usePage().unit.value);
  if (ways.length === 0) return null;
  return (
    <fieldset class="ways-on" aria-label="What else there is">
      {ways.map(([label, act]) => (
        <button key={label} type="button" class="button small" onClick={act}>
          {label}
        </button>
      ))}
    </fieldset>
  );
}

/** Why a trial is not as flat as was asked for. */
function shortWords({ how, instead, mesh }: Trial, far: string): string {
  const bent = decimal(mesh.report.worstMmPerM);
  if (instead)
    return `Not every panel can be exactly flat near the file. This is as flat as they get where points move by ${far} at most${how.keepBoundary ? "" : ", the boundary too"}: the worst stays ${bent} mm/m out of flat.`;
  const asked = how.flat > 0 ? `flat to ${how.flat} mm/m` : "exactly flat";
  const because = how.within > 0 ? "no point may move farther, and panels keep" : "they would lose";
  return `Not every panel can be ${asked}: the worst stays ${bent} mm/m out of flat, because ${because} their shape.`;
}

function farWords(page: Page, trial: Trial, opened: OpenedMesh): string {
  const moved = `Points move by up to ${moveWords(page, trial, opened)}`;
  const { largest } = trial.mesh.report.planarising;
  return largest > ANOTHER * sizeOf(opened) ? `${moved}: it is another shape.` : `${moved}.`;
}

type Shown = Extract<Preview, { kind: "shown" }>;

function Shown({ trial, sameAs, ...props }: OutcomeProps & Shown) {
  const page = usePage();
  const { opened } = props;
  const short = page.draft.value && (trial.instead || !isMet(trial, page.draft.value));
  const far = !short && props.wish.within === 0 && movesFar(trial, opened);
  const most = formatLength(trial.how.within, page.unit.value);
  return (
    <>
      <TrialFigures trial={trial} opened={opened} />
      {sameAs && <p class="quiet small">{`The same mesh as at “${sameAs}”.`}</p>}
      {(short || far) && (
        <div class="note warn">
          <p>{short ? shortWords(trial, most) : farWords(page, trial, opened)}</p>
          <Ways {...props} trial={short ? null : trial} />
        </div>
      )}
    </>
  );
}

type Running = Extract<Preview, { kind: "running" }>;

function tryingWords(near: Trial | null, step: number): string {
  if (!near) return step > 0 ? `Trying it on the model · step ${step}` : "Trying it on the model…";
  return near.instead
    ? `Shown: as flat as panels get where points move by little${near.how.keepBoundary ? "" : ", the boundary too"}. Exactly flat is being tried · step ${step}`
    : `Shown: with the boundary free. With it kept is being tried · step ${step}`;
}

/** What is near the file is there before what was asked for. */
function Trying({ near, step, giveUp, opened }: Running & { opened: OpenedMesh }) {
  return (
    <>
      {near && <TrialFigures trial={near} opened={opened} />}
      <p class="quiet small trying">
        <span>{tryingWords(near, step)}</span>
        <button type="button" class="button small" onClick={giveUp}>
          Stop trying
        </button>
      </p>
    </>
  );
}

export function Outcome(props: OutcomeProps) {
  const preview = usePage().planariseTrial.value;
  switch (preview.kind) {
    case "none":
      return <p class="quiet small">Move the slider to see on the model what it gives.</p>;
    case "running":
      return <Trying {...preview} opened={props.opened} />;
    case "refused":
      return (
        <div class="note warn">
          <p>{preview.sentence}</p>
          <Ways {...props} trial={null} />
        </div>
      );
    case "shown":
      return <Shown {...props} {...preview} />;
  }
}
