// SPDX-License-Identifier: MIT
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { countTypes, type TypeCount, typeWords } from "../../state/type-counts.ts";
import { usePage } from "../../ui/page-context.ts";

/** Of larger meshes only their colours count: the solver would have no time for anything else. */
const MOST_PANELS = 3000;
/** Milliseconds after the last change. */
const PAUSE_MS = 200;

/** How an edit changes the number of types, once they were asked for. */
export function TypesNote() {
  const page = usePage();
  const count = useSignal<TypeCount | null>(null);
  const [asked, choice] = [page.shownTypes.value !== null, page.typesChoice.value];
  const [design, opened] = [page.history.value?.present, page.mesh.value];
  const quiet = page.ready.value && !page.busy.value;
  const few = opened !== null && opened.offsets.length <= MOST_PANELS;
  useEffect(() => {
    count.value = null;
  }, [design, choice]);
  useEffect(() => {
    if (!asked || !design || design.shape.moved.length === 0 || !quiet || !few || count.peek())
      return;
    let here = true;
    const timer = setTimeout(async () => {
      const found = await countTypes(page, design.shape);
      if (here) count.value = found;
    }, PAUSE_MS);
    return () => {
      here = false;
      clearTimeout(timer);
    };
  }, [asked, design, choice, quiet, few]);
  if (!count.value) return null;
  return (
    <button
      type="button"
      class="text-button remake-note"
      title="Colour by types"
      onClick={() => {
        page.colourBy.value = "types";
      }}
    >
      {typeWords(count.value)}
    </button>
  );
}
