// SPDX-License-Identifier: MIT
// Where the sliders of the family that is shown stop, as they stand now.
import { effect, signal } from "@preact/signals";
import type { Shape, SliderRange } from "../solver/protocol.ts";
import { client, held } from "./connection.ts";
import type { Variation } from "./design.ts";
import { draft, measurable } from "./store.ts";

export const sliderRanges = signal<{
  readonly centre: Shape;
  readonly ranges: readonly SliderRange[];
} | null>(null);

/** null where the solver holds another family, or cannot measure yet. */
export async function stopsAt({
  centre,
  coefficients,
}: Pick<Variation, "centre" | "coefficients">): Promise<readonly SliderRange[] | null> {
  if (held.centre !== centre) return null;
  try {
    const answer = await client.ask({ kind: "stops", coefficients });
    return answer.kind === "stops" && held.centre === centre ? answer.ranges : null;
  } catch {
    return null;
  }
}

/** Asks again as the sliders move, one question at a time. Returns how to stop. */
export function keepStops(): () => void {
  let asking = false;
  const follow = async (): Promise<void> => {
    const variation = draft.peek()?.variation;
    if (asking || !variation) return;
    asking = true;
    const ranges = await stopsAt(variation);
    asking = false;
    if (ranges) sliderRanges.value = { centre: variation.centre, ranges };
    const now = draft.peek()?.variation;
    if (now && now !== variation && ranges) void follow();
  };
  return effect(() => {
    draft.value;
    measurable.value;
    void follow();
  });
}
