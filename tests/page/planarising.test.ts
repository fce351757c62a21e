// SPDX-License-Identifier: MIT
// Planarising is tried out at the door: the model shows what it gives, the file stays as it is until taken.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { readObj } from "../browser/support/obj.ts";
import { exportAs, idle, openFile, status, typeTarget } from "../browser/support/page.ts";
import { TEST_LIMIT } from "../patience.ts";
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

it("leaves the file as it is, and says where the boundary is in the way", async () => {
  const page = await site.openVault({ viewport: { width: 1440, height: 900 } });
  await openFile(page, "dome.obj", dome());
  const file = await exported(page);
  await figures(page).waitFor();
  await page.getByRole("button", { name: "Not now" }).click();
  await expect.poll(() => status(page)).toContain(`0 of ${(SIZE + 1) ** 2} points move`);
  expect(await exported(page)).toEqual(file);
  // A panel that lies on the boundary alone cannot stay and become flat.
  await openFile(page, "one.obj", "v 0 0 0\nv 2 0 0\nv 2 2 0.3\nv 0 2 0\nf 1 2 3 4\n");
  const keep = page.getByRole("checkbox", { name: "Keep the boundary where it is" });
  await expect.poll(() => keep.isChecked()).toBe(false);
  await expect.poll(() => cell(page, "Worst panel", 1)).toBe("flat");
  await keep.check();
  await page.getByText(/Let the boundary move/).waitFor();
  await page.context().close();
});

it("goes no farther than it may, and stays out of flat by what it may", async () => {
  const page = await site.openVault({ viewport: { width: 1440, height: 900 } });
  await openFile(page, "dome.obj", dome());
  await figures(page).waitFor();
  const free = millimetres(await cell(page, "Largest move", 1));
  const most = page.getByRole("textbox", { name: "Largest move" });
  expect(await most.inputValue()).toBe("any");
  await most.fill("30mm");
  await most.press("Enter");
  await page
    .getByText(/Not every panel can be exactly flat: .* no point may move farther/)
    .waitFor();
  expect(free).toBeGreaterThan(30);
  expect(millimetres(await cell(page, "Largest move", 1))).toBeLessThanOrEqual(30);
  expect(millimetres(await cell(page, "Largest move", 1))).toBeGreaterThan(10);
  expect(await cell(page, "Worst panel", 1)).toMatch(/^[\d.]+ mm\/m$/);

  await most.fill("any");
  await most.press("Enter");
  await page.getByRole("combobox", { name: "Flat" }).selectOption("to within 5 mm/m");
  await expect.poll(() => cell(page, "Worst panel", 1)).toMatch(/^[1-4]\.\d* mm\/m$/);
  const near = millimetres(await cell(page, "Largest move", 1));
  expect(near).toBeLessThan(free);
  await page.getByRole("button", { name: "Planarise", exact: true }).click();
  await page.getByRole("button", { name: "Start editing" }).click();
  await idle(page);
  // It can be edited, and a link makes the same mesh.
  await typeTarget(page, "+10cm");
  await page.getByRole("button", { name: "Share" }).click();
  const link = await page.getByRole("textbox", { name: "Link" }).inputValue();
  await page.context().close();
  const again = await site.open({}, new URL(link).hash);
  await again.getByText(/Verified/).waitFor();
  await again.context().close();
});

it("two places of the slider that come to one mesh say so", async () => {
  const page = await site.openVault({ viewport: { width: 1440, height: 900 } });
  // One panel knows no smoother way to become flat.
  await openFile(page, "one.obj", "v 0 0 0\nv 2 0 0\nv 2 2 0.3\nv 0 2 0\nf 1 2 3 4\n");
  await figures(page).waitFor();
  const slider = page.getByRole("slider", { name: "Aim for" });
  const same = page.getByText(/^The same mesh as at /);
  expect(await same.count()).toBe(0);
  await slider.fill("3");
  await expect.poll(() => same.textContent()).toBe("The same mesh as at “fair”.");
  await page.context().close();
});

