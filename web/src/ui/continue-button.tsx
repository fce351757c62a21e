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
        aria-describedby="continue-about"
        disabled={!ready.value}
        onClick={() => void continueFromShape()}
      >
        Continue from this shape
      </button>
      <p id="continue-about" class="quiet small">
        {varied
          ? "The next edit starts from the mesh that was opened and leaves this variation behind. This makes the shape the new start: handles and variations are cleared, Undo brings them back."
          : "Makes this shape the new start: handles and variations are cleared, Undo brings them back."}
      </p>
    </>
  );
}
