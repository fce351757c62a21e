// SPDX-License-Identifier: MIT

import { commitSettings } from "../../state/editing.ts";
import { shortfalls, varied } from "../../state/shortfall.ts";
import { usePage } from "../../ui/page-context.ts";
import { stopped } from "./going-on.ts";

/** Below handles that stop a little short of their targets; where it is more, a note has all ways on. */
export function MeetTargets() {
  const page = usePage();
  const exactly = page.history.value?.present.settings.hardHandles;
  if (shortfalls(page).value.length === 0 || varied(page).value || exactly || stopped(page).value)
    return null;
  return (
    <button
      type="button"
      class="button small meet-targets"
      title="Points go all the way to what is typed or dragged, where the panels let them"
      disabled={!page.ready.value}
      onClick={() => void commitSettings(page, { hardHandles: true })}
    >
      Meet the targets exactly
    </button>
  );
}
