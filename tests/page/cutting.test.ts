// SPDX-License-Identifier: MIT
// The tool Cut: panels are parted by clicks in the view, by numbers and by the selection; each cut is a
// step of the history, before the edit, and goes along in links and saved designs.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { flatRoof } from "../browser/support/faults.ts";
import { readObj } from "../browser/support/obj.ts";
import { exportAs, idle, movedCount, obj, openFile, typeTarget } from "../browser/support/page.ts";
import { type Place, viewBox } from "../browser/support/view.ts";
import { site } from "./support/site.ts";

const ROOMY = { viewport: { width: 1440, height: 900 } };

const tool = (page: Page) => page.getByRole("button", { name: "Cut panels" });

const strip = (page: Page) => page.getByRole("region", { name: "Cut panels" });

const kind = (page: Page, name: string) =>
  strip(page).getByRole("button", { name, exact: true }).click();

const field = (page: Page) => strip(page).getByRole("textbox").first();

const listed = async (page: Page): Promise<string[]> =>
  Promise.all(
    (await page.getByRole("list", { name: "Cuts made" }).getByRole("listitem").all()).map(
      async (item) => ((await item.textContent()) ?? "").replace(/(Take back|Back to before)$/, ""),
    ),
  );

async function start(page: Page): Promise<void> {
  await tool(page).click();
  await strip(page).waitFor();
  await idle(page);
}

async function typed(page: Page, name: string, numbers: string): Promise<void> {
  await kind(page, name);
  await field(page).fill(numbers);
  await field(page).press("Enter");
  await idle(page);
}

const panels = async (page: Page): Promise<number> => readObj(await obj(page)).faces.length;

const cutsOf = async (page: Page): Promise<string[]> =>
  JSON.parse((await exportAs(page, "JSON")).toString()).cuts ?? [];

/** Seen from above, where panel k of a flat roof of n × n panels can be counted. */
async function roofFromAbove(
  n: number,
): Promise<{ page: Page; at: (x: number, y: number) => Place }> {
  const page = await site.openVault(ROOMY);
  await openFile(page, "roof.obj", flatRoof(n));
  await page.getByRole("button", { name: "Start editing" }).click();
  await page.getByRole("button", { name: "Top" }).click();
  await idle(page);
  const marks = async (): Promise<Place[]> => {
    const all = await page.locator(".marker.selected:not([hidden])").all();
    return Promise.all(
      all.map(async (one) => {
        const box = await one.boundingBox();
        if (!box) throw new Error("no mark");
        return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
      }),
    );
  };
  await page.getByRole("button", { name: "Select in a box" }).click();
  const view = await viewBox(page);
  await page.mouse.move(view.x + 1, view.y + 1);
  await page.mouse.down();
  await page.mouse.move(view.x + view.width - 1, view.y + view.height - 1, { steps: 3 });
  await page.mouse.up();
  await expect.poll(async () => (await marks()).length).toBe((n + 1) ** 2);
  const seen = await marks();
  await page.keyboard.press("Escape");
  const [xs, ys] = [seen.map(({ x }) => x), seen.map(({ y }) => y)];
  const [left, right] = [Math.min(...xs), Math.max(...xs)];
  const [top, bottom] = [Math.min(...ys), Math.max(...ys)];
  // Points of the roof are numbered along x, then along y.
  const at = (x: number, y: number): Place => ({
    x: left + ((right - left) * x) / n,
    y: bottom - ((bottom - top) * y) / n,
  });
  return { page, at };
}

