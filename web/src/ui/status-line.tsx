// SPDX-License-Identifier: MIT
import { Fragment } from "preact";
import { flatnessWords } from "../state/flatness.ts";
import { foldWords } from "../state/fold.ts";
import { planarisingWords } from "../state/planarising.ts";
import { cancel } from "../state/showing.ts";
import {
  type Activity,
  activity,
  busy,
  context,
  figures,
  keeping,
  limited,
  mesh,
  notice,
  problem,
  ready,
  stranded,
  unit,
  update,
} from "../state/store.ts";
import { formatLength } from "../state/units.ts";
import { later } from "./later.tsx";

const ContextNote = later(() => import("./context-note.tsx").then((part) => part.ContextNote));
const DamageNote = later(() => import("./damage-note.tsx").then((part) => part.DamageNote));
const RemakeNote = later(() => import("./remake-note.tsx").then((part) => part.RemakeNote));

function numbers(): readonly string[] {
  if (!ready.value) return [stranded.value ? "not ready" : "loading the solver…"];
  const { movedVertices, maxDisplacement, worstGap, worstMmPerM, worstExcess, seconds, status } =
    figures.value;
  const parts = [
    `${movedVertices} of ${mesh.value?.report.vertices ?? 0} points move`,
    `largest ${formatLength(maxDisplacement, unit.value)}`,
    `worst panel ${flatnessWords(worstGap, worstMmPerM, worstExcess, unit.value).short}`,
  ];
  const fold = foldWords(figures.value);
  if (fold) parts.push(fold);
  if (seconds > 0) parts.push(`${Math.max(1, Math.round(1000 * seconds))} ms`);
  if (status === "infeasible_handles")
    parts.push(
      `the targets cannot be reached ${limited.value ? "within the limits" : "with flat panels"}`,
    );
  const report = mesh.value?.report;
  const planarised = report && movedVertices === 0 ? planarisingWords(report, unit.value) : "";
  if (planarised) parts.push(`planarised first: ${planarised}`);
  return parts;
}

/** Breaks between figures, never within one or before a dot. */
function Numbers() {
  const parts = numbers();
  return (
    <>
      {parts.map((part, k) => (
        <Fragment key={part}>
          {k > 0 && " "}
          <span class="figure">{k + 1 < parts.length ? `${part} ·` : part}</span>
        </Fragment>
      ))}
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
  const running = activity.value;
  return (
    <footer class="status-line">
      <div role="status" class="figures">
        <Numbers /> <DamageNote />
      </div>
      <RemakeNote />
      {context.value && <ContextNote />}
      {problem.value && (
        <div role="alert" class="alert">
          {problem.value}
        </div>
      )}
      {notice.value && <div class="notice">{notice.value}</div>}
      {keeping.value && <div class="notice">{keeping.value}</div>}
      {update.value && (
        <div class="notice">
          A new version is ready.{" "}
          <button type="button" class="button small" onClick={update.value}>
            Reload
          </button>
        </div>
      )}
      <div class="activity" aria-hidden="true">
        {running && ready.value && activityWords(running)}
      </div>
      <button type="button" class="button small" disabled={!busy.value} onClick={cancel}>
        Cancel
      </button>
    </footer>
  );
}
