// SPDX-License-Identifier: MIT
// Needs: pixels, workers.
// Files into the page by every door, what it says about them, and a picture out of it.
import { describe, expect, it } from "vitest";
import { flatRoof } from "./support/faults.ts";
import { exportAs, pickFile, status, still, typeTarget } from "./support/page.ts";
import { type Picture, readPng } from "./support/pixels.ts";
import { site } from "./support/site.ts";

describe("a mesh opens", () => {
  it("by dropping it on the page, and a large one while the page goes on answering", async () => {
    const page = await site.openVault();
    const dropped = await page.evaluateHandle((text) => {
      const transfer = new DataTransfer();
      transfer.items.add(new File([text], "dropped.obj"));
      return transfer;
    }, flatRoof(6));
    await page.getByRole("main").dispatchEvent("dragover", { dataTransfer: dropped });
    expect(await page.getByText("Drop an OBJ, OFF, PLY, GLB or 3DM file").count()).toBe(1);
    await page.getByRole("main").dispatchEvent("drop", { dataTransfer: dropped });
    await expect.poll(() => status(page)).toMatch(/0 of 49 points/);
    expect(await page.getByRole("region", { name: "dropped.obj" }).count()).toBe(1);
    // Of sixty thousand points, while the page goes on answering.
    await pickFile(page, "large.obj", flatRoof(249));
    await page.getByRole("button", { name: "Help" }).click();
    expect(await page.getByRole("dialog", { name: "How it works" }).isVisible()).toBe(true);
    await page.keyboard.press("Escape");
    await expect.poll(() => status(page), { timeout: 60_000 }).toMatch(/0 of 62500 points/);
    await page.context().close();
  });
});

it("the picture out of the page is the view, in its own size, without arrows and the reach", async () => {
  const page = await site.openVault({ draws: true });
  await typeTarget(page, "+60cm");
  await still(page);
  const png = await exportAs(page, "PNG");
  const green = (colour: readonly number[]): boolean =>
    [0x3c, 0x8a, 0x4e].every((value, k) => Math.abs(value - (colour[k] ?? 0)) < 16);
  const [kept, seen] = [readPng(png), readPng(await page.locator("canvas#view").screenshot())];
  const arrow = (picture: Picture): number => {
    let pixels = 0;
    for (let y = 0; y < picture.height; ++y)
      for (let x = 0; x < picture.width; ++x) if (green(picture.at(x, y))) pixels += 1;
    return pixels;
  };
  expect(arrow(seen)).toBeGreaterThan(0);
  expect(arrow(kept)).toBe(0);
  expect(png.subarray(1, 4).toString()).toBe("PNG");
  const canvas = page.getByLabel("3D view");
  const size = await canvas.evaluate((element: HTMLCanvasElement) => [
    element.width,
    element.height,
  ]);
  expect([png.readUInt32BE(16), png.readUInt32BE(20)]).toEqual(size);
  const colours = await page.evaluate(async (text) => {
    const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
    const picture = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
    const context = new OffscreenCanvas(picture.width, picture.height).getContext("2d");
    context?.drawImage(picture, 0, 0);
    const data = context?.getImageData(0, 0, picture.width, picture.height).data ?? [];
    const seen = new Set<number>();
    for (let k = 0; k + 3 < data.length; k += 4)
      seen.add(((data[k] ?? 0) << 16) | ((data[k + 1] ?? 0) << 8) | (data[k + 2] ?? 0));
    return seen.size;
  }, png.toString("base64"));
  expect(colours).toBeGreaterThan(100);
  await page.context().close();
});
