// SPDX-License-Identifier: MIT
// Needs: workers.
// Planarising is tried out at the door: the model shows what it gives, the file stays as it is until taken.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { readObj } from "./support/obj.ts";
import { exportAs, idle, openFile, status } from "./support/page.ts";
import { site } from "./support/site.ts";

const SIZE = 10;

/** A shallow dome of quads that are not flat, 1 m apart. */
function dome(): string {
  const lines: string[] = [];
  const height = (t: number): number => Math.cos(((t / SIZE - 0.5) * Math.PI) / 1.2);
  for (let i = 0; i <= SIZE; ++i)
    for (let j = 0; j <= SIZE; ++j)
      lines.push(`v ${i} ${j + 0.04 * i * j} ${(2 * height(i) * height(j)).toFixed(9)}`);
  const at = (i: number, j: number): number => i * (SIZE + 1) + j + 1;
  for (let i = 0; i < SIZE; ++i)
    for (let j = 0; j < SIZE; ++j)
      lines.push(`f ${at(i, j)} ${at(i + 1, j)} ${at(i + 1, j + 1)} ${at(i, j + 1)}`);
  return `${lines.join("\n")}\n`;
}

const exported = async (page: Page) => readObj((await exportAs(page, "OBJ")).toString());

const figures = (page: Page) => page.getByRole("table", { name: "Before and after planarising" });

const cell = (page: Page, row: string, column: number) =>
  figures(page).getByRole("row", { name: row }).getByRole("cell").nth(column).textContent();

const millimetres = (words: string | null): number =>
  Number(/([\d.]+) mm/.exec(words ?? "")?.[1] ?? Number.NaN);

/** Notes what the page asks its workers, from here on. */
async function overhear(page: Page): Promise<() => Promise<readonly Asked[]>> {
  await page.evaluate(() => {
    const asked: Asked[] = [];
    Object.assign(window, { asked });
    const post = Worker.prototype.postMessage;
    Worker.prototype.postMessage = function (this: Worker, request: Asked, ...rest: []) {
      const { kind, planarise, found } = request;
      asked.push({ kind, planarise, found: found ? [...found] : found });
      post.call(this, request, ...rest);
    };
  });
  return () => page.evaluate(() => (window as unknown as { asked: Asked[] }).asked);
}

interface Asked {
  kind: string;
  planarise?: { within: number; flat: number; keepBoundary: boolean } | null | undefined;
  found?: number[] | null | undefined;
}

it("shows what planarising gives before it is done, and does just that, once", async () => {
  const page = await site.openVault({ viewport: { width: 1440, height: 900 } });
  const asked = await overhear(page);
  await openFile(page, "dome.obj", dome());
  const file = await exported(page);
  const keep = page.getByRole("checkbox", { name: "Keep the boundary where it is" });
  expect(await keep.isChecked()).toBe(true);
  await figures(page).waitFor();
  expect(await cell(page, "Worst panel", 0)).toMatch(/[1-9].* mm\/m/);
  expect(await cell(page, "Worst panel", 1)).toBe("flat");
  expect(await cell(page, "Panels it spoils", 1)).toBe("none");
  expect(await cell(page, "95 % of panels fold", 1)).toMatch(/°$/);
  expect(await cell(page, "Points that move", 1)).toBe(`${(SIZE - 1) ** 2} of ${(SIZE + 1) ** 2}`);
  expect(await status(page)).toContain(`${(SIZE - 1) ** 2} of ${(SIZE + 1) ** 2} points move`);
  // The design is still the file.
  expect(await exported(page)).toEqual(file);

  // Each place of the slider is another mesh; the nearest is no farther than the fairest.
  const fair = millimetres(await cell(page, "Largest move", 1));
  await page.getByRole("slider", { name: "Aim for" }).fill("0");
  await expect.poll(() => figures(page).count()).toBe(1);
  await expect.poll(async () => millimetres(await cell(page, "Largest move", 1))).not.toBe(fair);
  const near = millimetres(await cell(page, "Largest move", 1));
  expect(near).toBeLessThan(fair);

  // What is taken is what was shown, to the last bit; nobody makes it a second time.
  // (What is near the file is tried, too, where the first takes long, and what else there is.)
  const whole = (all: readonly Asked[]) =>
    all.filter(({ planarise: how }) => how?.within === 0 && how.flat === 0 && how.keepBoundary);
  expect(whole(await asked()).length).toBe(2);
  await page.getByRole("button", { name: "Planarise", exact: true }).click();
  await page.getByRole("button", { name: "Start editing" }).waitFor();
  await idle(page);
  const flat = await exported(page);
  const moves = file.points.map((p, v) =>
    Math.hypot(...p.map((x, axis) => x - (flat.points[v]?.[axis] ?? Number.NaN))),
  );
  expect(Math.abs(1000 * Math.max(...moves) - near)).toBeLessThanOrEqual(1);
  expect(moves.filter((move) => move > 0).length).toBe((SIZE - 1) ** 2);
  const all = await asked();
  expect(whole(all).length).toBe(2);
  const taken = all.filter(({ kind }) => kind === "planarise");
  expect(taken.map(({ found }) => found)).toEqual([flat.points.flat()]);

  // What is still being tried out is taken as soon as it is there.
  await openFile(page, "dome.obj", dome());
  await page.getByRole("button", { name: "Planarise", exact: true }).click();
  await page.getByRole("button", { name: "Start editing" }).waitFor();
  await idle(page);
  const since = (await asked()).slice(all.length);
  expect(whole(since).length).toBe(1);
  const again = await exported(page);
  expect(since.find(({ kind }) => kind === "planarise")?.found).toEqual(again.points.flat());
  await page.context().close();
});
