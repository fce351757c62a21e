// SPDX-License-Identifier: MIT
// The page and the command line write the same cutting package, byte for byte.
import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { afterAll, beforeAll, expect, it } from "vitest";
import { loadPlanish, loadShop } from "./support/planish.ts";

const CLI = new URL("../../build/native/planish", import.meta.url).pathname;

let folder: string;
beforeAll(() => {
  folder = mkdtempSync(join(tmpdir(), "planish-package-"));
});
afterAll(() => rmSync(folder, { recursive: true }));

const digest = (bytes: Uint8Array): string => createHash("sha256").update(bytes).digest("hex");

it.each(["vault", "dome", "freeform", "hex", "trihex"])("of an edited %s", async (sample) => {
  const [planish, shop] = [await loadPlanish(), await loadShop()];
  const session = new planish.Session();
  expect(session.openSample(sample, 12)).toBe("");
  const base = session.write("obj");
  const middle = Math.floor(session.basePositions().length / 6);
  const [x = 0, y = 0, z = 0] = session.basePositions().subarray(3 * middle);
  const handle = Float64Array.of(middle, x, y, z + 0.3);
  expect(session.edit(planish.EditMode.solve, handle, new Int32Array(), 0, 1)).toBe("");
  writeFileSync(join(folder, "base.obj"), base);
  writeFileSync(join(folder, "design.obj"), session.write("obj"));
  const mesh = [
    session.basePositions(),
    session.faceOffsets(),
    session.faceVertices(),
    session.moved(),
    session.movedPositions(),
  ] as const;
  const options = {
    name: "design",
    modelUnit: "m",
    unit: "mm",
    gap: 6,
    thickness: 8,
    sheetWidth: 6000,
    sheetHeight: 3000,
    remakeOnly: true,
  };
  const written = shop.cuttingPackage(...mesh, options);
  expect(written.problem).toBe("");
  const { remake, counts } = JSON.parse(written.header);
  expect(remake.outline).toBeGreaterThan(0);
  expect(counts.drawn).toBe(remake.outline + remake.bevel);
  const flags = "--against base.obj --gap 6 --thickness 8 --sheet 6000x3000 --scope remake";
  const words = `panels design.obj -o design.zip ${flags}`;
  execFileSync(CLI, words.split(" "), { cwd: folder });
  expect(digest(written.zip)).toBe(digest(readFileSync(join(folder, "design.zip"))));
  session.delete();
});

it.each([
  { gap: 6, sheetWidth: 6000, sheetHeight: 3000, remakeOnly: false },
  { gap: 300, sheetWidth: 1500, sheetHeight: 900, remakeOnly: true },
  { gap: 0, sheetWidth: 0, sheetHeight: 0, remakeOnly: true },
])("the preview says what the package will: %o", async (asked) => {
  const [planish, shop] = [await loadPlanish(), await loadShop()];
  const session = new planish.Session();
  expect(session.openSample("freeform", 14)).toBe("");
  const [x = 0, y = 0, z = 0] = session.basePositions().subarray(300);
  const handle = Float64Array.of(100, x, y, z + 0.3);
  expect(session.edit(planish.EditMode.solve, handle, new Int32Array(), 0, 1)).toBe("");
  const mesh = [
    session.basePositions(),
    session.faceOffsets(),
    session.faceVertices(),
    session.moved(),
    session.movedPositions(),
  ] as const;
  const options = { name: "", modelUnit: "m", unit: "mm", thickness: 0, ...asked };
  const preview = shop.cuttingPreview(...mesh, options, -1, true);
  const { counts, remake, sheets, ...header } = JSON.parse(
    shop.cuttingPackage(...mesh, options).header,
  );
  expect([preview.panels, preview.drawn]).toEqual([counts.panels, counts.drawn]);
  expect([preview.outline, preview.bevel]).toEqual([remake.outline, remake.bevel]);
  expect([preview.flatness, preview.vanished]).toEqual([header.flatness_mm_per_m, header.vanished]);
  expect([preview.sheets, preview.usedFraction, preview.oversize]).toEqual(
    sheets ? [sheets.count, sheets.used_fraction, sheets.oversize] : [0, 0, []],
  );
  expect(preview.map).toMatch(/^<svg/);
  expect(preview.drawing).toContain(preview.shown);
  session.delete();
});

it("refuses by name what is wrong, as a sentence", async () => {
  const [planish, shop] = [await loadPlanish(), await loadShop()];
  const session = new planish.Session();
  expect(session.openSample("vault", 4)).toBe("");
  const { problem, zip } = shop.cuttingPackage(
    session.basePositions(),
    session.faceOffsets(),
    session.faceVertices(),
    new Int32Array(),
    new Float64Array(),
    {
      name: "vault",
      modelUnit: "m",
      unit: "mm",
      gap: 0,
      thickness: 0,
      sheetWidth: 100,
      sheetHeight: 0,
      remakeOnly: false,
    },
  );
  expect(problem).toMatch(/^The cutting package was refused: sheet .+\.$/);
  expect(zip).toBeUndefined();
  session.delete();
});