/** Lines 1 m apart, `height` over the middle. */
function net(count: number, height: (x: number, y: number) => number): string {
  const lines: string[] = [];
  const from = (k: number): number => k - count / 2;
  for (let j = 0; j <= count; ++j)
    for (let i = 0; i <= count; ++i) lines.push(`v ${i} ${j} ${height(from(i), from(j))}`);
  for (let j = 0; j < count; ++j)
    for (let i = 0; i < count; ++i) {
      const a = j * (count + 1) + i + 1;
      lines.push(`f ${a} ${a + 1} ${a + count + 2} ${a + count + 1}`);
    }
  return `${lines.join("\n")}\n`;
}

/** A saddle along its straight lines: no flat mesh is near. */
const saddle = (count: number, rise: number): string =>
  net(count, (x, y) => (rise * x * y) / count);

it("where no flat mesh is near, shows how flat panels get near the file, and what else there is", {
  timeout: 2 * TEST_LIMIT,
}, async () => {
  const page = await site.openVault({ viewport: { width: 1440, height: 900 } });
  await openFile(page, "saddle.obj", saddle(20, 3));
  const why = page.getByText(/^Not every panel can be exactly flat near the file\./);
  await why.waitFor();
  expect(millimetres(await cell(page, "Largest move", 1))).toBeLessThanOrEqual(300);
  // Each place of the slider stays within a distance of its own.
  const moves: number[] = [];
  for (const [place, most] of [30, 90].entries()) {
    await page.getByRole("slider", { name: "Aim for" }).fill(String(place));
    await page.getByText(`where points move by ${most} mm at most, the boundary too`).waitFor();
    moves.push(millimetres(await cell(page, "Largest move", 1)));
    expect(moves.at(-1)).toBeLessThanOrEqual(most);
  }
  expect(moves[1]).toBeGreaterThan(moves[0] ?? Number.NaN);
  const others = page.getByRole("group", { name: "What else there is" });
  await others.getByRole("button", { name: "Flat to within 20 mm/m" }).waitFor();
  await others.getByRole("button", { name: "Split up to 50 % of the panels" }).waitFor();
  // What is being tried can be given up, with what is there already.
  await page.getByRole("slider", { name: "Aim for" }).fill("3");
  await page.getByText(/^Shown: as flat as panels get/).waitFor();
  await page.getByRole("button", { name: "Stop trying" }).click();
  await why.waitFor();
  await page.getByRole("button", { name: "Not now" }).click();
  await page.context().close();
});

/** Label and cost of each way, once all costs are known. */
async function costs(page: Page): Promise<ReadonlyMap<string, string>> {
  const ways = page.getByRole("group", { name: "What else there is" }).locator(".other-way");
  await expect
    .poll(async () => {
      const all = await ways.allTextContents();
      return all.length > 0 && all.every((words) => words.includes("moves up to"));
    })
    .toBe(true);
  await idle(page);
  const all = await ways.allTextContents();
  return new Map(all.map((words) => words.split(/(?=moves up to)/) as [string, string]));
}

it("what else there is says what it costs before it is pressed, the least move first, and gives just that", async () => {
  const page = await site.openVault({ viewport: { width: 1440, height: 900 } });
  await openFile(page, "saddle.obj", saddle(6, 1));
  const keep = page.getByRole("checkbox", { name: "Keep the boundary where it is" });
  const said: string[] = [];
  /** Presses the button of that name: what it was to cost is what there is. */
  const take = async (name: string): Promise<void> => {
    const known = await costs(page);
    const cost = known.get(name) ?? "";
    said.push([...known].map((one) => one.join(": ")).join("; "));
    await page.getByRole("button", { name, exact: true }).click();
    await expect
      .poll(() => cell(page, "Largest move", 1))
      .toContain(/moves up to ([\d.]+ mm)/.exec(cost)?.[1]);
    const worst = /bent by up to (.*)$/.exec(cost)?.[1] ?? "flat";
    expect(await cell(page, "Worst panel", 1)).toBe(worst);
    if (cost.includes("split"))
      expect(cost).toContain(
        `${Number.parseInt((await cell(page, "Panels split", 1)) ?? "", 10)} panels split`,
      );
  };
  const flat = page.getByRole("combobox", { name: "Flat" });
  await take("Flat to within 20 mm/m");
  await flat.selectOption("exactly");
  await take("Move points by 60 mm at most");
  await take("Let points move farther");
  await flat.selectOption("exactly");
  await keep.check();
  await take("Split up to 50 % of the panels");
  await page.getByRole("combobox", { name: "Split panels" }).selectOption("none");
  await take("Let the boundary move");
  const [first, , third, fourth] = said;
  expect(first).toMatch(
    /^Move points by 60 mm.*; Flat to within 20 mm\/m: moves up to 1256 mm, 36 panels bent/,
  );
  expect(third).toMatch(/^Split up to 50 %.* all flat, 18 panels split; Let points move farther/);
  // What does not become as flat as it asks for is last, however little it moves.
  expect(fourth).toMatch(
    /^Let the boundary.* all flat; Split .*; Flat to within 20 mm\/m: moves up to 0\.53 mm/,
  );
  await page.context().close();
});

