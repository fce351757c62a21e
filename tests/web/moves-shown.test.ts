// SPDX-License-Identifier: MIT
import { effect } from "@preact/signals";
import { expect, it } from "vitest";
import { announceChanges } from "../../web/src/state/connection.ts";
import { movesShown } from "../../web/src/state/moves.ts";
import { openedPage } from "./support/page-here.ts";

/** A planarising that was tried out ends so: the file's points are shown again under its own figures. */
it("whoever shows how far points move is told of a change that leaves the figures as they are", async () => {
  const page = await openedPage();
  const counts: (number | undefined)[] = [];
  const stop = effect(() => {
    counts.push(movesShown(page)?.lengths.size);
  });
  const { display } = page.mesh.value ?? { display: new Float32Array() };
  const at = (c: number): number => display[3 * 40 + c] ?? 0;
  announceChanges(page, Float32Array.of(40, at(0), at(1), at(2) + 0.1));
  announceChanges(page, Float32Array.of(40, at(0), at(1), at(2)));
  expect(counts).toEqual([0, 1, 0]);
  stop();
});

it("counts how far points go from a mark on, those that come back as well as those that start", async () => {
  const page = await openedPage();
  const { display, report } = page.mesh.value ?? { display: new Float32Array(), report: null };
  const up = (vertex: number, by: number): Float32Array => {
    const [x = 0, y = 0, z = 0] = display.subarray(3 * vertex, 3 * vertex + 3);
    return Float32Array.of(vertex, x, y, z + by);
  };
  const moves = movesShown(page);
  announceChanges(page, up(40, 0.4));
  announceChanges(page, up(41, 0.1));
  moves?.mark();
  expect(moves?.farthest).toBe(0);
  announceChanges(page, up(42, 0.2));
  expect(moves?.farthest).toBeCloseTo(0.2 / (report?.scale ?? 0), 5);
  announceChanges(page, up(40, 0.3));
  announceChanges(page, up(40, 0));
  expect(moves?.farthest).toBeCloseTo(0.4 / (report?.scale ?? 0), 5);
});
