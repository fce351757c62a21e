// SPDX-License-Identifier: MIT
import { cancel } from "../state/editing.ts";
import {
  activity,
  busy,
  figures,
  mesh,
  notice,
  problem,
  ready,
  stranded,
  unit,
  update,
} from "../state/store.ts";
import { formatGap, formatLength } from "../state/units.ts";

function numbers(): string {
  if (!ready.value) return stranded.value ? "not ready" : "loading the solver…";
  const { movedVertices, maxDisplacement, worstGap, seconds, status } = figures.value;
  const parts = [
    `${movedVertices} of ${mesh.value?.report.vertices ?? 0} points move`,
    `largest ${formatLength(maxDisplacement, unit.value)}`,
    `worst panel ${formatGap(worstGap, unit.value)}`,
  ];
  if (seconds > 0) parts.push(`${Math.max(1, Math.round(1000 * seconds))} ms`);
  if (status === "infeasible_handles") parts.push("the targets cannot be reached with flat panels");
  return parts.join(" · ");
}

export function StatusLine() {
  const running = activity.value;
  return (
    <footer class="status-line">
      <div role="status" class="figures">
        {numbers()}
      </div>
      {problem.value && (
        <div role="alert" class="alert">
          {problem.value}
        </div>
      )}
      {notice.value && <div class="notice">{notice.value}</div>}
      {update.value && (
        <button type="button" class="button small" onClick={update.value}>
          Update to the new version
        </button>
      )}
      <div class="activity" aria-hidden="true">
        {running &&
          ready.value &&
          `${running.label}${running.step > 0 ? ` · step ${running.step}` : "…"}`}
      </div>
      <button
        type="button"
        class="button small"
        disabled={!busy.value}
        onClick={() => void cancel()}
      >
        Cancel
      </button>
    </footer>
  );
}
