// SPDX-License-Identifier: MIT
import "./accept-tolerance.css";
import { ready } from "../state/store.ts";
import { acceptTolerance, meetableTolerance } from "../state/tolerance.ts";

/** For a mesh that is nearly flat: the tolerance instead, so that no point has to move. */
export function AcceptTolerance() {
  const tolerance = meetableTolerance();
  if (tolerance === null) return null;
  return (
    <div class="accept-tolerance">
      <p>
        {`Or count up to ${tolerance} mm/m as flat: points stay as they are (Advanced, Tolerance).`}
      </p>
      <button
        type="button"
        class="button small"
        disabled={!ready.value}
        onClick={() => void acceptTolerance(tolerance)}
      >
        Accept {tolerance} mm/m
      </button>
    </div>
  );
}