it("a net along the wrong lines is said to be one, and its panels can be coloured by it", async () => {
  const page = await site.openVault({ viewport: { width: 1440, height: 900 } });
  await openFile(page, "saddle.obj", saddle(6, 1));
  await page
    .getByText(/^Lines run up to 90° off .*\(conjugate directions\), half .* more than 88°/)
    .waitFor();
  const colours = page.getByRole("combobox", { name: "Colour by" });
  const before = await colours.inputValue();
  await page.getByRole("checkbox", { name: "Colour panels by it" }).check();
  expect(await colours.inputValue()).toBe("conjugacy");
  await page.getByText(/^Lines of the mesh as opened, .*: half more than 8\d\.\d°/).waitFor();
  await page.getByRole("checkbox", { name: "Colour panels by it" }).uncheck();
  expect(await colours.inputValue()).toBe(before);
  // Of a net of translation, a little out of flat, nothing is said.
  await openFile(
    page,
    "cap.obj",
    net(6, (x, y) => -0.05 * x * x - 0.04 * y * y + 0.001 * x * y),
  );
  await colours.selectOption("Conjugate directions");
  await page.getByText(/^Lines of the mesh as opened, .*: half more than \d\.\d°/).waitFor();
  expect(await page.getByText(/^Lines run up to/).count()).toBe(0);
  await page.context().close();
});

it("colours that the note of a net took away are there again once it is gone", async () => {
  const page = await site.openVault({ viewport: { width: 1440, height: 900 } });
  const colours = page.getByRole("combobox", { name: "Colour by" });
  await openFile(page, "saddle.obj", saddle(6, 1));
  await colours.selectOption("fold");
  await page.getByRole("checkbox", { name: "Colour panels by it" }).check();
  expect(await colours.inputValue()).toBe("conjugacy");
  await page.getByRole("button", { name: "Edit as it is" }).click();
  await expect.poll(() => colours.inputValue()).toBe("fold");
  await page.context().close();
});

it("the directions of a large net are measured once they are asked for", async () => {
  const page = await site.openVault({ viewport: { width: 1440, height: 900 } });
  await openFile(page, "saddle.obj", saddle(71, 1));
  await page.getByRole("combobox", { name: "Colour by" }).selectOption("Conjugate directions");
  const measure = page.getByRole("button", { name: "Measure all panels" });
  await measure.waitFor();
  const said = page.getByText(/^Lines of the mesh as opened, .*: half more than \d\d\.\d°/);
  expect(await said.count()).toBe(0);
  await measure.click();
  await said.waitFor();
  expect(await measure.count()).toBe(0);
  await page.context().close();
});

it("a flat mesh that is another shape is said to be one, with the way back near the file", async () => {
  const page = await site.openVault({ viewport: { width: 1440, height: 900 } });
  await openFile(page, "saddle.obj", saddle(6, 1));
  await page
    .getByText("Points move by up to 1500 mm, 25 % of the size: it is another shape.")
    .waitFor();
  expect(await cell(page, "Panels that are flat", 0)).toBe("0 of 36");
  expect(await cell(page, "Panels that are flat", 1)).toBe("36 of 36");
  await page.getByRole("button", { name: "Move points by 60 mm at most" }).click();
  await expect
    .poll(async () => millimetres(await cell(page, "Largest move", 1)))
    .toBeLessThanOrEqual(60);
  await page.getByRole("button", { name: "Let points move farther" }).click();
  await expect
    .poll(async () => millimetres(await cell(page, "Largest move", 1)))
    .toBeGreaterThan(600);
  await page.context().close();
});
