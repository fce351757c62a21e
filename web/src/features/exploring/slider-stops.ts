// SPDX-License-Identifier: MIT
// Where the sliders of the family that is shown stop, as they stand now.

import { effect, signal } from "@preact/signals";
import type { Variation } from "../../design/design.ts";
import type { Shape, SliderRange } from "../../solver/protocol.ts";
import { client, held } from "../../state/connection.ts";
import { kept, type Page } from "../../state/page.ts";

export const sliderRanges = kept(() =>
  signal<{
    readonly centre: Shape;
    readonly ranges: readonly SliderRange[];
  } | null>(null),
);

/** null where the solver holds another family, or cannot measure yet. */
export async function stopsAt(
  page: Page,
  { centre, coefficients }: Pick<Variation, "centre" | "coefficients">,
): Promise<readonly SliderRange[] | null> {
  if (held(page).centre !== centre) return null;
  try {
    const answer = await client(page).ask({ kind: "stops", coefficients });
    return answer.kind === "stops" && held(page).centre === centre ? answer.ranges : null;
  } catch {
    return null;
  }
}

/** Asks again as the sliders move, one question at a time. Returns how to stop. */
export function keepStops(page: Page): () => void {
  let asking = false;
  const follow = async (): Promise<void> => {
    const variation = page.draft.peek()?.variation;
    if (asking || !variation) return;
    asking = true;
    const ranges = await stopsAt(page, variation);
    asking = false;
    if (ranges) sliderRanges(page).value = { centre: variation.centre, ranges };
    const now = page.draft.peek()?.variation;
    if (now && now !== variation && ranges) void follow();
  };
  return effect(() => {
    page.draft.value;
    void follow();
  });
}
