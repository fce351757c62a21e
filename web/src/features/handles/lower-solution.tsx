// SPDX-License-Identifier: MIT

import { commitSettings } from "../../state/editing.ts";
import { usePage } from "../../ui/page-context.ts";

/** Where a drag ended higher than the same edit at once does: offered, since the shape is another. */
export function LowerSolution() {
  const page = usePage();
  const present = page.history.value?.present;
  if (!present?.report.lowerAtOnce || present.variation) return null;
  return (
    <button
      type="button"
      class="button small lower-solution"
      title="The same targets, solved at once, end with a lower objective, in another shape than the drag showed"
      disabled={!page.ready.value}
      onClick={() => void commitSettings(page, { continuation: 0 })}
    >
      Take the lower one
    </button>
  );
}
