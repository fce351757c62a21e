// SPDX-License-Identifier: MIT
// Advanced settings: they do what they say, and they stay when another mesh is opened.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { readObj, worstFlatness } from "../browser/support/obj.ts";
import {
  exportAs,
  idle,
  movedCount,
  openFile,
  showTab,
  typeTarget,
} from "../browser/support/page.ts";
import { handleRows } from "../browser/support/view.ts";
import { site } from "./support/site.ts";

const field = (page: Page, name: string) => page.getByRole("combobox", { name });

const exactTargets = (page: Page) =>
  page.getByRole("checkbox", { name: "Meet the targets exactly" });

async function choose(page: Page, name: string, label: string): Promise<void> {
  await field(page, name).selectOption({ label });
  await idle(page);
}

async function openAdvanced(page: Page): Promise<void> {
  await page.getByText("Advanced", { exact: true }).click();
  await exactTargets(page).waitFor();
}

/** A row of two quads, 1 m each; one corner of the second lies `lift` metres out of the plane. */
const almostFlat = (lift: number): string =>
  `v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 ${lift}\nf 1 2 5 4\nf 2 3 6 5\n`;

it("panels count as flat up to the tolerance, and stay within it", async () => {
  const page = await site.open();
  const alert = page.getByRole("alert");
  await openFile(page, "row.obj", almostFlat(0.0005));
  await page.getByRole("button", { name: "Not now" }).click();
  expect(await page.getByRole("button", { name: "Add handle" }).isDisabled()).toBe(true);

  await page.getByRole("combobox", { name: "Sample" }).selectOption("Vault");
  await idle(page);
  await openAdvanced(page);
  await choose(page, "Tolerance", "1 mm/m");
  await openFile(page, "row.obj", almostFlat(0.0005));
  await page.getByRole("button", { name: "Start editing" }).click();
  await typeTarget(page, "+10cm");
  const edited = worstFlatness(readObj((await exportAs(page, "OBJ")).toString()));
  expect(edited).toBeLessThan(1);
  expect(await alert.count()).toBe(0);

  // The mesh does not meet a tighter one: that is said, and the design stays as it was.
  await choose(page, "Tolerance", "0.001 mm/m");
  await expect.poll(() => alert.textContent()).toContain("more than 0.001 mm/m");
  expect(await field(page, "Tolerance").inputValue()).toBe("1");
  expect(worstFlatness(readObj((await exportAs(page, "OBJ")).toString()))).toBe(edited);
  // Planarise makes it possible: the same edit, on a mesh that meets it; Undo leads back.
  const handles = await handleRows(page);
  await page.getByRole("button", { name: "Planarise" }).click();
  await expect.poll(() => field(page, "Tolerance").inputValue()).toBe("0.001");
  await idle(page);
  expect(await handleRows(page)).toEqual(handles);
  expect(await movedCount(page)).toBeGreaterThan(0);
  expect(worstFlatness(readObj((await exportAs(page, "OBJ")).toString()))).toBeLessThan(0.001);
  expect(await alert.count()).toBe(0);
  for (let k = 0; k < 2; ++k) {
    await page.getByRole("button", { name: "Undo" }).click();
    await idle(page);
  }
  expect(worstFlatness(readObj((await exportAs(page, "OBJ")).toString()))).toBe(edited);
  await page.context().close();
});

it("a mesh that is nearly flat can be taken as it is by one press", async () => {
  const page = await site.open();
  const accept = page.getByRole("button", { name: "Edit as it is" });
  await openFile(page, "bent.obj", almostFlat(0.05));
  await page.getByText("Planarise first?").waitFor();
  await page
    .getByText(/once every panel is flat, or once you choose to edit it as it is\.$/)
    .waitFor();
  await page.getByText("panels stay as bent as they are, up to 25 mm/m").waitFor();
  await openFile(page, "roof.obj", almostFlat(0.005));
  await page.getByText("up to 20 mm/m counts as flat").waitFor();
  await openFile(page, "row.obj", almostFlat(0.0005));
  const before = readObj((await exportAs(page, "OBJ")).toString());
  const legend = page.getByRole("img", { name: /^Histogram: / });
  await expect.poll(() => legend.getAttribute("aria-label")).toMatch(/: [1-9]\d* points? moves?/);
  await accept.click();
  await idle(page);
  expect(await page.getByRole("region", { name: "row.obj" }).count()).toBe(0);
  await expect.poll(() => legend.count()).toBe(0);
  expect(readObj((await exportAs(page, "OBJ")).toString())).toEqual(before);
  await typeTarget(page, "+10cm");
  const edited = worstFlatness(readObj((await exportAs(page, "OBJ")).toString()));
  expect(edited).toBeLessThan(1);
  await openAdvanced(page);
  expect(await field(page, "Tolerance").inputValue()).toBe("1");
  for (let k = 0; k < 3; ++k) await page.getByRole("button", { name: "Undo" }).click();
  await idle(page);
  expect(await accept.count()).toBe(1);
  // What one mesh was taken with is nobody's choice for the next.
  await accept.click();
  await idle(page);
  await openFile(page, "next.obj", almostFlat(0.0005));
  await page.getByText("Planarise first?").waitFor();
  await page.context().close();
});

/** 8 × 8 quads of a saddle along its straight lines: no flat mesh is near it. */
function saddle(): string {
  const lines: string[] = [];
  for (let j = 0; j < 9; ++j) {
    for (let i = 0; i < 9; ++i) lines.push(`v ${i} ${j} ${0.05 * i * j}`);
  }
  for (let j = 0; j < 8; ++j) {
    for (let i = 1; i <= 8; ++i) {
      lines.push(`f ${[0, 1, 10, 9].map((step) => 9 * j + i + step).join(" ")}`);
    }
  }
  return `${lines.join("\n")}\n`;
}

