// SPDX-License-Identifier: MIT
// How an opened mesh becomes flat, shown on the model before it is done: close to what was opened, or
// fair.

import { signal } from "@preact/signals";
import { kept, type Page } from "../../state/page.ts";
import { Check } from "../../ui/check.tsx";
import { usePage } from "../../ui/page-context.ts";
import "./planarising.css";
import { useEffect, useMemo } from "preact/hooks";
import type { Preview } from "../../design/planarising.ts";
import { unitWord } from "../../quantity/units.ts";
import type { OpenedMesh, Planarising } from "../../solver/protocol.ts";
import { Choice } from "../../ui/choice.tsx";
import { LimitField } from "../../ui/limit-field.tsx";
import { Slider } from "../../ui/slider.tsx";
import { viewOf } from "../../ui/view-slot.ts";
import { isMet } from "./is-met.ts";
import { NetNote } from "./net-parts.tsx";
import { EAGER_POINTS, PlanarisePreview } from "./planarise-preview.ts";
import { followSplitLines } from "./split-lines.ts";
import { MOST_BENT, STOPS, splitMost, stopOf } from "./stops.ts";
import { Outcome } from "./trial-outcome.tsx";

/** mm/m that panels may stay out of flat. */
const FLATNESSES = [0, 1, 5, MOST_BENT] as const;

/** Of all panels, that may be split where no flat mesh is near; percent. */
const SPLITS = [0, 5, 10, 25, 50] as const;

const SPLIT_CHOICES = SPLITS.map(
  (share) => [String(share), share > 0 ? `at most ${share} %` : "none"] as const,
);

const splitShare = kept(() => signal(0));

const FLATNESS_CHOICES = FLATNESSES.map(
  (flat) => [String(flat), flat > 0 ? `to within ${flat} mm/m` : "exactly"] as const,
);

/** A panel of boundary points alone cannot become flat while they stay. */
function canKeepBoundary({ offsets, vertices, topology }: OpenedMesh): boolean {
  for (let f = 0; f + 1 < offsets.length; ++f) {
    const corners = vertices.subarray(offsets[f], offsets[f + 1]);
    if (corners.length > 3 && corners.every((v) => topology.boundary[v] === 1)) return false;
  }
  return true;
}

/** Where panels stay bent: not beside cuts, which are of a flat mesh. */
function mayHelpToSplit(page: Page): boolean {
  const [preview, design] = [page.planariseTrial.value, page.draft.value];
  if (!design || design.settings.cuts.length > 0) return false;
  if (preview.kind !== "shown") return preview.kind === "refused";
  const { trial } = preview;
  return trial.instead || !isMet(trial, design);
}

/** Where it may help, or some are split already. */
function SplitPanels({ onChoose }: { onChoose: () => void }) {
  const page = usePage();
  const share = splitShare(page);
  if (share.value === 0 && !mayHelpToSplit(page)) return null;
  return (
    <>
      <Choice
        label="Split panels"
        value={String(share.value)}
        words={SPLIT_CHOICES}
        onChoose={(chosen) => {
          share.value = Number(chosen);
          onChoose();
        }}
      />
      <p class="quiet small">
        By lines between corners, as few as are found; points move less where more may be split.
      </p>
    </>
  );
}

function hold(page: Page, on: boolean): void {
  page.showBefore.value = on;
}

function HoldFile() {
  const page = usePage();
  return (
    <button
      type="button"
      class="button small"
      aria-pressed={page.showBefore.value}
      title="Hold to see the file as it is (B)"
      onPointerDown={() => hold(page, true)}
      onPointerUp={() => hold(page, false)}
      onPointerLeave={() => hold(page, false)}
      onKeyDown={(event) => event.key === " " && hold(page, true)}
      onKeyUp={() => hold(page, false)}
      onBlur={() => hold(page, false)}
    >
      Before: the file
    </button>
  );
}

