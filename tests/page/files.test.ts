// SPDX-License-Identifier: MIT
// Files into the page by every door, what it says about them, and a picture out of it.
import type { Page } from "playwright-core";
import { describe, expect, it } from "vitest";
import { flatRoof } from "../browser/support/faults.ts";
import { exportAs, idle, openFile, pickFile, status } from "../browser/support/page.ts";
import { site } from "./support/site.ts";

/** Two triangles, a flat hexagon and a quad that is out of flat, in two parts. */
const MIXED = [
  ..."0 0 0,1000 0 0,1000 1000 100,0 1000 0,2000 0 0,500 -800 0".split(","),
  ..."9000 0 0,9500 0 0,9750 433 0,9500 866 0,9000 866 0,8750 433 0".split(","),
]
  .map((point) => `v ${point}`)
  .concat("f 1 2 3 4", "f 2 5 3", "f 1 6 2", "f 7 8 9 10 11 12", "")
  .join("\n");

async function reportOf(page: Page, name: string): Promise<string> {
  return (await page.getByRole("region", { name }).innerText()).replace(/\s+/g, " ");
}

/** The corners of each panel, by their coordinates. */
type Soup = readonly (readonly string[])[];

/** The panels of an OBJ file, some of them the other way round. */
function panelsApart(obj: string, isTurned = (panel: number): boolean => panel % 2 === 1): Soup {
  const points = [...obj.matchAll(/^v (.*)$/gm)].map(([, point]) => point ?? "");
  return [...obj.matchAll(/^f (.*)$/gm)].map(([, face], panel) => {
    const corners = (face ?? "").split(" ").map((v) => points[Number(v) - 1] ?? "");
    return isTurned(panel) ? corners.reverse() : corners;
  });
}

const asObj = (soup: Soup): string =>
  [
    ...soup.flat().map((point) => `v ${point}`),
    ...soup.map((face, f) => `f ${face.map((_, k) => 4 * f + k + 1).join(" ")}`),
    "",
  ].join("\n");

const asPly = (soup: Soup): string =>
  [
    `ply\nformat ascii 1.0\nelement vertex ${soup.flat().length}`,
    "property double x\nproperty double y\nproperty double z",
    `element face ${soup.length}\nproperty list uchar int vertex_indices\nend_header`,
    ...soup.flat(),
    ...soup.map((face, f) => `4 ${face.map((_, k) => 4 * f + k).join(" ")}`),
    "",
  ].join("\n");

/** A panel from its first corner in the order of words, the way round that it has. */
function upright(face: readonly string[]): readonly string[] {
  const first = face.indexOf(face.toSorted()[0] ?? "");
  return [...face.slice(first), ...face.slice(0, first)];
}

