// SPDX-License-Identifier: MIT
// A second layer at a distance from the design shown: asked of the core, in words.

import { FLAT } from "../../design/flatness.ts";
import { formatLength } from "../../quantity/units.ts";
import { refuse } from "../../result/result.ts";
import type { MeshOffset, OffsetKind } from "../../solver/protocol.ts";
import { enqueue, type Outcome } from "../../state/action-queue.ts";
import { run } from "../../state/connection.ts";
import type { Page } from "../../state/page.ts";
import type { OffsetChoice } from "../../state/page-state.ts";

/** What the page has for what the core's sentences name by its commands. */
const WAYS: readonly (readonly [RegExp, string])[] = [
  [/constraint conical/, "Make nodes conical (Advanced) makes it so."],
  [/constraint circular/, "Make panels circular (Advanced) makes it so."],
  [/kind parallel/, "Parallel edges give the nearest."],
  [/planish project/, "Planarise first."],
];

/** "panel 0 misses a circle by 19 deg; planish project …" as the page says it. */
function refusalWords(clause: string): string {
  const [what = "", way = ""] = clause.split("; ");
  const ours = WAYS.find(([pattern]) => pattern.test(way))?.[1];
  return `No second layer: ${what}.${ours ? ` ${ours}` : ""}`;
}

const AT: Readonly<Record<OffsetKind, string>> = {
  face: "Panels",
  vertex: "Points",
  parallel: "Edges are parallel; points",
};

function distanceWords(page: Page, { kind, nodes }: MeshOffset, distance: number): string {
  if (kind !== "parallel") return `at ${formatLength(distance, page.unit.value)} everywhere`;
  const [low, high] = [nodes.min, nodes.max].map((length) => formatLength(length, page.unit.value));
  return `at ${low} to ${high}`;
}

const counted = (count: number, one: string, many: string): string =>
  `${count} ${count === 1 ? one : many}`;

/** "Panels lie at 250 mm everywhere.", and what is wrong with the layer. */
export function offsetWords(page: Page, layer: MeshOffset, distance: number): string {
  const words = [`${AT[layer.kind]} lie ${distanceWords(page, layer, distance)}.`];
  if (layer.turnedEdges > 0)
    words.push(
      `${counted(layer.turnedEdges, "edge runs", "edges run")} the other way: it is too far.`,
    );
  if (layer.spoilt > 0)
    words.push(`${counted(layer.spoilt, "panel", "panels")} would be crossing, turned or concave.`);
  if (layer.excess > FLAT) words.push("It is not quite flat.");
  return words.join(" ");
}

/** Asks for the layer of the design shown, once all that was asked for before is done. */
export const layOut = (page: Page, choice: OffsetChoice): Outcome =>
  enqueue(page, async () => {
    const { distance, form } = choice;
    const answer = await run(page, "offsetting", { kind: "offset", distance, form }, "offset");
    if (!answer.ok) return answer;
    const { offset } = answer.value;
    page.offsetChoice.value = offset.problem ? null : { distance, form, of: page.mesh.peek() };
    page.offsetLayer.value = offset.problem ? null : offset;
    return offset.problem ? refuse(refusalWords(offset.problem)) : answer;
  });

export function removeOffset(page: Page): void {
  page.offsetChoice.value = null;
  page.offsetLayer.value = null;
}
