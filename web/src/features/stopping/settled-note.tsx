// SPDX-License-Identifier: MIT
import { formatLength } from "../../quantity/units.ts";
import { lastSettling, wentOn } from "../../state/settling.ts";
import { usePage } from "../../ui/page-context.ts";

/** What the end of a drag changed in the shape that its last frame showed; nothing where it is the same. */
export function SettledNote() {
  const page = usePage();
  const last = lastSettling(page).value;
  if (!last || last.design !== page.history.value?.present || !wentOn(last)) return null;
  const most = formatLength(last.most, page.unit.value);
  return <p class="quiet small">{`As it settled, points moved by up to ${most}.`}</p>;
}
