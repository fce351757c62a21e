// SPDX-License-Identifier: MIT
import { usePage } from "../../ui/page-context.ts";
import "./planarising.css";
import { acceptTolerance, meetableTolerance } from "../../state/tolerance.ts";

/** For a mesh that is nearly flat: the tolerance instead, so that no point has to move. */
export function AcceptTolerance() {
  const page = usePage();
  const tolerance = meetableTolerance(page);
  if (tolerance === null) return null;
  return (
    <div class="accept-tolerance">
      <p>
        {`Or edit it as it is: points stay where the file has them until an edit moves them, and up to ${tolerance} mm/m counts as flat, then too (Advanced, Tolerance).`}
      </p>
      <button
        type="button"
        class="button small"
        disabled={!page.ready.value}
        onClick={() => void acceptTolerance(page, tolerance)}
      >
        Edit as it is
      </button>
    </div>
  );
}
