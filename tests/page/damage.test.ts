// SPDX-License-Identifier: MIT
// A panel can be flat and spoilt all the same: the page says so, in words, wherever it says flat.
import { expect, it } from "vitest";
import {
  exportAs,
  idle,
  openLastSolve,
  pickFile,
  status,
  still,
  typeTarget,
} from "../browser/support/page.ts";
import { site } from "./support/site.ts";

/** Panel 0 is a square; the flat quad nearest to panel 1, which is twisted, has no width. */
const TWISTED = `v 10 0 0
v 12 0 0
v 12 2 0
v 10 2 0
v 2 0 1
v 0.5 0.5 -1
v -2 0 1
v -0.5 -0.5 -1
f 1 2 3 4
f 5 6 7 8
`;

const points = (obj: string): number[][] =>
  [...obj.matchAll(/^v (\S+) (\S+) (\S+)/gm)].map((line) => line.slice(1, 4).map(Number));

it("says by how much planarising moved the points, and which panels it spoilt", async () => {
  const page = await site.openVault({ viewport: { width: 1440, height: 900 } });
  await page.getByText("Advanced", { exact: true }).click();
  await page.getByRole("checkbox", { name: "Panels keep their shape" }).uncheck();
  await pickFile(page, "twisted.obj", TWISTED);
  await page.getByRole("slider", { name: "Aim for" }).fill("0");
  await page.getByRole("button", { name: "Planarise" }).first().click();
  await expect.poll(() => status(page)).toContain("planarised first");
  await idle(page);
  const flat = points((await exportAs(page, "OBJ")).toString());
  const moves = points(TWISTED).map((from, v) =>
    Math.hypot(...from.map((x, axis) => x - (flat[v]?.[axis] ?? 0))),
  );
  const largest = Math.max(...moves);
  expect(largest).toBeGreaterThan(0.01);
  const said = `${moves.filter((move) => move > 0).length} points moved by up to ${(1000 * largest).toFixed(0)} mm`;
  expect(await status(page)).toContain(`planarised first: ${said}`);
  // The planarised mesh is the base of what follows.
  expect(await status(page)).toContain("0 of 8 points move");
  await expect.poll(() => status(page)).toContain("flat, but 1 panel has collapsed: show");
  // The report stays to say it, and so does the verdict; both figures can be had later too.
  const report = page.getByRole("region", { name: "twisted.obj" });
  expect(await report.getByText(said).count()).toBe(1);
  expect(await report.getByText("1 panel has collapsed").count()).toBe(1);
  expect(await page.getByText("But 1 panel has collapsed since the mesh was opened.").count()).toBe(
    1,
  );
  await report.getByRole("button", { name: "Start editing" }).click();
  await openLastSolve(page);
  expect(await page.getByText(said).count()).toBe(2);
  await page.getByRole("button", { name: /1 panel has collapsed: show/ }).click();
  await expect.poll(() => page.getByText(/^Panel 1 4 corners/).count()).toBe(1);
  await page.getByRole("button", { name: "Undo" }).click();
  await idle(page);
  expect(await status(page)).not.toMatch(/planarised first|collapsed/);
  await page.context().close();
});

it("the report of a file says of an edit that it spoilt panels, not that making it flat did", async () => {
  const page = await site.openVault({ viewport: { width: 1440, height: 900 } });
  await page.getByText("Advanced", { exact: true }).click();
  await page.getByRole("checkbox", { name: "Panels keep their shape" }).uncheck();
  await pickFile(page, "twisted.obj", TWISTED);
  await page.getByRole("slider", { name: "Aim for" }).fill("0");
  await page.getByRole("button", { name: "Planarise" }).first().click();
  await idle(page);
  const report = page.getByRole("region", { name: "twisted.obj" });
  await report.getByText("Made flat, but").waitFor();
  await typeTarget(page, "+10cm");
  await report.getByText("After the edit").waitFor();
  expect(await report.getByText("Made flat, but").count()).toBe(0);
  await page.context().close();
});

it("planarises without spoiling a panel, unless that is asked for", async () => {
  const page = await site.openVault({ viewport: { width: 1440, height: 900 } });
  await pickFile(page, "twisted.obj", TWISTED);
  await page.getByRole("button", { name: "Planarise" }).first().click();
  await idle(page);
  await expect.poll(() => status(page)).toContain("planarised first");
  await still(page);
  expect(await status(page)).not.toMatch(/collapsed|concave|crossing|turned over/);
  await page.context().close();
});

it("says which panels an edit spoilt once it is finished, and goes to each in turn", async () => {
  const page = await site.openVault({ viewport: { width: 1440, height: 900 } });
  await typeTarget(page, "+40cm");
  await still(page);
  expect(await page.getByRole("button", { name: /: show$/ }).count()).toBe(0);
  await page.getByText("Advanced", { exact: true }).click();
  await page.getByRole("checkbox", { name: "Panels keep their shape" }).uncheck();
  await idle(page);
  const field = page.getByRole("table", { name: "Handles" }).getByRole("spinbutton", { name: "X" });
  await field.fill("+3m");
  await field.press("Enter");
  await idle(page);
  const show = page.getByRole("status").getByRole("button", { name: /^flat, but .*: show$/ });
  await expect.poll(() => show.count()).toBe(1);
  const count = [...((await show.textContent()) ?? "").matchAll(/\d+/g)]
    .map(Number)
    .reduce((sum, n) => sum + n, 0);
  const seen = new Set<string>();
  for (let k = 0; k <= count; ++k) {
    await show.press("Enter");
    const panel = page.getByText(/^Panel \d+ 4 corners/);
    await expect.poll(() => panel.count()).toBe(1);
    seen.add((await panel.textContent()) ?? "");
  }
  expect(seen.size).toBe(count);
  await page.getByRole("button", { name: "Undo" }).click();
  await idle(page);
  await expect.poll(() => page.getByRole("button", { name: /: show$/ }).count()).toBe(0);
  await page.context().close();
});
