// SPDX-License-Identifier: MIT
import { expect, it } from "vitest";
import { dropQueued, enqueue, holdQueue } from "../../web/src/state/action-queue.ts";
import { pageAlone } from "./support/page-here.ts";

/** What was done, in order, of `asked`: a name, with its burst after a slash. */
async function doneOf(asked: readonly string[]): Promise<string[]> {
  const page = pageAlone();
  const done: string[] = [];
  const turns = asked.map((name) => {
    const burst = name.includes("/") ? name.replace(/.*\//, "") : null;
    return enqueue(
      page,
      async () => {
        await Promise.resolve();
        done.push(name);
      },
      burst,
    );
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
  const page = pageAlone();
  const done: number[] = [];
  const first = enqueue(
    page,
    async () => {
      done.push(1);
      await itHasBegun;
    },
    "x",
  );
  const itHasBegun = Promise.resolve().then(() => Promise.resolve());
  await itHasBegun;
  await Promise.all([first, enqueue(page, async () => void done.push(2), "x")]);
  expect(done).toEqual([1, 2]);
});

it("forgets what has not begun", async () => {
  const page = pageAlone();
  const done: number[] = [];
  const turn = enqueue(page, async () => void done.push(1));
  dropQueued(page);
  await turn;
  expect(done).toEqual([]);
});

it("counts what runs or waits, but not what was dropped", async () => {
  const page = pageAlone();
  let finish = (): void => {};
  const first = enqueue(page, () => new Promise((resolve) => (finish = () => resolve(undefined))));
  const second = enqueue(page, async () => {});
  expect(page.queued.value).toBe(2);
  await Promise.resolve();
  dropQueued(page);
  expect(page.queued.value).toBe(0);
  const third = enqueue(page, async () => {});
  expect(page.queued.value).toBe(1);
  finish();
  await Promise.all([first, second, third]);
  await Promise.resolve();
  await Promise.resolve();
  expect(page.queued.value).toBe(0);
});

it("actions wait for what holds them back, which counts for none and may fail", async () => {
  const page = pageAlone();
  const done: string[] = [];
  let fail = (_reason: Error): void => {};
  holdQueue(page, new Promise((_, reject) => (fail = reject)));
  expect(page.queued.value).toBe(0);
  const turn = enqueue(page, async () => void done.push("turn"));
  await new Promise((resolve) => setTimeout(resolve));
  expect(done).toEqual([]);
  fail(new Error("the solver died"));
  await turn;
  expect(done).toEqual(["turn"]);
});
