// SPDX-License-Identifier: MIT

import { leftBehind } from "../../design/design.ts";
import { usePage } from "../../ui/page-context.ts";
import { EXPLORING_COMMANDS } from "./exploring-commands.ts";

/** What a variation needs before it can be edited: an edit of its points starts from the base. */
export function ContinueButton() {
  const page = usePage();
  const design = page.draft.value;
  if (!design || page.figures.value.movedVertices === 0) return null;
  const varied = leftBehind(design);
  const { label, run } = EXPLORING_COMMANDS.continueFromShape;
  return (
    <>
      <button
        type="button"
        class={`button wide${varied ? " primary" : ""}`}
        title="This shape becomes the mesh that edits start from; handles and variations are cleared"
        aria-describedby={varied ? "continue-about" : undefined}
        disabled={!page.ready.value}
        onClick={() => void run(page)}
      >
        {label}
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