it("a mesh that is bent is edited as it is, no panel bends more, and the design opens again so", async () => {
  const page = await site.open();
  await openFile(page, "saddle.obj", saddle());
  const shown = page.getByRole("img", { name: /^Histogram: / });
  await expect.poll(() => shown.getAttribute("aria-label")).toMatch(/: [1-9]\d* points move/);
  await page.getByRole("button", { name: "Edit as it is" }).click();
  await idle(page);
  // Nothing of what was tried out stays in view.
  await expect.poll(() => shown.count()).toBe(0);
  const before = worstFlatness(readObj((await exportAs(page, "OBJ")).toString()));
  expect(before).toBeGreaterThan(20);
  await typeTarget(page, "+20cm");
  const edited = (await exportAs(page, "OBJ")).toString();
  expect(worstFlatness(readObj(edited))).toBeLessThan(before + 1e-5);
  expect(worstFlatness(readObj(edited))).toBeGreaterThan(0.9 * before);
  await page.getByText(/panels stay bent/).waitFor();
  await showTab(page, "Explore");
  const design = (await exportAs(page, "JSON")).toString();
  expect(JSON.parse(design).options).toMatchObject({ tolerance: 25, keep_bends: true });
  const again = await site.open();
  await openFile(again, "saddle.json", design);
  expect((await exportAs(again, "OBJ")).toString()).toBe(edited);
  // Another mesh is not taken as it is behind anyone's back.
  await openFile(page, "bent.obj", almostFlat(0.05));
  await page.getByText("Planarise first?").waitFor();
  await page.context().close();
  await again.context().close();
});

it("a tighter tolerance than the mesh was opened with offers to planarise it, and says why", async () => {
  const page = await site.open();
  await openAdvanced(page);
  await choose(page, "Tolerance", "1 mm/m");
  await openFile(page, "row.obj", almostFlat(0.0005));
  await page.getByRole("button", { name: "Start editing" }).click();
  const planarise = page.getByRole("button", { name: "Planarise" });
  const add = page.getByRole("button", { name: "Add handle" });
  expect(await planarise.count()).toBe(0);
  await choose(page, "Tolerance", "0.000001 mm/m");
  await page.getByText(/up to 0\.\d+ mm\/m, with a tolerance of 0\.000001 mm\/m/).waitFor();
  await page.getByText(/once they are, or once you choose to edit it as it is\.$/).waitFor();
  expect(await add.isDisabled()).toBe(true);
  // Loose again, there is nothing to be made flat.
  await choose(page, "Tolerance", "1 mm/m");
  await expect.poll(() => planarise.count()).toBe(0);
  await choose(page, "Tolerance", "0.000001 mm/m");
  await planarise.click();
  await expect.poll(() => planarise.count()).toBe(0);
  await idle(page);
  expect(worstFlatness(readObj((await exportAs(page, "OBJ")).toString()))).toBeLessThan(1e-6);
  await typeTarget(page, "+10cm");
  await page.context().close();
});

it("variations are found by the weights that are set, and by the usual ones again", async () => {
  const page = await site.open();
  await openAdvanced(page);
  await typeTarget(page, "+1m");
  const found = async (): Promise<number> => {
    await page.getByRole("button", { name: "Find variations" }).click();
    await idle(page);
    const count = await page.getByRole("slider", { name: /^Variation \d+$/ }).count();
    await showTab(page, "Edit");
    return count;
  };
  await page.getByText("Weights of variations").click();
  const ring = page.getByRole("slider", { name: "Rings around the edit" });
  expect(await ring.inputValue()).toBe("2");
  await ring.fill("4");
  const usual = page.getByRole("button", { name: "Default weights" });
  expect(await usual.count()).toBe(1);
  expect(await found()).toBeGreaterThan(0);
  // The design says so, and the page opens such a design.
  const design = (await exportAs(page, "JSON")).toString();
  expect(JSON.parse(design)).toMatchObject({ variations: [{ reach: 4 }] });
  await openFile(page, "again.json", design);
  await idle(page);
  await usual.click();
  expect(await ring.inputValue()).toBe("2");
  await page.context().close();
});

it("settings stay for another sample and a file; Defaults takes them back", async () => {
  const page = await site.open();
  await openAdvanced(page);
  await choose(page, "Tolerance", "0.001 mm/m");
  await exactTargets(page).check();
  await idle(page);
  await choose(page, "Fairness", "Laplacian");
  const expectKept = async (): Promise<void> => {
    await expect.poll(() => field(page, "Tolerance").inputValue()).toBe("0.001");
    expect(await exactTargets(page).isChecked()).toBe(true);
    expect(await field(page, "Fairness").inputValue()).toBe("laplacian");
    // Also to be seen while Advanced is folded.
    expect(
      await page.getByText(/^Not the default: Laplacian, 0\.001 mm\/m, exact targets\./).count(),
    ).toBe(1);
  };
  await page.getByRole("combobox", { name: "Sample" }).selectOption("Dome");
  await idle(page);
  await expectKept();
  await openFile(page, "dome.obj", await exportAs(page, "OBJ"));
  await page.getByRole("button", { name: /Start editing|Not now/ }).click();
  await expectKept();
  await page.getByRole("button", { name: "Undo" }).click();
  await idle(page);
  await expectKept();
  await page.getByRole("button", { name: "Defaults" }).click();
  await idle(page);
  await expect.poll(() => field(page, "Tolerance").inputValue()).toBe("0.000001");
  expect(await exactTargets(page).isChecked()).toBe(false);
  expect(await page.getByText(/^Not the default/).count()).toBe(0);
  await page.context().close();
});