/** Whether the model shows what is tried out. */
const isDrawn = (preview: Preview): boolean =>
  preview.kind === "shown" || (preview.kind === "running" && preview.near !== null);

/** @param live whether it begins by itself */
export function PlanariseStep({ live }: { live: boolean }) {
  const page = usePage();
  const [opened, design] = [page.mesh.value, page.draft.value];
  const preview = useMemo(
    () => (opened && design ? new PlanarisePreview(page, opened, design) : null),
    [opened, design],
  );
  const wanted = (): Planarising => {
    const { keepShape = true, constraints = [] } = page.settings.peek() ?? {};
    return { ...page.planarising.peek(), keepShape, constraints };
  };
  const share = splitShare(page);
  const most = (): number => (opened ? splitMost(share.peek(), opened) : 0);
  const show = (): void => void preview?.show(most(), wanted());
  const keep = (keepBoundary: boolean): void => {
    page.planarising.value = { ...page.planarising.peek(), keepBoundary };
  };
  const change = (changed: Partial<Planarising>): void => {
    page.planarising.value = { ...page.planarising.peek(), ...changed };
    show();
  };
  /** With the boundary where it is, unless that leaves panels bent. */
  const begin = async (): Promise<void> => {
    const first = wanted();
    const ways = first.keepBoundary ? [first, { ...first, keepBoundary: false }] : [first];
    const trial = await preview?.show(most(), ...ways);
    if (trial) keep(trial.how.keepBoundary);
  };
  useEffect(() => {
    if (!opened || !preview) return;
    share.value = 0;
    if (live) {
      const keepBoundary = canKeepBoundary(opened);
      page.planarising.value = { ...page.planarising.peek(), keepBoundary, within: 0, flat: 0 };
    }
    if (live && opened.report.vertices <= EAGER_POINTS) void begin();
    const view = viewOf(page);
    const stop = view && followSplitLines(page, view, opened);
    return () => {
      stop?.();
      preview.end();
    };
  }, [opened, preview, live]);
  if (!opened || !preview) return null;
  const { smooth, keepBoundary, within, flat } = page.planarising.value;
  const stop = stopOf(smooth);
  const name = STOPS[stop]?.name ?? "";
  const choose = (place: number): void => {
    const chosen = STOPS[place]?.smooth ?? 0;
    if (chosen === page.planarising.peek().smooth && page.planariseTrial.peek().kind !== "none")
      return;
    change({ smooth: chosen });
  };
  return (
    <>
      <NetNote />
      <Slider
        label="Aim for"
        value={stop}
        min={0}
        max={STOPS.length - 1}
        step={1}
        shown={name}
        spoken={name}
        disabled={!page.ready.value}
        ends={["close to the file", "fair folds"]}
        onInput={choose}
        onCommit={choose}
      />
      <Check
        label="Keep the boundary where it is"
        checked={keepBoundary}
        onChange={(on) => change({ keepBoundary: on })}
      />
      <div class="planarise-bounds">
        <Choice
          label="Flat"
          value={String(flat)}
          words={FLATNESS_CHOICES}
          onChoose={(chosen) => change({ flat: Number(chosen) })}
        />
        <div class="field">
          <span aria-hidden="true">{`Largest move (${page.unit.value})`}</span>
          <LimitField
            label="Largest move"
            about={`${unitWord(page.unit.value)}, or any: no point moves farther`}
            zero="any"
            value={within}
            unit={page.unit.value}
            invalid={within < 0}
            onApply={(length) => change({ within: Math.max(0, length) })}
          />
        </div>
      </div>
      <Outcome
        opened={opened}
        wish={wanted()}
        share={share.value}
        splits={share.value === 0 && mayHelpToSplit(page)}
        costs={preview.costs}
        onTake={(way) => {
          share.value = way.share;
          change(way.how);
        }}
      />
      <SplitPanels onChoose={show} />
      {isDrawn(page.planariseTrial.value) && <HoldFile />}
    </>
  );
}
