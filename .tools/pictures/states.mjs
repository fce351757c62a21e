// SPDX-License-Identifier: MIT
// Every state of the page as a picture, to be looked at: node .tools/pictures/states.mjs OUT [state…]
// Writes OUT/<state>-<size>-<light|dark>.png from the built site. --size and --scheme choose.
import { mkdirSync } from "node:fs";
import {
  findVariations,
  lift,
  openBrowser,
  openPage,
  openSample,
  settled,
  showTab,
} from "../page/page.mjs";

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

/** Where a point is that can be dragged: the middle of the model, near enough. */
async function middle(page) {
  const box = await page.getByLabel("3D view").boundingBox();
  return [box.x + box.width / 2, box.y + box.height / 2];
}

async function inspect(page, name) {
  await page.getByText(name, { exact: true }).first().scrollIntoViewIfNeeded();
}

const colour = (kind) => async (page) => {
  await lift(page, "+1200mm");
  await page.getByRole("combobox", { name: "Colour by" }).selectOption(kind);
  await settled(page);
};

/** A point pinned all around: it cannot follow. */
async function refuse(page) {
  await page.getByLabel("3D view").focus();
  const go = async (...ways) => {
    for (const way of ways) await page.keyboard.press(`Control+Arrow${way}`);
  };
  await lift(page, "+100mm");
  await page.getByLabel("3D view").focus();
  await go("Right", "Up", "Left", "Left", "Down", "Down", "Right", "Right");
  await button(page, "Pin selected points").click();
  await settled(page);
  const first = page.getByRole("checkbox", { name: "Pinned" }).first();
  if (await first.isChecked()) await first.uncheck();
  await page.getByText("Advanced", { exact: true }).click();
  await page.getByRole("checkbox", { name: "Meet the targets exactly" }).check();
  await settled(page);
  await page.getByRole("region", { name: "Why the target" }).scrollIntoViewIfNeeded();
}

async function sharedLink(page) {
  await lift(page, "+1200mm");
  await button(page, "Share").click();
  const link = await page.getByRole("textbox", { name: "Link" }).inputValue();
  await page.keyboard.press("Escape");
  return new URL(link).hash;
}

async function openHash(page, hash) {
  await page.evaluate((text) => {
    location.hash = text;
  }, hash);
  await settled(page);
}

const STATES = {
  first: async () => {},
  hover: async (page) => {
    await lift(page, "+1200mm");
    const [x, y] = await middle(page);
    for (let k = -12; k < 13; ++k) {
      await page.mouse.move(x + 4 * k, y);
      if ((await page.getByText(/^Point \d+ (moved|untouched)/).count()) > 0) return;
    }
  },
  dragging: holdDrag,
  edited: (page) => lift(page, "+1500mm"),
  refused: refuse,
  import: (page) => openMesh(page, "saddle.obj", warpedGrid()),
  notFlat: async (page) => {
    await openMesh(page, "saddle.obj", warpedGrid());
    await button(page, "Not now").click();
    await page.getByRole("combobox", { name: "Colour by" }).selectOption("planarity");
    await settled(page);
  },
  planarised: async (page) => {
    await openMesh(page, "saddle.obj", warpedGrid());
    await button(page, "Planarise").click();
    await settled(page);
  },
  variations: async (page) => {
    await lift(page, "+1200mm");
    await findVariations(page);
    await page.getByRole("slider", { name: "Variation 1" }).fill("0.5");
    await settled(page);
    await page.getByRole("list", { name: "Gallery of variations" }).scrollIntoViewIfNeeded();
  },
  shape: colour("shape"),
  slide: colour("slide"),
  displacement: colour("displacement"),
  planarity: colour("planarity"),
  fairness: colour("fairness"),
  health: colour("health"),
  table: async (page) => {
    await lift(page, "+1200mm");
    await showTab(page, "Check and make");
    await page.getByRole("table", { name: "Panels" }).scrollIntoViewIfNeeded();
    await page.getByRole("row").last().scrollIntoViewIfNeeded();
  },
  panel: async (page) => {
    await lift(page, "+1200mm");
    await showTab(page, "Check and make");
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
  error: (page) => openMesh(page, "broken.obj", "v 0 0 0\nv 1 0 0\nf 1 2 9\n"),
  share: (page) => button(page, "Share").click(),
  export: (page) => button(page, "Export").click(),
  help: (page) => button(page, "Help").click(),
  advanced: async (page) => {
    await lift(page, "+1200mm");
    await page.getByText("Advanced", { exact: true }).click();
    await page.getByRole("combobox", { name: "Tolerance" }).selectOption("1");
    await settled(page);
  },
  solve: async (page) => {
    await lift(page, "+1200mm");
    await showTab(page, "Check and make");
    await page.getByText("Last solve", { exact: true }).click();
    await settled(page);
    await inspect(page, "Last solve");
  },
  verified: async (page) => openHash(page, await sharedLink(page)),
  damaged: async (page) => {
    const hash = await sharedLink(page);
    await openHash(page, `${hash.slice(0, 40)}A${hash.slice(42)}`);
  },
  snapshots: async (page) => {
    await lift(page, "+1200mm");
    await button(page, "Snapshot").click();
    await lift(page, "+400mm");
    await button(page, "Snapshot").click();
    await showTab(page, "Explore");
    await page.getByRole("list", { name: "Snapshots" }).scrollIntoViewIfNeeded();
    await page
      .getByRole("textbox", { name: /^Name of/ })
      .last()
      .scrollIntoViewIfNeeded();
  },
};

/** What the browser refuses in some states, before the page loads. */
const PREPARE = {
  noStorage: () => {
    IDBFactory.prototype.open = () => {
      throw new DOMException("denied", "SecurityError");
    };
  },
};
STATES.noStorage = (page) => lift(page, "+1200mm");

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
      const page = await openPage(site, options, PREPARE[name]);
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
