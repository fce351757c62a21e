// SPDX-License-Identifier: MIT
import { usePage } from "../../ui/page-context.ts";
import "./planarising.css";
import { editAsItIs, settingsAsItIs } from "../../state/tolerance.ts";

/** Instead of making a mesh flat: a tolerance, or panels that stay bent, so that no point has to move. */
export function AcceptTolerance() {
  const page = usePage();
  const settings = settingsAsItIs(page);
  if (settings === null) return null;
  const { tolerance, keepBends } = settings;
  const panels = keepBends
    ? `panels stay as bent as they are, up to ${tolerance} mm/m: none bends more`
    : `up to ${tolerance} mm/m counts as flat, then too (Advanced, Tolerance)`;
  return (
    <div class="accept-tolerance">
      <p>
        {`Or edit it as it is: points stay where they are until an edit moves them, and ${panels}.`}
      </p>
      <button
        type="button"
        class="button small"
        disabled={!page.ready.value}
        onClick={() => void editAsItIs(page, settings)}
      >
        Edit as it is
      </button>
    </div>
  );
}
