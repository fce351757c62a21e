// SPDX-License-Identifier: MIT

import { Fragment } from "preact";
import { flatnessWords } from "../design/flatness.ts";
import { planarisingWords } from "../design/planarising.ts";
import { formatLength } from "../quantity/units.ts";
import { foldWords } from "../state/fold.ts";
import type { Page } from "../state/page.ts";
import type { Activity } from "../state/page-state.ts";
import { cancel } from "../state/showing.ts";
import { usePage } from "./page-context.ts";
import { FigureNotes, FileNotes, StatusNotes } from "./places.ts";

function numbers(page: Page): readonly string[] {
  if (!page.ready.value) {
    const what = page.activity.value ? "design" : "solver";
    return [page.stranded.value ? "not ready" : `loading the ${what}…`];
  }
  const { movedVertices, maxDisplacement, worstGap, worstMmPerM, worstExcess, seconds, status } =
    page.figures.value;
  const parts = [
    `${movedVertices} of ${page.mesh.value?.report.vertices ?? 0} points move`,
    `largest ${formatLength(maxDisplacement, page.unit.value)}`,
    `worst panel ${flatnessWords(worstGap, worstMmPerM, worstExcess, page.unit.value).short}`,
  ];
  const fold = foldWords(page.figures.value);
  if (fold) parts.push(fold);
  if (seconds > 0) parts.push(`${Math.max(1, Math.round(1000 * seconds))} ms`);
  if (status === "infeasible_handles")
    parts.push(
      `the targets cannot be reached ${page.limited.value ? "within the limits" : "with flat panels"}`,
    );
  const report = page.mesh.value?.report;
  const planarised = report && movedVertices === 0 ? planarisingWords(report, page.unit.value) : "";
  if (planarised) parts.push(`planarised first: ${planarised}`);
  return parts;
}

/** Slides from this share of the change of shape on are worth a word. */
const NOTICEABLE = 0.5;

/** What the largest move is made of, where points slide noticeably or as far as they may: "" else. */
function motionWords(page: Page): string {
  const { bounds, motion, movedVertices } = page.figures.value;
  if (!page.ready.value || !motion || movedVertices === 0) return "";
  const { raised, lowered, slide } = motion;
  const shape = Math.max(raised, lowered);
  const held = (bounds?.slide ?? []).length > 0;
  if (!(held || slide > NOTICEABLE * shape)) return "";
  const way = raised < lowered ? "lowered" : "raised";
  const [height, along] = [shape, slide].map((one) => formatLength(one, page.unit.value));
  return `${way} ${height}, joints slide up to ${along}${held ? ", the limit" : ""}`;
}

/** How points moved, where nothing else is to be said: a sentence needs the room. */
function MotionNote() {
  const page = usePage();
  const words = motionWords(page);
  if (!words || page.problem.value || page.notice.value) return null;
  return (
    <div class="motion-note" title={words}>
      <span>{words}</span>
    </div>
  );
}

const TIME = /^\d+ ms$/;

/** Words before a figure that are heard, and seen where there is room for them. */
const SPARED = /^(?:largest |sharpest |worst panel [\d.]+ [a-z]+, (?=flat))/;

/** Breaks between figures, never within one or before a dot. */
function Numbers() {
  const page = usePage();
  const parts = numbers(page);
  return (
    <>
      {parts.map((part, k) => {
        const [spared = ""] = SPARED.exec(part) ?? [];
        const rest = part.slice(spared.length);
        const next = parts[k + 1];
        // Where there is no room for the time, the dot before it goes, too, if nothing else follows.
        const hasTime = next !== undefined && TIME.test(next) && k + 2 === parts.length;
        return (
          <Fragment key={part}>
            {k > 0 && " "}
            <span class={TIME.test(part) ? "figure time" : "figure"}>
              {spared && <span class="spared">{spared}</span>}
              {rest}
              {next !== undefined && <span class={hasTime ? "time" : ""}> ·</span>}
            </span>
          </Fragment>
        );
      })}
    </>
  );
}

const megabytes = (bytes: number): string => (bytes / 1e6).toFixed(bytes < 1e7 ? 1 : 0);

function activityWords({ label, step, read }: Activity): string {
  if (read && read.done < read.total)
    return `${label} · ${megabytes(read.done)} of ${megabytes(read.total)} MB`;
  return step > 0 ? `${label} · step ${step}` : `${label}…`;
}

export function StatusLine() {
  const page = usePage();
  const running = page.activity.value;
  return (
    <footer class="status-line">
      <div role="status" class="figures">
        <Numbers /> <FigureNotes />
      </div>
      <StatusNotes />
      <MotionNote />
      <FileNotes />
      {page.problem.value && (
        <div role="alert" class="alert">
          {page.problem.value}
        </div>
      )}
      <div class="notice" aria-live="polite">
        {page.notice.value}
      </div>
      {page.keeping.value && <div class="notice">{page.keeping.value}</div>}
      {page.update.value && (
        <div class="notice">
          A new version is ready.{" "}
          <button type="button" class="button small" onClick={page.update.value}>
            Reload
          </button>
        </div>
      )}
      <div class="activity" aria-hidden="true">
        {running && page.ready.value && activityWords(running)}
      </div>
      <button
        type="button"
        class="button small"
        disabled={!page.busy.value}
        onClick={() => cancel(page)}
      >
        Cancel
      </button>
    </footer>
  );
}
