// SPDX-License-Identifier: MIT
// Cuts of a design: with an edit, a symmetry, groups and a selection, taken back, refused, and in links.
import { expect, it } from "vitest";
import { flatRoof } from "../browser/support/faults.ts";
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
import {
  cutsOf,
  field,
  kind,
  listed,
  panels,
  start,
  strip,
  tool,
  typed,
} from "./support/cutting.ts";
import { site } from "./support/site.ts";

it("the selection fills in the numbers, so that keys alone will do", async () => {
  const page = await site.openVault();
  await openFile(page, "roof.obj", flatRoof(6));
  await page.getByRole("button", { name: "Start editing" }).click();
  await page.getByLabel("3D view").focus();
  for (const key of ["ArrowUp", "Control+ArrowRight"]) await page.keyboard.press(key);
  await page.keyboard.press("k");
  await strip(page).waitFor();
  await idle(page);
  await kind(page, "Strip");
  const side = await field(page).inputValue();
  expect(side).toMatch(/^\d+-\d+$/);
  await field(page).press("Enter");
  await idle(page);
  expect(await cutsOf(page)).toEqual([`strip=${side}`]);
  expect(await panels(page)).toBe(42);
  await page.context().close();
});

it("an edit stays, solved again on the cut mesh; Undo brings back the one before", async () => {
  const page = await site.openVault();
  await typeTarget(page, "+40cm");
  const edited = await obj(page);
  const { faces } = readObj(edited);
  await start(page);
  const handle = Number(
    await page.getByRole("table", { name: "Handles" }).getByRole("rowheader").first().textContent(),
  );
  const panel = faces.findIndex((face) => face.includes(handle));
  await typed(page, "Corner", `${panel}:${handle}`);
  await page.getByText(/^Cut: Corner .*The edit was solved again on the cut mesh\.$/).waitFor();
  expect(await movedCount(page)).toBeGreaterThan(0);
  expect(await panels(page)).toBe(faces.length + 1);
  const cut = await obj(page);
  expect(cut).not.toBe(edited);
  // The same as the design that is opened from its file.
  const other = await site.open();
  await openFile(other, "cut.json", await exportAs(page, "JSON"));
  await other.getByText(/^Verified:/).waitFor();
  await idle(other);
  expect(await obj(other)).toBe(cut);
  await other.context().close();
  await page.getByRole("button", { name: "Undo" }).click();
  await idle(page);
  expect(await obj(page)).toBe(edited);
  await page.context().close();
});

it("each cut is taken back with those after it, and with the handles at points that they added", async () => {
  const page = await site.openVault();
  const whole = await obj(page);
  await start(page);
  await typed(page, "Corner", "0:0");
  await typed(page, "Strip", "30-31@0.25");
  await typed(page, "Refine", "100");
  expect(await listed(page)).toEqual(["Corner 0:0", "Strip 30-31@0.25", "Refine 100"]);
  await page.getByRole("button", { name: "Remove: Strip 30-31@0.25 and the 1 after it" }).click();
  await idle(page);
  expect(await listed(page)).toEqual(["Corner 0:0"]);
  await page.getByText("Removed: Strip 30-31@0.25; Refine 100.").waitFor();
  // A handle at the one point that refining adds inside a panel.
  await typed(page, "Refine", "100");
  const added = readObj(await obj(page)).points.length - 1;
  const state = (page as unknown as { page: { selection: { value: number[] } } }).page;
  state.selection.value = [added];
  await typeTarget(page, "+5cm");
  const edited = await obj(page);
  await page.getByRole("button", { name: "Remove: Refine 100" }).click();
  await idle(page);
  const gone = `Point ${added} is gone with its panels, and its handle is removed.`;
  await page.getByText(gone).waitFor();
  expect(await listed(page)).toEqual(["Corner 0:0"]);
  await page.getByRole("button", { name: "Undo" }).click();
  await idle(page);
  expect(await obj(page)).toBe(edited);
  expect(await listed(page)).toEqual(["Corner 0:0", "Refine 100"]);
  for (const name of ["Undo", "Undo", "Undo"]) {
    await page.getByRole("button", { name }).click();
    await idle(page);
  }
  expect(await listed(page)).toEqual(["Corner 0:0"]);
  await page.getByRole("button", { name: "Remove: Corner 0:0" }).click();
  await idle(page);
  expect(await listed(page)).toEqual([]);
  expect(await obj(page)).toBe(whole);
  await page.context().close();
});

it("what the core refuses is its own sentence, and nothing is cut", async () => {
  const page = await site.openVault();
  const whole = await obj(page);
  await start(page);
  await kind(page, "Split");
  await field(page).fill("900:1,2");
  await strip(page)
    .getByText("split=900:1,2: there is no panel 900: panels are 0 to 195.")
    .waitFor();
  await field(page).press("Enter");
  await idle(page);
  await strip(page)
    .getByText(/there is no panel 900/)
    .waitFor();
  await field(page).fill("a saw");
  await strip(page)
    .getByText(/^"split=asaw" is not of the form/)
    .waitFor();
  expect(await obj(page)).toBe(whole);
  await page.context().close();
});

