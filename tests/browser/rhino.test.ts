// SPDX-License-Identifier: MIT
// Needs: network, pixels.
// Export → 3DM, and 3DM opened: the design again, or what a file from elsewhere holds.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { unitSystem } from "../../web/src/rhino/model.ts";
import { loadRhino } from "../parity/support/rhino.ts";
import { KEEPING } from "./support/open.ts";
import { exportAs, movedCount, obj, openFile, status, typeTarget } from "./support/page.ts";
import { site } from "./support/site.ts";

/** Files of its library that are kept for use without a network. */
const kept = (page: Page): Promise<number> =>
  page.evaluate(async () => {
    const names = await caches.keys();
    const requests = await Promise.all(names.map(async (name) => (await caches.open(name)).keys()));
    return requests.flat().filter(({ url }) => url.includes("rhino3dm")).length;
  });

it("opens again as the design, to the last bit; its library comes when asked for", async () => {
  const page = await site.open({ ...KEEPING, draws: true });
  await page.evaluate("navigator.serviceWorker.ready");
  await expect
    .poll(() => page.evaluate(() => navigator.serviceWorker.controller !== null))
    .toBe(true);
  const requests: string[] = [];
  page.on("request", (request) => requests.push(request.url()));
  await typeTarget(page, "+40cm");
  const [mesh, moved] = [await obj(page), await movedCount(page)];
  expect(requests.some((url) => url.includes("rhino3dm"))).toBe(false);
  expect(await kept(page)).toBe(0);
  const file = await exportAs(page, "3DM");
  expect(requests.some((url) => url.includes("rhino3dm"))).toBe(true);
  expect(await kept(page)).toBe(2);
  await page.context().setOffline(true);
  expect((await exportAs(page, "3DM")).length).toBeGreaterThan(100_000);
  const visitor = await site.open({ draws: true });
  await openFile(visitor, "design.3dm", file);
  await expect.poll(() => movedCount(visitor)).toBe(moved);
  await expect.poll(() => visitor.getByText(/^Verified/).count()).toBe(1);
  expect(await obj(visitor)).toBe(mesh);
  await typeTarget(visitor, "+60cm");
  await visitor.context().close();
  await page.context().close();
});

/** Shows and hides the circle that lies beside the panels, and finds it in the picture. */
async function hideContext(page: Page): Promise<void> {
  const view = page.getByLabel("3D view");
  await page.getByText("1 other object shown as context").waitFor();
  const hidden = async (): Promise<Buffer> => {
    await page.getByRole("button", { name: "Hide", exact: true }).click();
    await page.getByText("1 other object hidden").waitFor();
    const picture = await view.screenshot();
    await page.getByRole("button", { name: "Show", exact: true }).click();
    return picture;
  };
  const without = await hidden();
  await expect.poll(async () => (await view.screenshot()).equals(without)).toBe(false);
  expect((await hidden()).equals(without)).toBe(true);
}

it("gives the panels of another program's polylines, in its unit, and names the rest", async () => {
  const rhino = await loadRhino();
  const file = new rhino.File3dm();
  file.settings().modelUnitSystem = unitSystem(rhino, "ft");
  for (const x of [0, 3, 6]) {
    const points = new rhino.Point3dList(5);
    for (const [dx, y] of [
      [0, 0],
      [3, 0],
      [3, 4],
      [0, 4],
      [0, 0],
    ])
      points.add(x + (dx ?? 0), y ?? 0, 1 / 3); // prettier-ignore
    file.objects().addCurve(new rhino.PolylineCurve(points), new rhino.ObjectAttributes());
  }
  file.objects().addTextDot("north", [0, 0, 0], new rhino.ObjectAttributes());
  file.objects().addCurve(new rhino.Circle(6).toNurbsCurve(), new rhino.ObjectAttributes());
  const page = await site.open({ draws: true });
  await openFile(page, "facade.3dm", Buffer.from(file.toByteArray()));
  await expect.poll(() => page.getByRole("heading", { name: "facade.3dm" }).count()).toBe(1);
  expect(await page.getByText("3 quads").count()).toBe(1);
  expect(await page.getByText("Left out: 1 text or dimension.").count()).toBe(1);
  await hideContext(page);
  expect(await page.getByLabel("Unit of the file").inputValue()).toBe("ft");
  await page.getByRole("button", { name: "Start editing" }).click();
  expect(await obj(page)).toContain(`v 0 0 ${1 / 3}\n`);
  await openFile(page, "broken.3dm", "no model");
  expect(await page.getByRole("alert").textContent()).toMatch(/broken\.3dm: .*not a Rhino model/);
  expect(await status(page)).toMatch(/of 8 points/);
  // It belongs to the mesh that it came with.
  await page.getByRole("combobox", { name: "Sample" }).selectOption({ index: 1 });
  await expect.poll(() => page.getByText("1 other object").count()).toBe(0);
  await page.getByRole("button", { name: "Undo" }).click();
  await expect.poll(() => page.getByText("1 other object").count()).toBe(1);
  await page.context().close();
});
