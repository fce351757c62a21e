// SPDX-License-Identifier: MIT
// Needs: workers.
// What a drag on five thousand points costs: processor time of the page's own thread, not the
// clock, which on a busy machine says more about the machine. What the clock says is printed.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { NIGHTLY } from "../patience.ts";
import type { Prepare } from "./support/drawing.ts";
import { exportAs, idle, movedCount, openFile, status, still, typeTarget } from "./support/page.ts";
import { site } from "./support/site.ts";

/** Points along one side. */
const SIDE = 71;

/** Updates that the share of one is taken over: how long they take is the machine's affair. */
const UPDATES = NIGHTLY ? 30 : 10;

/** Moves of the pointer, at least. */
const MOVES = NIGHTLY ? 120 : 30;

/** A doubly curved roof of parallelograms: every panel is flat. */
function curvedRoof(): string {
  const lines: string[] = [];
  const height = (t: number): number => 0.12 * SIDE * Math.sin((Math.PI * t) / (SIDE - 1));
  for (let j = 0; j < SIDE; ++j)
    for (let i = 0; i < SIDE; ++i) lines.push(`v ${i} ${j} ${height(i) + height(j)}`);
  for (let j = 0; j + 1 < SIDE; ++j) {
    for (let i = 0; i + 1 < SIDE; ++i) {
      const a = j * SIDE + i + 1;
      lines.push(`f ${a} ${a + 1} ${a + SIDE + 1} ${a + SIDE}`);
    }
  }
  return `${lines.join("\n")}\n`;
}

interface PacedWindow extends Window {
  answers: number;
  longTasks: number[];
}

/** Counts the solver's answers and the page's long tasks, at the browser's own doors. */
const countAnswers: Prepare = async (context) => {
  await context.addInitScript(() => {
    const page = window as unknown as PacedWindow & { Worker: typeof Worker };
    page.answers = 0;
    page.longTasks = [];
    page.Worker = class extends Worker {
      constructor(...given: ConstructorParameters<typeof Worker>) {
        super(...given);
        this.addEventListener("message", ({ data }: MessageEvent<{ kind: string }>) => {
          if (data.kind === "shown") page.answers += 1;
        });
      }
    };
    new PerformanceObserver((list) => {
      for (const { duration } of list.getEntries()) page.longTasks.push(duration);
    }).observe({ type: "longtask" });
  });
};

/** Seconds of processor time that scripts have taken in the page's thread. */
async function scriptSeconds(page: Page): Promise<() => Promise<number>> {
  const session = await page.context().newCDPSession(page);
  await session.send("Performance.enable", { timeDomain: "threadTicks" });
  return async () => {
    const { metrics } = await session.send("Performance.getMetrics");
    return metrics.find(({ name }) => name === "ScriptDuration")?.value ?? Number.NaN;
  };
}

it("a drag on 5041 points: every frame's script stays far below a long task", async () => {
  const viewport = { width: 480, height: 360 };
  const page = await site.open(
    { draws: true, viewport, reducedMotion: "reduce" },
    "",
    countAnswers,
  );
  await openFile(page, "roof.obj", curvedRoof());
  await page.getByRole("button", { name: "Start editing" }).click();
  await still(page);
  const spent = await scriptSeconds(page);
  const box = await page.getByLabel("3D view").boundingBox();
  if (!box) throw new Error("no 3D view");
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  // As a hand does: a frame that finds no way in its time is followed by the next.
  let moves = 0;
  const nudged = async (): Promise<number> => {
    await page.mouse.move(x, y - 4 - (moves++ % 4));
    return movedCount(page);
  };
  await expect.poll(nudged).toBeGreaterThan(0);
  const before = await page.evaluate(() => {
    const window_ = window as unknown as PacedWindow;
    window_.longTasks = [];
    return window_.answers;
  });
  const [begun, scriptBefore] = [Date.now(), await spent()];
  const answered = () => page.evaluate(() => (window as unknown as PacedWindow).answers);
  for (let k = 0; k < MOVES || (await answered()) - before <= UPDATES; ++k) {
    await page.mouse.move(x + 12 * Math.sin(k / 9), y - 6 - 12 * Math.sin(k / 19) ** 2);
    await page.waitForTimeout(8);
  }
  const seconds = (Date.now() - begun) / 1000;
  const script = (await spent()) - scriptBefore;
  const { answers, longTasks } = await page.evaluate(() => {
    const { answers, longTasks } = window as unknown as PacedWindow;
    return { answers, longTasks };
  });
  await page.mouse.up();
  const updates = answers - before;
  const perUpdate = (1000 * script) / updates;
  console.info(
    `drag on ${SIDE * SIDE} points: ${(updates / seconds).toFixed(0)} updates a second by the clock, ` +
      `${perUpdate.toFixed(1)} ms of script each, ${longTasks.length} long tasks` +
      (longTasks.length > 0 ? ` (longest ${Math.max(...longTasks).toFixed(0)} ms)` : ""),
  );
  expect(perUpdate).toBeLessThan(50);
  await page.context().close();
});

/** Seconds in which Cancel is done, on a machine of its own. */
const AT_ONCE = 0.2;

/** Presses Cancel once it can be, and gives the milliseconds until the status reads `numbers`. */
const cancelAndWait = (page: Page, numbers: string): Promise<number> =>
  page.evaluate(async (expected) => {
    const button = [...document.querySelectorAll("button")].find((b) => b.textContent === "Cancel");
    const frame = () => new Promise((done) => requestAnimationFrame(done));
    while (button?.disabled) await frame();
    await new Promise((done) => setTimeout(done, 100));
    if (button?.disabled) throw new Error("The solve was over before it could be cancelled.");
    const begun = performance.now();
    button?.click();
    while (document.querySelector("[role=status]")?.textContent !== expected) await frame();
    return performance.now() - begun;
  }, numbers);

it("Cancel during a long solve gives back the last design at once, to the last bit", async () => {
  const page = await site.open({ viewport: { width: 480, height: 360 }, reducedMotion: "reduce" });
  await openFile(page, "roof.obj", curvedRoof());
  await page.getByRole("button", { name: "Start editing" }).click();
  await typeTarget(page, "+2");
  const numbers = await status(page);
  const before = await exportAs(page, "OBJ");
  await page.getByText("Advanced", { exact: true }).click();
  const [solver] = page.workers();
  expect(solver).toBeDefined();
  const spent = await scriptSeconds(page);
  await page.getByRole("combobox", { name: "Engine" }).selectOption("alm");
  const begun = await spent();
  const milliseconds = await cancelAndWait(page, numbers);
  const script = (await spent()) - begun;
  console.info(
    `cancelled after ${milliseconds.toFixed(0)} ms by the clock, ${(1000 * script).toFixed(0)} ms of script`,
  );
  expect(script).toBeLessThan(AT_ONCE);
  // The worker that solves is replaced, not waited for.
  await expect.poll(() => page.workers().some((one) => one === solver)).toBe(false);
  await idle(page);
  expect(await page.getByRole("alert").count()).toBe(0);
  expect(await status(page)).toBe(numbers);
  expect(await exportAs(page, "OBJ")).toEqual(before);
  expect(await page.getByRole("combobox", { name: "Engine" }).inputValue()).toBe("newton");
  await page.context().close();
});
