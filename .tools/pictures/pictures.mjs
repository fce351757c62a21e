// SPDX-License-Identifier: MIT
// The README's pictures, from the built site in a real browser: node .tools/pictures/pictures.mjs [name…]
import { mkdtemp, readFile, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import {
  findVariations,
  hintedPoint,
  lift,
  openBrowser,
  openPage,
  openSample,
  settled,
  showTab,
} from "../page/page.mjs";
import { serve } from "../page/serve.mjs";

const SIZE = { width: 1120, height: 700 };
const here = (path) => fileURLToPath(new URL(path, import.meta.url));

const canvas = (page) => page.getByLabel("3D view");

/** The model without what lies over it. */
async function model(page) {
  const clip = await canvas(page).boundingBox();
  const show = (visibility) =>
    canvas(page).evaluate((element, value) => {
      for (const other of element.parentElement.children) {
        if (other !== element) other.style.visibility = value;
      }
    }, visibility);
  await show("hidden");
  const picture = await page.screenshot({ clip });
  await show("");
  return picture;
}

/** Drags the hinted point upwards and keeps hold of it. */
async function drag(page) {
  const { x, y } = await hintedPoint(page);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.keyboard.press("z");
  for (let k = 1; k <= 12; ++k) await page.mouse.move(x, y - 2 * k);
  await settled(page);
  return page.screenshot();
}

/** A vault of flat quads with a dent of a few centimetres. */
function bumpyVault(count = 16) {
  const lines = [];
  for (let j = 0; j < count; ++j)
    for (let i = 0; i < count; ++i) {
      const [u, v] = [i / (count - 1), j / (count - 1)];
      const rise = 3 * Math.sin(Math.PI * u) + 1.5 * Math.sin(Math.PI * v);
      const bump = 0.06 * Math.exp(-90 * ((u - 0.4) ** 2 + (v - 0.55) ** 2)) * Math.sin(9 * u * v);
      lines.push(`v ${15 * u} ${15 * v} ${rise + bump}`);
    }
  for (let j = 0; j + 1 < count; ++j)
    for (let i = 0; i + 1 < count; ++i) {
      const a = count * j + i + 1;
      lines.push(`f ${a} ${a + 1} ${a + count + 1} ${a + count}`);
    }
  return lines.join("\n");
}

async function heatMap(page) {
  const chooser = page.waitForEvent("filechooser");
  await page.getByRole("button", { name: "Open file" }).click();
  const buffer = Buffer.from(bumpyVault());
  await (await chooser).setFiles({ name: "as-built.obj", mimeType: "text/plain", buffer });
  await page.getByRole("button", { name: "Not now" }).click();
  await page.getByRole("combobox", { name: "Colour by" }).selectOption("planarity");
  await settled(page);
  await showTab(page, "Check and make");
  await page
    .getByRole("button", { name: /Show panel/ })
    .first()
    .click();
  await page.getByRole("button", { name: "Fit", exact: true }).click();
  await settled(page);
  return page.screenshot();
}

/** Several pictures in a row, as one. */
async function sideBySide(browser, pictures) {
  const page = await browser.newPage({ viewport: { width: 1120, height: 320 } });
  const images = pictures.map(
    (picture) => `<img src="data:image/png;base64,${picture.toString("base64")}">`,
  );
  await page.setContent(
    `<style>body{margin:0;display:flex;gap:8px;background:#fff}img{flex:1;min-width:0;height:320px;object-fit:cover}</style>${images.join("")}`,
  );
  await page.waitForTimeout(300);
  const row = await page.screenshot();
  await page.close();
  return row;
}

async function variations(page, { browser }) {
  await lift(page, "+1300mm");
  await findVariations(page);
  await canvas(page).focus();
  await page.keyboard.press("Escape");
  await page.keyboard.press("+");
  const slider = page.getByRole("slider", { name: "Variation 1" });
  const pictures = [];
  for (const value of ["-0.5", "0", "0.5"]) {
    await slider.fill(value);
    await settled(page);
    pictures.push(await model(page));
  }
  return sideBySide(browser, pictures);
}

/** The exported GLB as three.js's own loader shows it; nothing of ours but the file. */
async function exported(page, { browser }) {
  await openSample(page, "Tri-hex");
  await lift(page, "+1200mm");
  await page.getByRole("button", { name: "Export" }).click();
  const download = page.waitForEvent("download");
  await page.getByRole("button", { name: "GLB", exact: true }).click();
  const folder = await mkdtemp(join(tmpdir(), "planish-"));
  await (await download).saveAs(join(folder, "design.glb"));
  const files = await serve(here("../../node_modules/three/"));
  const viewer = await browser.newPage({ viewport: SIZE });
  viewer.on("pageerror", (error) => console.error(error.message));
  const glb = await readFile(join(folder, "design.glb"));
  await viewer.route("**/design.glb", (route) => route.fulfill({ body: glb }));
  const html = { contentType: "text/html", body: VIEWER };
  await viewer.route("**/viewer.html", (route) => route.fulfill(html));
  await viewer.goto(`${files.url}viewer.html`);
  await viewer.waitForFunction("window.shown === true");
  const picture = await viewer.screenshot();
  await viewer.close();
  files.server.close();
  return picture;
}

/** A strip about to be cut through an edited roof that has a corner less. */
async function cutting(page) {
  await lift(page, "+900mm");
  await page.getByRole("button", { name: "Cut panels" }).click();
  const tool = page.getByRole("region", { name: "Cut panels" });
  await tool.getByRole("button", { name: "Corner", exact: true }).click();
  await tool.getByRole("textbox").first().fill("210:219");
  await tool.getByRole("button", { name: "Cut", exact: true }).click();
  await settled(page);
  await tool.getByRole("button", { name: "Strip", exact: true }).click();
  const box = await canvas(page).boundingBox();
  await page.mouse.move(box.x + 0.33 * box.width, box.y + 0.4 * box.height);
  await settled(page);
  return page.screenshot();
}

const VIEWER = `<!doctype html><style>body{margin:0}</style>
<script type="importmap">{"imports":{"three":"./build/three.module.js","three/addons/":"./examples/jsm/"}}</script>
<script type="module">
import * as THREE from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { RoomEnvironment } from "three/addons/environments/RoomEnvironment.js";
const renderer = new THREE.WebGLRenderer({ antialias: true });
renderer.setSize(innerWidth, innerHeight);
renderer.setClearColor("#20262c");
renderer.toneMapping = THREE.ACESFilmicToneMapping;
renderer.toneMappingExposure = 0.55;
document.body.append(renderer.domElement);
const scene = new THREE.Scene();
scene.environment = new THREE.PMREMGenerator(renderer).fromScene(new RoomEnvironment()).texture;
const { scene: model } = await new GLTFLoader().loadAsync("design.glb");
scene.add(model);
const sphere = new THREE.Box3().setFromObject(model).getBoundingSphere(new THREE.Sphere());
const camera = new THREE.PerspectiveCamera(28, innerWidth / innerHeight, 0.01, 1e5);
const from = new THREE.Vector3(-0.6, 0.55, 0.9).setLength(2.9 * sphere.radius);
camera.position.copy(sphere.center).add(from);
camera.lookAt(sphere.center);
renderer.render(scene, camera);
renderer.render(scene, camera);
window.shown = true;
</script>`;

const PICTURES = { edit: drag, cutting, "heat-map": heatMap, variations, exported };

const only = process.argv.slice(2);
const site = await openBrowser();
for (const [name, take] of Object.entries(PICTURES)) {
  if (only.length > 0 && !only.includes(name)) continue;
  const page = await openPage(site, { viewport: SIZE, reducedMotion: "reduce" });
  const picture = await take(page, site);
  await writeFile(here(`../../docs/pictures/${name}.png`), picture);
  const said = await page.getByRole("status").first().textContent();
  console.log(`docs/pictures/${name}.png: ${Math.round(picture.length / 1000)} kB; ${said}`);
  await page.context().close();
}
await site.close();
