// SPDX-License-Identifier: MIT
// Needs: network.
// How much a first visit has to load before it can drag: as bytes after gzip, which every static
// server can send. What is kept for later (offline, GLB) does not count.
import { gzipSync } from "node:zlib";
import type { Response } from "playwright-core";
import { expect, it } from "vitest";
import { movedCount } from "./support/page.ts";
import { site } from "./support/site.ts";
import { hintedPoint, press } from "./support/view.ts";

/** What "ready in 1.5 s at 10 Mbit/s, and soon to the first drag" leaves room for. */
const LIMIT = 1_000_000;

/** Parts that come by themselves later; a drag must not wait for any of them. */
const LATER = /(controls|(saved|stored)-[a-z]+|offered|occlusion|glass)-/;

it("is at most 1 MB for everything that a drag needs", async () => {
  const sizes: (readonly [string, Promise<number>])[] = [];
  const packed = async (answer: Response): Promise<number> =>
    gzipSync(await answer.body(), { level: 9 }).length;
  const page = await site.open({ holdsBack: true }, "", async (context) => {
    // Held back for ever, so that the drag below shows that it does without.
    await context.route(LATER, () => {});
    context.on("response", (answer) => {
      sizes.push([new URL(answer.url()).pathname.split("/").at(-1) ?? "", packed(answer)]);
    });
  });
  const at = await hintedPoint(page);
  await press(page, at, { x: at.x, y: at.y - 30 });
  await expect.poll(() => movedCount(page)).toBeGreaterThan(0);
  await page.mouse.up();
  const needed = await Promise.all(sizes.map(async ([name, size]) => [name, await size] as const));
  const names = needed.map(([name]) => name);
  expect(names.some((name) => name.endsWith(".wasm"))).toBe(true);
  expect(names.some((name) => name.startsWith("worker"))).toBe(true);
  const total = needed.reduce((sum, [, size]) => sum + size, 0);
  expect(total, JSON.stringify(needed)).toBeLessThan(LIMIT);
  console.info(`transfer up to the first drag: ${total} bytes of at most ${LIMIT}`);
  await page.context().close();
});

it("comes in a few files until the page is at rest, the controls in one", async () => {
  const scripts: string[] = [];
  const page = await site.open({}, "", async (context) => {
    context.on("request", (request) => {
      const name = new URL(request.url()).pathname.split("/").at(-1) ?? "";
      if (name.endsWith(".js")) scripts.push(name);
    });
  });
  await page.getByRole("button", { name: "What is this? (the drag tools)" }).waitFor();
  await page.waitForLoadState("networkidle");
  expect(scripts.filter((name) => name.startsWith("controls-"))).toHaveLength(1);
  // The page and its worker; what it keeps, shares and begins with; its controls.
  expect(scripts.length, scripts.join(" ")).toBeLessThanOrEqual(12);
  await page.context().close();
});
