// SPDX-License-Identifier: MIT
// Needs: workers.
// A long day: a hundred edits, every night, undone and redone, leave nothing behind that grows.
import type { CDPSession, Page } from "playwright-core";
import { expect, it } from "vitest";
import { NIGHTLY } from "../patience.ts";
import type { Prepare } from "./support/drawing.ts";
import { holdSolvers, insideSolver } from "./support/faults.ts";
import { catchExports, Hands } from "./support/hands.ts";
import { site } from "./support/site.ts";

interface CountingWindow extends Window {
  solvers: Worker[];
  gpu: { buffers: number; textures: number };
}

/** Counts what WebGL holds, at its own door. */
const countGraphics: Prepare = async (context) => {
  await context.addInitScript(() => {
    const page = window as unknown as CountingWindow;
    page.gpu = { buffers: 0, textures: 0 };
    const gl = WebGL2RenderingContext.prototype;
    const { createBuffer, deleteBuffer, createTexture, deleteTexture } = gl;
    gl.createBuffer = function () {
      page.gpu.buffers += 1;
      return createBuffer.call(this);
    };
    gl.deleteBuffer = function (buffer) {
      if (buffer) page.gpu.buffers -= 1;
      deleteBuffer.call(this, buffer);
    };
    gl.createTexture = function () {
      page.gpu.textures += 1;
      return createTexture.call(this);
    };
    gl.deleteTexture = function (texture) {
      if (texture) page.gpu.textures -= 1;
      deleteTexture.call(this, texture);
    };
  });
};

interface Held {
  readonly heap: number;
  readonly buffers: number;
  readonly textures: number;
  /** Solvers that run, and all that were ever started. */
  readonly workers: number;
  readonly started: number;
  readonly nodes: number;
  /** Bytes of the solver's memory, which never shrinks. */
  readonly solver: number;
}

/** Lets the solver's memory be asked for. */
const SHOW_MEMORY = `const instantiate = WebAssembly.instantiate;
WebAssembly.instantiate = async (...given) => {
  const instance = await instantiate(...given);
  self.solverMemory = Object.values(instance.exports).find((x) => x instanceof WebAssembly.Memory);
  return instance;
};`;

/** The fewest nodes over two seconds, or until there are few enough: Chromium frees a replaced part of a
 * page only some collections later. */
async function fewestNodes(session: CDPSession, page: Page, enough: number): Promise<number> {
  let fewest = Number.POSITIVE_INFINITY;
  for (let round = 0; round < 20 && fewest > enough; ++round) {
    await session.send("HeapProfiler.collectGarbage");
    const { nodes } = await session.send("Memory.getDOMCounters");
    fewest = Math.min(fewest, nodes);
    await page.waitForTimeout(100);
  }
  return fewest;
}

async function held(page: Page, enoughNodes = 0): Promise<Held> {
  const session = await page.context().newCDPSession(page);
  const nodes = await fewestNodes(session, page, enoughNodes);
  const { usedSize } = await session.send("Runtime.getHeapUsage");
  const gpu = await page.evaluate(() => (window as unknown as CountingWindow).gpu);
  await session.detach();
  const [worker] = page.workers();
  const solver = (await worker?.evaluate<number>("solverMemory.buffer.byteLength")) ?? Number.NaN;
  const started = await page.evaluate(() => (window as unknown as CountingWindow).solvers.length);
  return { heap: usedSize, ...gpu, workers: page.workers().length, started, nodes, solver };
}

async function editMany(hands: Hands, count: number): Promise<void> {
  for (let k = 0; k < count; ++k) {
    await hands.fill("spinbutton", "Z", k % 2 === 0 ? "+8cm" : "+-8cm");
    if (k % 10 === 4) {
      await hands.press("Find variations");
      await hands.fill("slider", "Variation 1", k % 20 === 4 ? "0.3" : "-0.3");
    }
    if (k % 10 === 9) for (const name of ["Undo", "Undo", "Redo", "Redo"]) await hands.press(name);
  }
}

it("edits do not grow the page, the solver or the graphics", async () => {
  const viewport = { width: 600, height: 480 };
  const page = await site.open({ viewport }, "", async (context) => {
    await insideSolver(SHOW_MEMORY)(context);
    await holdSolvers(context);
    await catchExports(context);
    await countGraphics(context);
  });
  const hands = new Hands(page);
  await hands.press("Add handle");
  await editMany(hands, 10);
  const before = await held(page);
  expect(before.started).toBe(1);
  await editMany(hands, NIGHTLY ? 100 : 10);
  const after = await held(page, before.nodes + 20);
  expect(after.workers).toBe(1);
  expect(after.started).toBe(before.started);
  expect(after.solver).toBe(before.solver);
  expect(after.buffers).toBeLessThanOrEqual(before.buffers + 4);
  expect(after.textures).toBeLessThanOrEqual(before.textures + 2);
  expect(after.nodes).toBeLessThanOrEqual(before.nodes + 20);
  // The history keeps what moved in each step: some 100 points × 28 bytes, and the report.
  expect(after.heap - before.heap).toBeLessThan(4e6);
  await page.context().close();
});
