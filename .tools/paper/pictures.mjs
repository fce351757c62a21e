// SPDX-License-Identifier: MIT
// docs/pictures/figure-N.png: every scene opened from its own link in a real browser, its view put
// side by side with the others of its figure. A scene that does not say "Verified" is an error.
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { openBrowser, settled } from "../page/page.mjs";
import { barChart, residualChart } from "./charts.mjs";
import { ROOT, report } from "./command.mjs";
import { editWords } from "./recipes.mjs";

const VIEW = { width: 760, height: 520 };
/** Only the model: the page around it is in the README. */
const BARE = `.inspector, .legend, .views, .top-bar, .status-line, .drag-tools, .hint, .marker.pin { display: none !important }
  .app, .work { grid-template: minmax(0, 1fr) / minmax(0, 1fr) !important }`;

async function pageAt(site, hash) {
  const page = await (await site.browser.newContext({ viewport: VIEW, bypassCSP: true })).newPage();
  await page.goto(site.url + hash);
  await page.getByRole("status").filter({ hasText: "points move" }).waitFor({ timeout: 60_000 });
  return page;
}

const colourBy = (page, what) =>
  page.getByRole("combobox", { name: "Colour by" }).selectOption(what);

async function shoot(page) {
  await page.addStyleTag({ content: BARE });
  await settledView(page);
  const bytes = await page.screenshot({ type: "png" });
  await page.context().close();
  return `data:image/png;base64,${bytes.toString("base64")}`;
}

/** The canvas follows its new size, and shadows are cast again. */
const settledView = (page) => page.waitForTimeout(800);

/** The view of a scene, and whether the page verified it. */
async function shootScene(site, { scene, link }, colours) {
  const page = await pageAt(site, link);
  const said = page.getByText(/Verified:|Replayed:/);
  await said.waitFor({ timeout: 60_000 });
  const notice = await said.textContent();
  if (!notice.startsWith("Verified:")) throw new Error(`${scene.name}: ${notice}`);
  if (colours) await colourBy(page, colours);
  await settled(page);
  return shoot(page);
}

/** The planarity map of an explored mesh that was not made exact, and its worst panel. */
async function shootBent(site, { scene }) {
  const directory = mkdtempSync(join(tmpdir(), "planish-paper-"));
  const file = join(directory, "explored.obj");
  const { length } = scene.variation;
  const x = scene.variation.join(",");
  const words = [...editWords(scene), "--dimension", String(length), "--coefficients", x];
  const { planarity_mm_per_m: planarity } = report("explore", ...words, "-o", file);
  const page = await pageAt(site, "");
  const chooser = page.waitForEvent("filechooser");
  await page.getByRole("button", { name: "Open file" }).click();
  await (await chooser).setFiles(file);
  await page.getByRole("button", { name: "Not now" }).click();
  await colourBy(page, "planarity");
  await settled(page);
  rmSync(directory, { recursive: true });
  return { image: await shoot(page), worst: planarity.after_max };
}

const panel = (image, caption, extra = "") =>
  `<figure>${image ? `<img src="${image}">` : ""}${extra}<figcaption>${caption}</figcaption></figure>`;

const FONT = readFileSync(
  createRequire(import.meta.url).resolve(
    "@fontsource-variable/inter/files/inter-latin-wght-normal.woff2",
  ),
  "base64",
);
const STYLE = `@font-face { font-family: Inter; src: url("data:font/woff2;base64,${FONT}") format("woff2") }
  body { margin: 0; padding: 12px; background: #fff; font: 22px Inter, sans-serif; color: #222 }
  main { display: grid; gap: 12px; grid-template-columns: repeat(var(--columns), 1fr) }
  figure { margin: 0; position: relative } img { width: 100%; display: block; border-radius: 6px }
  figcaption { padding: 6px 2px; text-align: center } .bars { position: absolute; left: 10px; top: 10px }`;

async function compose(site, name, columns, panels) {
  const page = await (await site.browser.newContext()).newPage();
  await page.setViewportSize({ width: Math.min(1500, 520 * columns), height: 100 });
  await page.setContent(
    `<style>${STYLE}</style><main style="--columns:${columns}">${panels.join("")}</main>`,
  );
  await page.waitForTimeout(200);
  const bytes = await page.screenshot({ fullPage: true });
  writeFileSync(join(ROOT, "docs/pictures", name), bytes);
  await page.context().close();
  return { name, bytes: bytes.length };
}

const COLUMNS = { 1: 2, 2: 3, 3: 4, 4: 4, 5: 4, 6: 2, 7: 2, 8: 2, 9: 2 };

function captionOf({ scene, moved, figures }) {
  if (scene.figure !== 6) return `${scene.label} (${moved} points)`;
  return `projected: worst panel ${figures.planarity_mm_per_m.after_max.toExponential(0)} mm/m`;
}

async function panelsOf(site, figure, scenes, measured) {
  const panels = [];
  if (figure === 1) {
    const [{ scene }] = scenes;
    const page = await pageAt(site, "");
    panels.push(panel(await shootBase(page, scene), "before"));
  }
  for (const entry of scenes) {
    const { scene } = entry;
    if (figure === 6) {
      const { image, worst } = await shootBent(site, entry);
      panels.push(panel(image, `explored: worst panel ${worst.toFixed(1)} mm/m`));
    }
    const image = await shootScene(site, entry, figure === 6 ? "planarity" : null);
    const bars = scene.variation && figure >= 4 && figure <= 5 ? barChart(scene.variation) : "";
    panels.push(panel(image, captionOf(entry), bars));
  }
  if (figure === 7) panels.push(panel(null, "residuals", residualChart(measured.stages.records)));
  return panels;
}

/** The unedited sample of a scene. */
async function shootBase(page, { mesh }) {
  const [sample] = mesh.split(":");
  await page.getByRole("combobox", { name: "Sample" }).selectOption(sample);
  await settled(page);
  return shoot(page);
}

export async function writePictures(scenes, measured) {
  mkdirSync(join(ROOT, "docs/pictures"), { recursive: true });
  const site = await openBrowser();
  const written = [];
  for (const figure of new Set(scenes.map(({ scene }) => scene.figure))) {
    const own = scenes.filter(({ scene }) => scene.figure === figure);
    const panels = await panelsOf(site, figure, own, measured);
    written.push(await compose(site, `figure-${figure}.png`, COLUMNS[figure], panels));
    console.log(`docs/pictures/figure-${figure}.png`);
  }
  await site.close();
  return written;
}
