// SPDX-License-Identifier: MIT
// How much a first visit has to load before it can drag: as bytes after gzip, which every static
// server can send. What is kept for later (offline, GLB) does not count.
import { gzipSync } from "node:zlib";
import type { Response } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import { movedCount, openSite, type Site } from "./support/page.ts";

const LIMIT = 500_000;

let site: Site;
beforeAll(async () => {
  site = await openSite();
});
afterAll(() => site.close());

it("is at most 500 KB for everything that a drag needs", async () => {
  const answers: Response[] = [];
  const page = await site.open({ serviceWorkers: "block" }, "", async (context) => {
    context.on("response", (response) => answers.push(response));
  });
  const needed = answers.slice();
  const box = await page.getByLabel("3D view").boundingBox();
  if (!box) throw new Error("no 3D view");
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let k = 1; k <= 6; ++k) await page.mouse.move(x, y - 5 * k);
  await expect.poll(() => movedCount(page)).toBeGreaterThan(0);
  await page.mouse.up();
  const sizes = await Promise.all(
    needed.map(async (answer) => {
      const name = new URL(answer.url()).pathname.split("/").at(-1) ?? "";
      return [name, gzipSync(await answer.body(), { level: 9 }).length] as const;
    }),
  );
  const names = sizes.map(([name]) => name);
  expect(names.some((name) => name.endsWith(".wasm"))).toBe(true);
  expect(names.some((name) => name.startsWith("worker"))).toBe(true);
  expect(names.some((name) => name.includes("glb"))).toBe(false);
  const total = sizes.reduce((sum, [, size]) => sum + size, 0);
  expect(total, JSON.stringify(sizes)).toBeLessThan(LIMIT);
  console.info(`transfer before the first drag: ${total} bytes of at most ${LIMIT}`);
  await page.context().close();
});
