// SPDX-License-Identifier: MIT
// Which panels are alike: found again, quietly, after every edit while their colours are shown.

import { effect } from "@preact/signals";
import { GROUP_COLOURS } from "../../design/groups.ts";
import { Abandoned, Died } from "../../solver/client.ts";
import { client } from "../../state/connection.ts";
import type { Page } from "../../state/page.ts";
import type { ShownTypes } from "../../state/page-state.ts";
import type { NamedPanels } from "../../ui/named-panels.tsx";

/** Milliseconds after the last change. */
const PAUSE_MS = 150;

async function findTypes(page: Page): Promise<void> {
  const of = page.history.peek()?.present;
  if (!of) return;
  const { share, mirrored } = page.typesChoice.peek();
  try {
    const answer = await client(page).stream({ kind: "types", share, mirrored, shape: null });
    if (answer.kind !== "types" || page.history.peek()?.present !== of) return;
    page.shownTypes.value = { of, share, mirrored, types: answer.types };
  } catch (error) {
    // Overtaken by a drag, whose end asks again; or the solver is starting anew.
    if (!(error instanceof Abandoned || error instanceof Died)) throw error;
  }
}

/** Returns how to stop. */
export function followTypes(page: Page): () => void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  const off = effect(() => {
    const [design, ready, choice] = [
      page.history.value?.present,
      page.ready.value && !page.busy.value,
      page.typesChoice.value,
    ];
    clearTimeout(timer);
    const known = page.shownTypes.peek();
    const same = known?.share === choice.share && known.mirrored === choice.mirrored;
    if (!design || !ready || (known?.of === design && same)) return;
    timer = setTimeout(() => void findTypes(page), PAUSE_MS);
  });
  return () => {
    clearTimeout(timer);
    off();
  };
}

/** "T-0001" for type 0. */
const typeName = (type: number): string => `T-${String(type + 1).padStart(4, "0")}`;

/** The largest types by the names of the command line, as many as there are colours; one panel has none. */
export function colouredTypes({ types }: ShownTypes): readonly NamedPanels[] {
  return GROUP_COLOURS.slice(0, types.sizes.length)
    .map((colour, type) => ({
      name: typeName(type),
      colour,
      panels: [...types.ofPanel.keys()].filter((panel) => types.ofPanel[panel] === type),
    }))
    .filter(({ panels }) => panels.length > 1);
}
