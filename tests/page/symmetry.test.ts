// SPDX-License-Identifier: MIT
// An edit of one point edits its images in the page, until the symmetry is switched off.
import { expect, it } from "vitest";
import { readObj } from "../browser/support/obj.ts";
import {
  exportAs,
  idle,
  movedCount,
  obj,
  openFile,
  openRule,
  typeTarget,
} from "../browser/support/page.ts";
import { site } from "./support/site.ts";

it("all that a roof has is found; what is typed for one point moves its images", async () => {
  const page = await site.open();
  await openRule(page, "Symmetry");
  const images = page.getByText("Each point has 4 images, itself included.");
  await page.getByRole("button", { name: "All that it has" }).click();
  await expect.poll(() => images.count()).toBe(1);
  expect(await page.getByLabel("Mirror across y").isChecked()).toBe(true);
  expect(await page.getByLabel("Turns about z").inputValue()).toBe("2");
  // A point that is on neither plane: the first key takes the one in the middle, the others go aside.
  await page.getByLabel("3D view").focus();
  for (const key of ["ArrowUp", "ArrowRight", "ArrowRight", "ArrowUp", "ArrowUp"])
    await page.keyboard.press(key);
  await typeTarget(page, "+0.4");
  await idle(page);
  const { points } = readObj(await obj(page));
  const middle = [0, 1].map(
    (axis) => points.reduce((sum, p) => sum + (p[axis] ?? 0), 0) / points.length,
  );
  // Every point has one of its height on the other side of either mirror plane.
  for (const axis of [0, 1]) {
    const off = points.map((p) => {
      const image = p.map((x, k) => (k === axis ? 2 * (middle[axis] ?? 0) - x : x));
      return Math.min(...points.map((q) => Math.hypot(...q.map((x, k) => x - (image[k] ?? 0)))));
    });
    expect(Math.max(...off)).toBeLessThan(1e-9);
  }
  const together = await movedCount(page);
  expect(await page.locator(".marker.image").count()).toBeGreaterThan(0);
  // A GLB of it opens with it.
  await openFile(page, "roof.glb", await exportAs(page, "GLB"));
  await page
    .getByText(/^Verified: the same result/)
    .first()
    .waitFor();
  expect(await images.count()).toBe(1);
  expect(await movedCount(page)).toBe(together);
  await page.getByRole("button", { name: "None", exact: true }).click();
  await expect.poll(() => images.count()).toBe(0);
  await idle(page);
  expect(await movedCount(page)).toBeLessThan(together);
  await page.getByRole("button", { name: "Undo" }).click();
  await expect.poll(() => images.count()).toBe(1);
  expect(await movedCount(page)).toBe(together);
  await page.context().close();
});