it("a panel is split by two clicks, a strip and a corner by one; each is one step", async () => {
  const { page, at } = await roofFromAbove(6);
  const before = await obj(page);
  await start(page);
  const click = async (x: number, y: number): Promise<void> => {
    const { x: left, y: top } = at(x, y);
    await page.mouse.click(left, top);
    await idle(page);
  };
  // Two opposite corners of the panel in the first column and row.
  await click(0.02, 0.02);
  await strip(page).getByText("Click the other end on the same panel.").waitFor();
  await click(0.98, 0.98);
  await expect.poll(() => listed(page)).toEqual(["Split 0:0,8"]);
  expect(await panels(page)).toBe(37);
  await page.getByText("Cut: Split 0:0,8.").waitFor();
  // A quarter of the way along a side.
  await kind(page, "Strip");
  await click(3.25, 4.03);
  await expect
    .poll(async () => (await listed(page)).at(-1))
    .toMatch(/^Strip (31-32@0.25|32-31@0.75)$/);
  expect(await panels(page)).toBe(43);
  await kind(page, "Corner");
  await click(5.1, 5.1);
  await expect.poll(async () => (await listed(page)).at(-1)).toBe("Corner 35:40");
  expect(await panels(page)).toBe(44);
  await kind(page, "Refine");
  await click(5.5, 0.5);
  await expect.poll(async () => (await listed(page)).at(-1)).toBe("Refine 5");
  expect(await panels(page)).toBe(47);
  // Each is one step.
  for (const count of [44, 43, 37, 36]) {
    await page.getByRole("button", { name: "Undo" }).click();
    await idle(page);
    expect(await panels(page)).toBe(count);
  }
  expect(await obj(page)).toBe(before);
  expect(await movedCount(page)).toBe(0);
  await page.context().close();
});

it("what would be cut is tried out under the pointer, and nothing is made of it", async () => {
  const { page, at } = await roofFromAbove(6);
  await start(page);
  await kind(page, "Corner");
  const { x, y } = at(1.1, 1.1);
  await page.mouse.move(x, y);
  await idle(page);
  // The form leaves what is typed alone.
  expect(await field(page).inputValue()).toBe("");
  expect(await strip(page).getByRole("button", { name: "Cut", exact: true }).isDisabled()).toBe(
    false,
  );
  expect(await panels(page)).toBe(36);
  // What cannot be is said before it is asked for.
  await kind(page, "Split");
  const first = at(1.02, 1.02);
  await page.mouse.click(first.x, first.y);
  const next = at(1.98, 1.02);
  await page.mouse.move(next.x, next.y);
  await strip(page).getByText("points 8 and 9 are neighbours on the outline of panel 7").waitFor();
  await page.mouse.click(next.x, next.y);
  await idle(page);
  await page
    .getByRole("alert")
    .getByText(/points 8 and 9 are neighbours/)
    .waitFor();
  expect(await panels(page)).toBe(36);
  await page.context().close();
});

it("Escape takes the first place back, then leaves the tool; clicks select again", async () => {
  const { page, at } = await roofFromAbove(6);
  await start(page);
  const corner = at(1.02, 1.02);
  await page.mouse.click(corner.x, corner.y);
  await strip(page).getByText("Click the other end on the same panel.").waitFor();
  await page.getByLabel("3D view").press("Escape");
  await strip(page).getByText("Click two corners or sides of one panel.").waitFor();
  await page.getByLabel("3D view").press("Escape");
  await expect.poll(() => strip(page).count()).toBe(0);
  expect(await tool(page).getAttribute("aria-pressed")).toBe("false");
  await page.mouse.click(at(1, 1).x, at(1, 1).y);
  await expect.poll(() => page.locator(".marker.selected:not([hidden])").count()).toBe(1);
  // From the other door and a field of it, too.
  await page.getByRole("button", { name: "Start cutting" }).click();
  await strip(page).waitFor();
  await field(page).press("Escape");
  await expect.poll(() => strip(page).count()).toBe(0);
  expect(await panels(page)).toBe(36);
  await page.context().close();
});