describe("a mesh opens", () => {
  it("by keyboard alone, also in OFF", async () => {
    const page = await site.openVault();
    const off = "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";
    await pickFile(page, "one.off", off, () => page.keyboard.press("Control+o"));
    await expect.poll(() => status(page)).toMatch(/0 of 4 points/);
    await page.getByRole("button", { name: "Start editing" }).focus();
    await page.keyboard.press("Enter");
    expect(await page.getByRole("region", { name: "one.off" }).count()).toBe(0);
    await page.context().close();
  });

  it("as quads again, where a program wrote triangles; undo has the triangles", async () => {
    const page = await site.openVault();
    const triangles = flatRoof(6).replace(
      /^f (\d+) (\d+) (\d+) (\d+)$/gm,
      "f $1 $2 $3\nf $1 $3 $4",
    );
    await openFile(page, "split.obj", triangles);
    expect(await reportOf(page, "split.obj")).toMatch(/72 triangles/);
    await page.getByRole("button", { name: "Join triangles into quads" }).click();
    await expect.poll(() => reportOf(page, "split.obj")).toMatch(/Panels 36 quads/);
    expect(await page.getByText("36 quads of two triangles each.").count()).toBe(1);
    expect(await page.getByRole("button", { name: "Join triangles into quads" }).count()).toBe(0);
    expect((await exportAs(page, "OBJ")).toString().match(/^f .*$/gm)).toEqual(
      flatRoof(6).match(/^f .*$/gm),
    );
    await page.getByRole("button", { name: "Undo" }).click();
    await idle(page);
    expect((await exportAs(page, "OBJ")).toString().match(/^f .*$/gm)?.length).toBe(72);
    await page.context().close();
  });

  it.each(["obj", "ply"])(
    "with points of its own for each panel, every second one turned over, and is made whole: %s",
    async (format) => {
      const page = await site.openVault();
      const soup = panelsApart(flatRoof(6));
      await openFile(page, `soup.${format}`, format === "obj" ? asObj(soup) : asPly(soup));
      expect(await reportOf(page, `soup.${format}`)).toMatch(/Points 144 .*Separate parts 36/);
      const opened = await exportAs(page, "OBJ");
      await page.getByRole("button", { name: "Join points" }).click();
      await expect.poll(() => reportOf(page, `soup.${format}`)).toMatch(/Points 49 .*parts 1 /);
      expect(await page.getByText("95 points were joined with another one.").count()).toBe(1);
      expect(await page.getByRole("button", { name: "Join points" }).count()).toBe(0);
      await page.getByRole("button", { name: "Turn panels to agree" }).click();
      await expect.poll(() => reportOf(page, `soup.${format}`)).not.toMatch(/opposite/);
      expect(await page.getByText("Neighbouring panels agree.").count()).toBe(1);
      expect(await page.getByRole("button", { name: "Turn panels to agree" }).count()).toBe(0);
      const whole = panelsApart((await exportAs(page, "OBJ")).toString(), () => false);
      expect(whole.map(upright)).toEqual(panelsApart(flatRoof(6), () => false).map(upright));
      for (let step = 0; step < 2; ++step) {
        await page.getByRole("button", { name: "Undo" }).click();
        await idle(page);
      }
      expect(await exportAs(page, "OBJ")).toEqual(opened);
      await page.context().close();
    },
  );

  it("with a report of what it is, in the unit that its numbers are in", async () => {
    const page = await site.openVault();
    await openFile(page, "mixed.obj", MIXED);
    const report = await reportOf(page, "mixed.obj");
    expect(report).toMatch(/Points 12/);
    expect(report).toMatch(/2 triangles, 1 quads, 1 hexagons/);
    expect(report).toMatch(/Separate parts 2/);
    expect(report).toMatch(/Non-manifold edges 0/);
    expect(report).toMatch(/Planarise first\?/);
    const unit = page.getByRole("combobox", { name: "Unit of the file" });
    const worst = async (): Promise<number> =>
      Number(/Worst panel ([\d.]+) mm out of flat/.exec(await reportOf(page, "mixed.obj"))?.[1]);
    await unit.selectOption("mm");
    await expect.poll(worst).toBeLessThan(100);
    const inMillimetres = await worst();
    expect(inMillimetres).toBeGreaterThan(10);
    expect(inMillimetres).toBeLessThan(100);
    await unit.selectOption("cm");
    await expect.poll(async () => (await worst()) / inMillimetres).toBeCloseTo(10, 1);
    await page.getByRole("button", { name: "Planarise", exact: true }).last().click();
    await idle(page);
    expect(await status(page)).toMatch(/worst panel 0\.0000 mm/);
    await page.context().close();
  });

  it("not if three panels share an edge: the sentence names the line and the panels", async () => {
    const page = await site.openVault();
    await openFile(page, "fan.obj", `${MIXED}v 500 500 900\nf 1 2 13\n`);
    expect(await page.getByRole("alert").textContent()).toMatch(
      /line \d+: the edge between vertices 1 and 2 is shared by 3 faces, among them \d+ and \d+ \(from 1\)/,
    );
    expect(await status(page)).toMatch(/0 of 225 points/);
    await page.context().close();
  });
});

it("a mesh with Y up, which is said to be likely, is turned to the bit, as one step", async () => {
  const page = await site.openVault();
  const lying = flatRoof(6);
  const standing = lying.replace(
    /^v (\S+) (\S+) (\S+)$/gm,
    (_, x, y, z) => `v ${x} ${z} ${Number(y) === 0 ? y : `-${y}`}`,
  );
  await openFile(page, "standing.obj", standing);
  expect(await reportOf(page, "standing.obj")).toMatch(/Most panels face along Y/);
  const file = (await exportAs(page, "OBJ")).toString().match(/^v .*$/gm);
  await page.getByLabel("Up in the file").selectOption("y");
  await expect.poll(() => reportOf(page, "standing.obj")).not.toMatch(/Most panels face/);
  const own = (await exportAs(page, "OBJ")).toString().match(/^v .*$/gm);
  expect(own?.map((line) => line.split(" ").slice(1).map(Number))).toEqual(
    lying.match(/^v .*$/gm)?.map((line) => line.split(" ").slice(1).map(Number)),
  );
  await page.getByRole("button", { name: "Undo" }).click();
  await idle(page);
  expect((await exportAs(page, "OBJ")).toString().match(/^v .*$/gm)).toEqual(file);
  await page.context().close();
});

it("a file that is in millimetres by its size is asked whether it is", async () => {
  const page = await site.open();
  const roof = flatRoof(6).replace(/^v (\S+) (\S+) (\S+)$/gm, (_, ...at: string[]) =>
    ["v", ...at.slice(0, 3).map((x) => 3000 * Number(x))].join(" "),
  );
  await openFile(page, "roof.obj", roof);
  await page.getByText(/^Size [\d,]+ × [\d,]+ × [\d,.]+: millimetres\?/).waitFor();
  await page.getByRole("button", { name: "Yes, millimetres" }).click();
  expect(await page.getByLabel("Unit of the file").inputValue()).toBe("mm");
  expect(await page.getByText(/millimetres\?/).count()).toBe(0);
  expect(await reportOf(page, "roof.obj")).toMatch(/Size\s*[\d,]+ × [\d,]+ × [\d,.]+ mm/);
  await page.context().close();
});
