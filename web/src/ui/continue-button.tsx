// SPDX-License-Identifier: MIT
import { continueFromShape } from "../state/continuing.ts";
import { leftBehind } from "../state/design.ts";
import { draft, figures, ready } from "../state/store.ts";

/** What a variation needs before it can be edited: an edit of its points starts from the base. */
export function ContinueButton() {
  const design = draft.value;
  if (!design || figures.value.movedVertices === 0) return null;
  const varied = leftBehind(design);
  return (
    <>
      <button
        type="button"
        class={`button wide${varied ? " primary" : ""}`}
        title="This shape becomes the mesh that edits start from; handles and variations are cleared"
        aria-describedby={varied ? "continue-about" : undefined}
        disabled={!ready.value}
        onClick={() => void continueFromShape()}
      >
        Continue from this shape
      </button>
      {varied && (
        <p id="continue-about" class="quiet small">
          The next edit starts from the mesh that was opened and leaves this variation behind. This
          keeps it, as the new start.
        </p>
      )}
    </>
  );
}
