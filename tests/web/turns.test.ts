// SPDX-License-Identifier: MIT
import { expect, it } from "vitest";
import { dropTurns, inTurn } from "../../web/src/state/turns.ts";

/** What was done, in order, of `asked`: a name, with its burst after a slash. */
async function doneOf(asked: readonly string[]): Promise<string[]> {
  const done: string[] = [];
  const turns = asked.map((name) => {
    const burst = name.includes("/") ? name.replace(/.*\//, "") : null;
    return inTurn(async () => {
      await Promise.resolve();
      done.push(name);
    }, burst);
  });
  await Promise.all(turns);
  return done;
}

it("does everything in the order in which it was asked", async () => {
  expect(await doneOf(["a", "b", "c"])).toEqual(["a", "b", "c"]);
});

it("of a burst that waits does the last, and never passes another action", async () => {
  expect(await doneOf(["a/x", "b/x", "c/x"])).toEqual(["c/x"]);
  expect(await doneOf(["a/x", "undo", "b/x", "c/x", "d/y"])).toEqual(["a/x", "undo", "c/x", "d/y"]);
});

it("what has begun is not overtaken", async () => {
  const done: number[] = [];
  const first = inTurn(async () => {
    done.push(1);
    await inTurnLater;
  }, "x");
  const inTurnLater = Promise.resolve().then(() => Promise.resolve());
  await inTurnLater;
  await Promise.all([first, inTurn(async () => void done.push(2), "x")]);
  expect(done).toEqual([1, 2]);
});

it("forgets what has not begun", async () => {
  const done: number[] = [];
  const turn = inTurn(async () => void done.push(1));
  dropTurns();
  await turn;
  expect(done).toEqual([]);
});
