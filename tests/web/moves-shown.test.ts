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