it("a mesh that is not flat is made flat first", async () => {
  const page = await site.openVault();
  await openFile(page, "bent.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0.2\nv 0 1 0\nf 1 2 3 4\n");
  expect(await tool(page).isDisabled()).toBe(true);
  expect(await tool(page).getAttribute("title")).toMatch(/First planarise it, or edit it as it is/);
  await page.context().close();
});

it("a link holds the cuts", async () => {
  const page = await site.openVault();
  await typeTarget(page, "+40cm");
  await start(page);
  await typed(page, "Strip", "30-31@0.25");
  const file = await obj(page);
  await page.getByRole("button", { name: "Share" }).click();
  const link = await page.getByRole("textbox", { name: "Link" }).inputValue();
  await page.context().close();
  const other = await site.open({}, new URL(link).hash);
  await expect.poll(() => other.getByText(/Verified/).count()).toBe(1);
  expect(await obj(other)).toBe(file);
  await start(other);
  expect(await listed(other)).toEqual(["Strip 30-31@0.25"]);
  await other.context().close();
});

it("groups made here keep what becomes of their panels, and have it back after Undo", async () => {
  const page = await site.openVault();
  await openFile(page, "roof.obj", flatRoof(6));
  await page.getByRole("button", { name: "Start editing" }).click();
  const { selectedPanel } = (page as unknown as { page: { selectedPanel: { value: number } } })
    .page;
  const section = page.getByRole("region", { name: "Groups" });
  for (const panel of [3, 33]) {
    selectedPanel.value = panel;
    await section.getByRole("button", { name: "Group panels" }).click();
  }
  const members = async (): Promise<string[]> => {
    const runs = (await obj(page)).split(/^(?=[og] )/m).slice(1);
    const counts = runs.map((run) => [run.split("\n")[0], run.match(/^f /gm)?.length ?? 0]);
    return counts.filter(([name]) => name !== "g ").map(([name, count]) => `${name}: ${count}`);
  };
  expect(await members()).toEqual(["o Group 1: 1", "o Group 2: 1"]);
  await start(page);
  await typed(page, "Refine", "3");
  // The first part keeps the number, the three others stand behind all panels.
  expect(await members()).toEqual(["o Group 1: 1", "o Group 2: 1", "o Group 1: 3"]);
  await typed(page, "Trim", "0,-1,0,-2.5");
  expect(await members()).toEqual(["o Group 2: 1"]);
  for (const _ of ["trim", "refine"]) {
    await page.getByRole("button", { name: "Undo" }).click();
    await idle(page);
  }
  expect(await members()).toEqual(["o Group 1: 1", "o Group 2: 1"]);
  await page.context().close();
});

it("under a symmetry the images of a cut are cut with it, in one step", async () => {
  const page = await site.open();
  await openRule(page, "Symmetry");
  await page.getByRole("button", { name: "All that it has" }).click();
  await idle(page);
  const whole = await panels(page);
  await start(page);
  await typed(page, "Corner", "0:0@0.5");
  expect(await listed(page)).toHaveLength(4);
  await page.getByText("Cut: Corner 0:0@0.5 and 3 images.").waitFor();
  expect(await panels(page)).toBe(whole + 4);
  await typeTarget(page, "+0.4");
  expect(await movedCount(page)).toBeGreaterThan(0);
  for (const _ of ["its target", "the handle", "the cut"]) {
    await page.getByRole("button", { name: "Undo" }).click();
    await idle(page);
  }
  expect(await listed(page)).toEqual([]);
  expect(await panels(page)).toBe(whole);
  await page.context().close();
});

it("a selected point says the level of a trim, which is turned round", async () => {
  const page = await site.openVault();
  await openFile(page, "roof.obj", flatRoof(6));
  await page.getByRole("button", { name: "Start editing" }).click();
  const { selection } = (page as unknown as { page: { selection: { value: number[] } } }).page;
  selection.value = [10];
  await start(page);
  await kind(page, "Trim");
  await expect.poll(() => field(page).inputValue()).toBe("0,0,1,0.3");
  await strip(page).getByRole("button", { name: "Other side" }).click();
  await expect.poll(() => field(page).inputValue()).toBe("0,0,-1,-0.3");
  await field(page).press("Enter");
  await idle(page);
  expect(await panels(page)).toBe(18);
  // Through three points of one side, upright here.
  selection.value = [6, 13, 20];
  await expect.poll(() => field(page).inputValue()).toMatch(/^-?1,0,0,-?6$/);
  await page.context().close();
});
