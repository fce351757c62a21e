// SPDX-License-Identifier: MIT
// What the README's examples of the command line give, one picture each, and the page that shows them:
// docs/examples.md. After `npm run build`: node .tools/pictures/example-pictures.mjs [COMMAND...], which takes the
// pictures of these commands alone.
import { execFileSync } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { strFromU8, unzipSync } from "fflate";
import { openBrowser, openPage, settled } from "../page/page.mjs";

const COMMAND = resolve("build/native/planish");
const FOLDER = resolve("docs/pictures/examples");
const SIZE = { width: 860, height: 480 };
const JPEG = { type: "jpeg", quality: 82 };
/** What is shown of the zip that a command writes. */
const SHEETS = {
  panels: {
    name: "map.svg",
    around: "polygon:not([fill='#f4f4f4'])",
    says: "The map of the package around the edit: orange panels are cut again, blue ones get a new bevel",
  },
  drawings: {
    name: "elevation-front.svg",
    says: "One of its drawings, the elevation from the front",
  },
};

const examples = readFileSync("README.md", "utf8")
  .split("\n")
  .filter((line) => line.startsWith("    planish "))
  .map((line) => line.trim());

const scratch = mkdtempSync(join(tmpdir(), "planish-examples-"));
const run = (words) =>
  execFileSync(COMMAND, words, { cwd: scratch, stdio: ["ignore", "pipe", "pipe"] }).toString();

/** The mesh "that you bring": a vault whose points were written with two decimals. */
function bringMesh() {
  const vault = run(["sample", "vault", "--size", "20", "-o", "-"]);
  const rounded = vault.replace(/-?\d+\.\d+(e-?\d+)?/g, (number) => Number(number).toFixed(2));
  writeFileSync(join(scratch, "imported.obj"), rounded);
}

const after = (words, option) => words[words.indexOf(option) + 1];

const hasDesign = ([command]) => ["edit", "explore"].includes(command);

/** Runs an example, and has its design where it has one. */
function perform(words) {
  const more = hasDesign(words) && !words.includes("--design") ? ["--design", "shown.json"] : [];
  try {
    run([...words, ...more]);
  } catch (error) {
    if (error.status !== 4) throw error;
  }
}

/** What the page opens to show an example, and by which colours; null where it writes tables or text alone. */
function shownBy(words) {
  const [command] = words;
  if (["compare", "info"].includes(command)) return null;
  if (command in SHEETS) return { file: after(words, "-o"), sheet: SHEETS[command] };
  if (command === "types") return { file: words[1], colours: "types" };
  if (command === "mobility") {
    run(["sample", "roof", "--size", "10", "-o", "mobile.obj"]);
    return { file: "mobile.obj", colours: "mobility" };
  }
  if (hasDesign(words))
    return { file: words.includes("--design") ? after(words, "--design") : "shown.json" };
  if (command === "replay") return { file: words[1] };
  const file = after(words, "-o");
  return { file, colours: file === "fewer-types.obj" ? "types" : undefined };
}

async function take(page, { file, colours }) {
  const chooser = page.waitForEvent("filechooser");
  await page.getByRole("button", { name: "Open file" }).click();
  await (await chooser).setFiles(join(scratch, file));
  await settled(page);
  for (const name of ["Not now", "Start editing", "Close"]) {
    const button = page.locator(".import-report").getByRole("button", { name, exact: true });
    if (await button.isVisible()) await button.click();
  }
  if (colours) await page.getByRole("combobox", { name: "Colour by" }).selectOption(colours);
  await page.getByRole("button", { name: "Fit", exact: true }).click();
  await page.waitForTimeout(colours ? 4000 : 300);
  await settled(page);
  const canvas = page.getByLabel("3D view");
  await canvas.evaluate((element) => {
    for (const other of element.parentElement.children)
      if (other !== element) other.style.visibility = "hidden";
  });
  return page.screenshot({ clip: await canvas.boundingBox(), ...JPEG });
}

/** An SVG of a zip, as wide as the other pictures; of a map what has a colour and some panels around it. */
async function takeSheet(browser, { file, sheet }) {
  const svg = strFromU8(unzipSync(readFileSync(join(scratch, file)))[sheet.name]);
  const page = await browser.newPage({ viewport: SIZE });
  await page.setContent(`<body style="margin:0">${svg}`);
  const drawing = page.locator("svg");
  await drawing.evaluate(
    (element, { width, around }) => {
      const coloured = around ? [...element.querySelectorAll(around)] : [];
      const boxes = coloured.map((one) => one.getBBox());
      if (boxes.length > 0) {
        const margin = 3 * boxes[0].width;
        const [left, top] = [
          Math.min(...boxes.map(({ x }) => x)),
          Math.min(...boxes.map(({ y }) => y)),
        ];
        const right = Math.max(...boxes.map((box) => box.x + box.width));
        const bottom = Math.max(...boxes.map((box) => box.y + box.height));
        const sides = [right - left + 2 * margin, bottom - top + 2 * margin];
        element.setAttribute("viewBox", [left - margin, top - margin, ...sides].join(" "));
      }
      element.setAttribute("width", width);
      element.removeAttribute("height");
      element.style.display = "block";
    },
    { ...SIZE, ...sheet },
  );
  const picture = await drawing.screenshot(JPEG);
  await page.close();
  return picture;
}

/** As the page shows it, or a sheet of it. */
async function picture(site, shown) {
  if (shown.sheet) return takeSheet(site.browser, shown);
  const page = await openPage(site, { viewport: SIZE, reducedMotion: "reduce" });
  const taken = await take(page, shown);
  await page.context().close();
  return taken;
}

const HEAD = `# What the examples give

The [README's examples](../README.md#command-line) of the command line, in their order, as the page shows what they write: an edit by
how far it changes the shape, types and mobility by their colours; of a package its map, of drawings one. Made by
\`node .tools/pictures/example-pictures.mjs\`.
`;

const wanted = process.argv.slice(2);
const parts = [HEAD];
if (wanted.length === 0) rmSync(FOLDER, { recursive: true, force: true });
mkdirSync(FOLDER, { recursive: true });
bringMesh();
const site = await openBrowser();
for (const [k, line] of examples.entries()) {
  const words = line.split(" ").slice(1);
  perform(words);
  const shown = shownBy(words);
  parts.push(`    ${line}\n`);
  if (!shown) {
    parts.push("Figures, as JSON.\n");
    continue;
  }
  const name = `${String(k + 1).padStart(2, "0")}-${words[0]}.jpg`;
  const says = shown.sheet?.says ?? "What it writes, seen in the page";
  parts.push(`![${says}](pictures/examples/${name})\n`);
  if (wanted.length > 0 && !wanted.includes(words[0])) continue;
  const taken = await picture(site, shown);
  writeFileSync(join(FOLDER, name), taken);
  console.log(name, Math.round(taken.length / 1000), "kB", shown.file);
}
await site.close();
rmSync(scratch, { recursive: true });
writeFileSync("docs/examples.md", parts.join("\n"));
