// SPDX-License-Identifier: MIT
import { usePage } from "./page-context.ts";
/** How many objects of a file lie beside its panels, and the way to hide them. */
export function ContextNote() {
  const page = usePage();
  const count = page.context.value?.count ?? 0;
  const hidden = page.contextHidden.value;
  const objects = `${count} other ${count === 1 ? "object" : "objects"}`;
  return (
    <div class="notice">
      {`${objects} ${hidden ? "hidden" : "shown as context"}`}{" "}
      <button
        type="button"
        class="text-button"
        onClick={() => {
          page.contextHidden.value = !hidden;
        }}
      >
        {hidden ? "Show" : "Hide"}
      </button>
    </div>
  );
}
