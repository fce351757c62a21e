// SPDX-License-Identifier: MIT
import { commitSettings } from "../state/editing.ts";
import { history, ready } from "../state/store.ts";

/** Where a drag ended higher than the same edit at once does: offered, since the shape is another. */
export function LowerSolution() {
  const present = history.value?.present;
  if (!present?.report.lowerAtOnce || present.variation) return null;
  return (
    <button
      type="button"
      class="button small lower-solution"
      title="The same targets, solved at once, end with a lower objective, in another shape than the drag showed"
      disabled={!ready.value}
      onClick={() => void commitSettings({ continuation: 0 })}
    >
      Take the lower one
    </button>
  );
}
