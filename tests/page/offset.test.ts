// SPDX-License-Identifier: MIT
// Check and make, Second layer: the design at a distance, shown with it, made again after an edit, kept in GLB.
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { expect, it, vi } from "vitest";
import { layOut } from "../browser/support/layer.ts";
import {
  exportAs,
  idle,
  obj,
  openFile,
  showTab,
  still,
  typeTarget,
} from "../browser/support/page.ts";
import { site } from "./support/site.ts";

const CLI = new URL("../../build/native/planish", import.meta.url).pathname;

/** The points of the second layer in a GLB, z up. */
function layerOf(glb: Buffer): number[][] {
  const length = glb.readUInt32LE(12);
  const json = JSON.parse(glb.subarray(20, 20 + length).toString());
  const node = json.nodes.find(({ name }: { name: string }) => name === "planish offset");
  const [right = 0, up = 0, back = 0] = node.translation ?? [];
  const accessor = json.accessors[json.meshes[node.mesh].primitives[0].attributes.POSITION];
  const start = 28 + length + json.bufferViews[accessor.bufferView].byteOffset;
  return Array.from({ length: accessor.count }, (_, v) => {
    const at = (axis: number): number => glb.readFloatLE(start + 12 * v + 4 * axis);
    return [at(0) + right, -(at(2) + back), at(1) + up];
  });
}

/** That of the command line. */
function offsetOf(mesh: string, distance: string): number[][] {
  const folder = mkdtempSync(join(tmpdir(), "planish-offset-"));
  const [from, to] = [join(folder, "mesh.obj"), join(folder, "layer.obj")];
  writeFileSync(from, mesh);
  execFileSync(CLI, ["offset", from, "--distance", distance, "-o", to]);
  const text = readFileSync(to, "utf8");
  rmSync(folder, { recursive: true });
  return text
    .split("\n")
    .filter((line) => line.startsWith("v "))
    .map((line) => line.split(" ").slice(1).map(Number));
}

function largestGap(a: number[][], b: number[][]): number {
  expect(a.length).toBe(b.length);
  const gaps = a.map((p, v) => Math.hypot(...p.map((x, axis) => x - (b[v]?.[axis] ?? 0))));
  return Math.max(...gaps);
}

/** What a click in the middle of the view selects. */
async function pick(page: Page): Promise<string> {
  const box = await page.getByLabel("3D view").boundingBox();
  if (!box) throw new Error("no 3D view");
  const figure = page.locator(".panel-figure strong");
  await page.getByLabel("3D view").press("Escape");
  await expect.poll(() => figure.count()).toBe(0);
  // The camera's axis is in the middle of what the tools leave free.
  await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2 + 26);
  await figure.waitFor();
  return figure.innerText();
}

it("a second layer is said, follows the design, and is in its GLB", async () => {
  const page = await site.open();
  await page.getByRole("combobox", { name: "Sample" }).selectOption("Dome");
  await idle(page);
  // The camera goes to a panel.
  await showTab(page, "Check and make");
  await page
    .getByRole("button", { name: /^Show panel/ })
    .first()
    .click();
  await still(page);
  const picked = await pick(page);
  await layOut(page, "0.25", /^Panels lie at 250 mm everywhere\.$/);
  const note = page.getByRole("region", { name: "Second layer" });
  await note.getByText("Panels lie at 250 mm everywhere.").waitFor();
  // Outside of the design, so in front of it, and yet the design is what a click means.
  expect(await pick(page)).toBe(picked);
  expect(
    largestGap(layerOf(await exportAs(page, "GLB")), offsetOf(await obj(page), "0.25")),
  ).toBeLessThan(1e-5);
  await typeTarget(page, "+30cm");
  await note.getByText(/^Edges are parallel; points lie at \d+ mm to \d+ mm\./).waitFor();
  const [edited, glb] = [await obj(page), await exportAs(page, "GLB")];
  expect(largestGap(layerOf(glb), offsetOf(edited, "0.25"))).toBeLessThan(1e-5);
  await note.getByRole("button", { name: "Remove" }).click();
  await expect.poll(() => note.count()).toBe(0);
  expect((await exportAs(page, "GLB")).includes("planish offset")).toBe(false);
  // It is no part of the design: the file opens as what was edited.
  await openFile(page, "layered.glb", glb);
  await page.getByText(/^Verified:/).waitFor();
  expect(await obj(page)).toBe(edited);
  await page.context().close();
});

it("all commands lead to it, and the model is not behind a dialog", async () => {
  const page = await site.openVault();
  await page.keyboard.press("Control+k");
  await page.getByRole("combobox", { name: "Command" }).fill("second layer");
  await page.keyboard.press("Enter");
  await page.getByRole("spinbutton", { name: /^Distance/ }).waitFor();
  const tab = page.getByRole("tab", { name: "Check and make" });
  expect(await tab.getAttribute("aria-selected")).toBe("true");
  expect(await page.getByRole("dialog").count()).toBe(0);
  await page.context().close();
});

it("folded and unfolded again, what asks for it has the distance of the layer shown", async () => {
  const page = await site.openVault();
  await layOut(page, "0.3", /302 mm/);
  const part = page.locator("details").filter({ hasText: "Second layer" });
  await part.locator("summary").click();
  await expect.poll(() => part.getByRole("spinbutton").count()).toBe(0);
  await part.locator("summary").click();
  await expect.poll(() => part.getByRole("spinbutton").inputValue()).toBe("0.3");
  await page.context().close();
});

it("the command brings it into sight each time, by scrolling the inspector alone", async () => {
  const page = await site.openVault();
  const ask = async (): Promise<void> => {
    await page.keyboard.press("Control+k");
    await page.getByRole("combobox", { name: "Command" }).fill("second layer");
    await page.keyboard.press("Enter");
    await page.getByRole("spinbutton", { name: /^Distance/ }).waitFor();
  };
  // As if it were further down than the inspector shows.
  const below = vi
    .spyOn(HTMLElement.prototype, "getBoundingClientRect")
    .mockImplementation(function (this: HTMLElement) {
      const top = this.classList.contains("inspector-body") ? 0 : 500;
      return new DOMRect(0, top, 100, 100);
    });
  const [body, whole] = [
    vi.spyOn(HTMLElement.prototype, "scrollBy"),
    vi.spyOn(HTMLElement.prototype, "scrollIntoView"),
  ];
  for (const times of [1, 2]) {
    await ask();
    await expect.poll(() => body.mock.calls.length).toBe(times);
  }
  const inspector = document.querySelector(".inspector-body");
  for (const scrolled of body.mock.contexts) expect(scrolled).toBe(inspector);
  expect(whole.mock.contexts.filter((element) => inspector?.contains(element as Node))).toEqual([]);
  for (const spy of [below, body, whole]) spy.mockRestore();
  await page.context().close();
});
