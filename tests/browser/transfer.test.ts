// SPDX-License-Identifier: MIT
// How much a first visit has to load before it can drag: as bytes after gzip, which every static
// server can send. What is kept for later (offline, GLB) does not count.
import { gzipSync } from "node:zlib";
import type { Response } from "playwright-core";
import { expect, it } from "vitest";
import { movedCount } from "./support/page.ts";
import { site } from "./support/site.ts";

/** What "ready in 1.5 s, and soon to the first drag" leaves room for. */
const LIMIT = 600_000;

/** Parts that come by themselves later; a drag must not wait for any of them. */
const LATER =
  /(analysis|glb|advanced|limits|kept-kinds|last-solve|panels-table|histogram|help-text|offered|link|files|snapshots?-[a-z]+|exploring|more-commands|stopped-note|going-on|holding-panels|patch-picture|variation-gallery|gallery|slider-stops|import-report|point-figure|moves|panel-picking|panel-figure|surface-move|shared-link|designs|variation-sliders|continue-button|announcement|meet-targets|verdict|mesh-hash|damage[a-z-]*|panel-rows|health-scale|planarity-scale|legend-scales|tolerance|exporting|saved-[a-z]+|reading|patch-drawing|limit-field|measured-panels|remake-note|lower-solution|point-supports|view-notes|offset|hiding|beside-point|kept-sections|keep-out[a-z-]*|received-note|drawing-follower|counted|extent|section-[a-z]+|symmetry[a-z-]*|note|receiving|companions|beside-text|view-commands|ask|glass|occlusion|groups[a-z-]*|group-members|face-runs)-/;

it("is at most 600 KB for everything that a drag needs", async () => {
  const sizes: (readonly [string, Promise<number>])[] = [];
  const packed = async (answer: Response): Promise<number> =>
    gzipSync(await answer.body(), { level: 9 }).length;
  const page = await site.open({ serviceWorkers: "block" }, "", async (context) => {
    // Held back for ever, so that the drag below shows that it does without.
    await context.route(LATER, () => {});
    context.on("response", (answer) => {
      sizes.push([new URL(answer.url()).pathname.split("/").at(-1) ?? "", packed(answer)]);
    });
  });
  const box = await page.getByLabel("3D view").boundingBox();
  if (!box) throw new Error("no 3D view");
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let k = 1; k <= 6; ++k) await page.mouse.move(x, y - 5 * k);
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
