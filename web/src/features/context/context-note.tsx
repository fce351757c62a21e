// SPDX-License-Identifier: MIT
import { counted } from "../../quantity/counted.ts";
import { goToRule } from "../../state/inspector.ts";
import { fetchPart } from "../../state/later.ts";
import { usePage } from "../../ui/page-context.ts";

/** How many objects of a file lie beside its panels, the way to hide them, and to keep out of them. */
export function ContextNote() {
  const page = usePage();
  if (!page.context.value) return null;
  const { count, triangles } = page.context.value;
  const hidden = page.contextHidden.value;
  const objects = counted(count, "other object");
  const keepOut = async (): Promise<void> => {
    const part = await fetchPart(page, () => import("../keep-outs/keep-outs.ts"));
    await part?.addContext(page);
    goToRule(page, "keepOuts");
  };
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
      {triangles && triangles.length > 0 && (
        <>
          {" "}
          <button
            type="button"
            class="text-button"
            title="No panel goes through their surfaces; listed under Keep-outs"
            disabled={!page.ready.value}
            onClick={() => void keepOut()}
          >
            Keep out
          </button>
        </>
      )}
    </div>
  );
}
