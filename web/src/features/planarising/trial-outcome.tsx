// SPDX-License-Identifier: MIT
// What came of trying to make a mesh flat, and what else there is.
import { decimal } from "../../design/flatness.ts";
import type { Preview, Trial } from "../../design/planarising.ts";
import { formatLength } from "../../quantity/units.ts";
import type { OpenedMesh } from "../../solver/protocol.ts";
import type { Page } from "../../state/page.ts";
import { usePage } from "../../ui/page-context.ts";
import { isMet } from "./is-met.ts";
import { OtherWays, type OtherWaysProps } from "./other-ways.tsx";
import { sizeOf } from "./stops.ts";
import { movesFar, moveWords, TrialFigures } from "./trial-figures.tsx";

/** Of the size: from here on few would call it the same shape. */
const ANOTHER = 0.05;

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

function Shown({ trial, sameAs, ...props }: OtherWaysProps & Shown) {
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
        <div class={short ? "note" : "note warn"}>
          <p>{short ? shortWords(trial, most) : farWords(page, trial, opened)}</p>
          <OtherWays {...props} trial={short ? null : trial} />
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

export function Outcome(props: OtherWaysProps) {
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
          <OtherWays {...props} trial={null} />
        </div>
      );
    case "shown":
      return <Shown {...props} {...preview} />;
  }
}
