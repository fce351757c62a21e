// SPDX-License-Identifier: MIT
// What the README's examples of the command line give, one picture each, and the page that shows them:
// docs/examples.md. After `npm run build`: node .tools/example-pictures.mjs
import { execFileSync } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { openBrowser, openPage, settled } from "./page.mjs";

const COMMAND = resolve("build/native/planish");
const FOLDER = resolve("docs/pictures/examples");
const SIZE = { width: 860, height: 480 };

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
  if (["compare", "info", "panels", "drawings"].includes(command)) return null;
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
  return page.screenshot({ clip: await canvas.boundingBox(), type: "jpeg", quality: 82 });
}

const HEAD = `# What the examples give

The [README's examples](../README.md#command-line) of the command line, in their order, as the page shows what they write: an edit by
how far it changes the shape, types and mobility by their colours. Made by \`node .tools/example-pictures.mjs\`.
`;

const parts = [HEAD];
rmSync(FOLDER, { recursive: true, force: true });
mkdirSync(FOLDER, { recursive: true });
bringMesh();
const site = await openBrowser();
for (const [k, line] of examples.entries()) {
  const words = line.split(" ").slice(1);
  perform(words);
  const shown = shownBy(words);
  parts.push(`    ${line}\n`);
  if (!shown) {
    parts.push("Tables, drawings or text.\n");
    continue;
  }
  const page = await openPage(site, { viewport: SIZE, reducedMotion: "reduce" });
  const picture = await take(page, shown);
  await page.context().close();
  const name = `${String(k + 1).padStart(2, "0")}-${words[0]}.jpg`;
  writeFileSync(join(FOLDER, name), picture);
  parts.push(`![What it writes, seen in the page](pictures/examples/${name})\n`);
  console.log(name, Math.round(picture.length / 1000), "kB", shown.file);
}
await site.close();
rmSync(scratch, { recursive: true });
writeFileSync("docs/examples.md", parts.join("\n"));
