// SPDX-License-Identifier: MIT
// Every state of the page as a picture, to be looked at: node .tools/states.mjs OUT [state…]
// Writes OUT/<state>-<size>-<light|dark>.png from the built site. --size and --scheme choose.
import { mkdirSync } from "node:fs";
import { findVariations, lift, openBrowser, openPage, openSample, settled } from "./page.mjs";

const SIZES = {
  phone: { width: 360, height: 740 },
  laptop: { width: 1440, height: 900 },
  desk: { width: 2560, height: 1440 },
  wall: { width: 3840, height: 2160 },
};

const button = (page, name) => page.getByRole("button", { name, exact: true });

async function openMesh(page, name, text) {
  const chooser = page.waitForEvent("filechooser");
  await button(page, "Open file").click();
  await (await chooser).setFiles({ name, mimeType: "text/plain", buffer: Buffer.from(text) });
  await settled(page);
}

async function holdDrag(page) {
  const box = await page.getByLabel("3D view").boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let k = 1; k <= 8; ++k) await page.mouse.move(x, y - 8 * k);
  await page.waitForTimeout(800);
}

/** A shallow saddle of quads that are not flat. */
function warpedGrid() {
  const lines = [];
  for (let j = 0; j < 12; ++j)
    for (let i = 0; i < 12; ++i)
      lines.push(`v ${i} ${j} ${(0.04 * (i - 5.5) * (j - 5.5)).toFixed(4)}`);
  for (let j = 0; j < 11; ++j)
    for (let i = 0; i < 11; ++i) {
      const a = 12 * j + i + 1;
      lines.push(`f ${a} ${a + 1} ${a + 13} ${a + 12}`);
    }
  return lines.join("\n");
}

const STATES = {
  first: async () => {},
  dragging: holdDrag,
  edited: (page) => lift(page, "+1500mm"),
  variations: async (page) => {
    await lift(page, "+1200mm");
    await findVariations(page);
    await page.getByRole("slider", { name: "Variation 1" }).fill("0.5");
    await settled(page);
  },
  planarity: async (page) => {
    await lift(page, "+1200mm");
    await page.getByRole("combobox", { name: "Colour by" }).selectOption("planarity");
    await settled(page);
  },
  panel: async (page) => {
    await lift(page, "+1200mm");
    await page
      .getByRole("button", { name: /Show panel/ })
      .first()
      .click();
    await settled(page);
  },
  grazing: async (page) => {
    await lift(page, "+1200mm");
    await button(page, "Side").click();
    await settled(page);
  },
  trihex: async (page) => {
    await openSample(page, "Tri-hex");
    await lift(page, "+600mm");
  },
  freeform: (page) => openSample(page, "Freeform"),
  import: (page) => openMesh(page, "saddle.obj", warpedGrid()),
  error: (page) => openMesh(page, "broken.obj", "v 0 0 0\nv 1 0 0\nf 1 2 9\n"),
  refusal: (page) => lift(page, "+90m"),
  share: (page) => button(page, "Share").click(),
  export: (page) => button(page, "Export").click(),
  help: (page) => button(page, "Help").click(),
};

const words = process.argv.slice(2);
const option = (name) =>
  words
    .find((w) => w.startsWith(`--${name}=`))
    ?.split("=")[1]
    ?.split(",");
const [out = "/tmp/states", ...only] = words.filter((w) => !w.startsWith("--"));
mkdirSync(out, { recursive: true });
const site = await openBrowser();
for (const size of option("size") ?? Object.keys(SIZES)) {
  for (const colorScheme of option("scheme") ?? ["light", "dark"]) {
    for (const [name, act] of Object.entries(STATES)) {
      if (only.length > 0 && !only.includes(name)) continue;
      const touch = size === "phone";
      const options = { viewport: SIZES[size], colorScheme, hasTouch: touch, isMobile: touch };
      const page = await openPage(site, options);
      try {
        await act(page);
        await page.waitForTimeout(300);
      } catch (error) {
        console.log(`${name}: ${error.message.split("\n")[0]}`);
      }
      await page.screenshot({ path: `${out}/${name}-${size}-${colorScheme}.png` });
      await page.context().close();
    }
  }
}
await site.close();