it.each([
  ["Split", "7:8,15-16@0.5", 37, "split=7:8,15-16@0.5"],
  ["Strip", "8-9", 42, "strip=8-9"],
  ["Corner", "7:8@0.25", 37, "corner=7:8@0.25"],
  ["Refine", "7, 8", 42, "refine=7,8"],
  ["Trim", "0,1,0,2.5", 18, "trim=0,1,0,2.5"],
] as const)("%s by numbers alone", async (name, numbers, count, text) => {
  const page = await site.openVault();
  await openFile(page, "roof.obj", flatRoof(6));
  await page.getByRole("button", { name: "Start editing" }).click();
  await start(page);
  await typed(page, name, numbers);
  expect(await panels(page)).toBe(count);
  expect(await cutsOf(page)).toEqual([text]);
  await page.context().close();
});

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

it("each cut is taken back with those after it, unless a handle is at a point that they added", async () => {
  const page = await site.openVault();
  const whole = await obj(page);
  await start(page);
  await typed(page, "Corner", "0:0");
  await typed(page, "Strip", "30-31@0.25");
  await typed(page, "Refine", "100");
  expect(await listed(page)).toEqual(["Corner 0:0", "Strip 30-31@0.25", "Refine 100"]);
  await page
    .getByRole("button", { name: "Take back: Strip 30-31@0.25 and the 1 after it" })
    .click();
  await idle(page);
  expect(await listed(page)).toEqual(["Corner 0:0"]);
  await page.getByText("Taken back: Strip 30-31@0.25; Refine 100.").waitFor();
  // A handle at the one point that refining adds inside a panel.
  await typed(page, "Refine", "100");
  const added = readObj(await obj(page)).points.length - 1;
  const state = (page as unknown as { page: { selection: { value: number[] } } }).page;
  state.selection.value = [added];
  await typeTarget(page, "+5cm");
  const edited = await obj(page);
  await page.getByRole("button", { name: "Take back: Refine 100" }).click();
  await idle(page);
  await page
    .getByRole("alert")
    .getByText(new RegExp(`\\b${added}\\b`))
    .waitFor();
  expect(await obj(page)).toBe(edited);
  expect(await listed(page)).toEqual(["Corner 0:0", "Refine 100"]);
  for (const name of ["Undo", "Undo", "Undo"]) {
    await page.getByRole("button", { name }).click();
    await idle(page);
  }
  expect(await listed(page)).toEqual(["Corner 0:0", "Strip 30-31@0.25", "Refine 100"].slice(0, 1));
  await page.getByRole("button", { name: "Take back: Corner 0:0" }).click();
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
    .getByText("split=900:1,2: there is no panel 900: panels are 0 to 399.")
    .waitFor();
  await field(page).press("Enter");
  await idle(page);
  await page
    .getByRole("alert")
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
  expect(await tool(page).getAttribute("title")).toMatch(/Make it flat first/);
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

it("a finger sees first what it cuts, and cuts with its next tap there", async () => {
  const { page, at } = await roofFromAbove(6);
  await start(page);
  await kind(page, "Strip");
  const tap = async ({ x, y }: Place): Promise<void> => {
    await page.evaluate(
      ({ x: clientX, y: clientY }) => {
        const canvas = document.querySelector("canvas");
        for (const type of ["pointerdown", "pointerup", "pointerleave"])
          canvas?.dispatchEvent(
            new PointerEvent(type, {
              bubbles: true,
              cancelable: true,
              pointerType: "touch",
              isPrimary: true,
              pointerId: 2,
              clientX,
              clientY,
            }),
          );
      },
      { x, y },
    );
    await idle(page);
  };
  await tap(at(3.5, 4.05));
  expect(await panels(page)).toBe(36);
  expect(await strip(page).getByRole("button", { name: "Cut", exact: true }).isDisabled()).toBe(
    false,
  );
  // Elsewhere: that is shown instead.
  await tap(at(1.5, 2.05));
  expect(await panels(page)).toBe(36);
  await tap(at(1.5, 2.05));
  expect(await panels(page)).toBe(42);
  expect(await listed(page)).toHaveLength(1);
  expect((await listed(page))[0]).toMatch(/^Strip (15-16|16-15)$/);
  await page.context().close();
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
  await page.locator("summary", { hasText: "Symmetry" }).click();
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
