// SPDX-License-Identifier: MIT
import { lastSettling } from "../../state/settling.ts";
import { usePage } from "../../ui/page-context.ts";
import { stopped } from "./going-on.ts";
import { settledWords } from "./settled-words.ts";

/** Below the handles: whether the design is what the drag that it comes from showed last. Where it stopped
 * short, the note on that has the room. */
export function SettledNote() {
  const page = usePage();
  const last = stopped(page).value ? null : lastSettling(page).value;
  const words =
    last && last.design === page.history.value?.present && settledWords(last, page.unit.value);
  return words ? <p class="quiet small">{words}</p> : null;
}
