// SPDX-License-Identifier: MIT
// What docs/fabrication.md says of large meshes in the page: from the press on a button to the finished
// file, and the longest time meanwhile in which the page answers nothing, on the built site.
//   bash .tools/start/build.sh && node .tools/measure/shop-pace.mjs [panels along a side] [FOLDER to keep the files in]
// Wall-clock time, so on a machine that does nothing else.
import { mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import rhino3dm from "rhino3dm/rhino3dm.module.js";
import { lift, openBrowser, openPage, settled } from "../page/page.mjs";
import { quadRoof } from "./shop-roof.mjs";

const SIDE = Number(process.argv[2] ?? 100);
const CIRCLES = SIDE * SIDE;
const FOLDER = process.argv[3] ?? mkdtempSync(join(tmpdir(), "planish-shop-pace-"));

const roof = quadRoof(SIDE);

/** Another program's model: the panels as polylines, and `count` circles of ten metres beside them. */
async function foreignModel(count) {
  const wasmBinary = readFileSync(createRequire(import.meta.url).resolve("rhino3dm/rhino3dm.wasm"));
  const rhino = await rhino3dm({ wasmBinary });
  const file = new rhino.File3dm();
  const add = (curve) => {
    const attributes = new rhino.ObjectAttributes();
    file.objects().addCurve(curve, attributes);
    attributes.delete();
    curve.delete();
  };
  for (const face of roof.faces) {
    const list = new rhino.Point3dList(5);
    for (const corner of [...face, face[0]]) list.add(...roof.points[corner]);
    add(new rhino.PolylineCurve(list));
    list.delete();
  }
  for (let k = 0; k < count; ++k) add(new rhino.Circle([k % 200, k / 200, 0], 10).toNurbsCurve());
  return file.toByteArray();
}

/** Notes the longest stretch in which the page's own thread gets to nothing else, milliseconds. */
const watchGaps = () => {
  let last = performance.now();
  window.longestGap = 0;
  const look = () => {
    const now = performance.now();
    window.longestGap = Math.max(window.longestGap, now - last);
    last = now;
    setTimeout(look, 4);
  };
  look();
};

/** `act` until it resolves: how long, and the longest gap. */
async function timed(page, what, act) {
  await page.evaluate("window.longestGap = 0");
  const begun = performance.now();
  const result = await act();
  const seconds = (performance.now() - begun) / 1000;
  await page.waitForTimeout(1500);
  const gap = await page.evaluate("window.longestGap");
  console.log(`${what}: ${seconds.toFixed(1)} s, longest gap of the page ${gap.toFixed(0)} ms`);
  return result;
}

async function saved(page, press, name) {
  const download = page.waitForEvent("download", { timeout: 600_000 });
  await press();
  const path = join(FOLDER, name);
  await (await download).saveAs(path);
  return path;
}

const megabytes = (path) => `${(statSync(path).size / 1e6).toFixed(1)} MB`;

async function openFile(page, path) {
  const chooser = page.waitForEvent("filechooser");
  await page.getByRole("button", { name: "Open file" }).click();
  await (await chooser).setFiles(path);
}

async function exportPackage(page, what, sheet) {
  await page.getByRole("button", { name: "Export" }).click();
  await page.getByRole("button", { name: "Cutting package…" }).click();
  const dialog = page.getByRole("dialog", { name: "Cutting package" });
  if (sheet) {
    await dialog.getByLabel("Sheet width").fill("6000");
    await dialog.getByLabel("Sheet height").fill("3000");
  }
  await settled(page);
  await page.waitForTimeout(8000); // the preview
  const press = () => dialog.getByRole("button", { name: "Save package" }).click();
  const path = await timed(page, what, () => saved(page, press, "package.zip"));
  console.log(`  ${megabytes(path)}; ${await dialog.getByText(/^Saved:/).textContent()}`);
  await page.keyboard.press("Escape");
}

const site = await openBrowser();
const page = await openPage(site, { viewport: { width: 1280, height: 800 } }, watchGaps);
const mesh = join(FOLDER, "roof.obj");
writeFileSync(mesh, roof.obj);
await timed(page, `${SIDE * SIDE} panels opened as OBJ`, async () => {
  await openFile(page, mesh);
  await page.getByRole("button", { name: "Start editing" }).click({ timeout: 120_000 });
});
await settled(page);
await lift(page, `${0.12 * SIDE + 0.4}`);
await exportPackage(page, "package without sheets", false);
await exportPackage(page, "package with sheets of 6 × 3 m", true);
const press = async () => {
  await page.getByRole("button", { name: "Export" }).click();
  await page.getByRole("button", { name: "3DM" }).click();
};
const model = await timed(page, "3DM saved", () => saved(page, press, "roof.3dm"));
console.log(`  ${megabytes(model)}`);
const status = page.getByRole("status");
console.log(`  ${await status.textContent()}`);
await page.getByRole("combobox", { name: "Sample" }).selectOption({ index: 1 });
await settled(page);
await timed(page, "3DM opened as the design", async () => {
  await openFile(page, model);
  await page.getByText(/^Verified/).waitFor({ timeout: 300_000 });
});
const foreign = join(FOLDER, "foreign.3dm");
writeFileSync(foreign, await foreignModel(CIRCLES));
console.log(`${SIDE * SIDE} polylines and ${CIRCLES} circles: ${megabytes(foreign)}`);
await timed(page, "3DM of polylines opened, with context", async () => {
  await openFile(page, foreign);
  await page.getByRole("heading", { name: "foreign.3dm" }).waitFor({ timeout: 300_000 });
});
console.log(`  ${await page.getByText(/objects shown as context/).textContent()}`);
await site.close();
if (!process.argv[3]) rmSync(FOLDER, { recursive: true });
