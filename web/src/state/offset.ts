// SPDX-License-Identifier: MIT
// A second layer at a distance from the design shown: asked of the core, in words.
import type { MeshOffset, OffsetKind } from "../solver/protocol.ts";
import { run } from "./connection.ts";
import { FLAT } from "./flatness.ts";
import { mesh, type OffsetChoice, offsetChoice, offsetLayer, problem, unit } from "./store.ts";
import { inTurn } from "./turns.ts";
import { formatLength } from "./units.ts";

/** What the page has for what the core's sentences name by its commands. */
const WAYS: readonly (readonly [RegExp, string])[] = [
  [/constraint conical/, "Make nodes conical (Advanced) makes it so."],
  [/constraint circular/, "Make panels circular (Advanced) makes it so."],
  [/kind parallel/, "Parallel edges give the nearest."],
  [/planish project/, "Planarise first."],
];

/** "panel 0 misses a circle by 19 deg; planish project …" as the page says it. */
export function refusalWords(clause: string): string {
  const [what = "", way = ""] = clause.split("; ");
  const ours = WAYS.find(([pattern]) => pattern.test(way))?.[1];
  return `No second layer: ${what}.${ours ? ` ${ours}` : ""}`;
}

const AT: Readonly<Record<OffsetKind, string>> = {
  face: "Panels",
  vertex: "Points",
  parallel: "Edges are parallel; points",
};

function distanceWords({ kind, nodes }: MeshOffset, distance: number): string {
  if (kind !== "parallel") return `at ${formatLength(distance, unit.value)} everywhere`;
  const [low, high] = [nodes.min, nodes.max].map((length) => formatLength(length, unit.value));
  return `at ${low} to ${high}`;
}

const counted = (count: number, one: string, many: string): string =>
  `${count} ${count === 1 ? one : many}`;

/** "Panels lie at 250 mm everywhere.", and what is wrong with the layer. */
export function offsetWords(layer: MeshOffset, distance: number): string {
  const words = [`${AT[layer.kind]} lie ${distanceWords(layer, distance)}.`];
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
export const layOut = (choice: OffsetChoice): Promise<void> =>
  inTurn(async () => {
    const { distance, form } = choice;
    const answer = await run("offsetting", { kind: "offset", distance, form }, "offset");
    if (!answer) return;
    const { offset } = answer;
    offsetChoice.value = offset.problem ? null : { distance, form, of: mesh.peek() };
    offsetLayer.value = offset.problem ? null : offset;
    if (offset.problem) problem.value = refusalWords(offset.problem);
  });

export function removeOffset(): void {
  offsetChoice.value = null;
  offsetLayer.value = null;
}
