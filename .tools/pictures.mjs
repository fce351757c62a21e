// SPDX-License-Identifier: MIT
// The README's pictures, from the built site in a real browser: node .tools/pictures.mjs
import { chromium } from "playwright-core";
import { serve } from "./serve.mjs";

const FLAGS = [
  "--no-sandbox",
  "--use-angle=swiftshader",
  "--enable-unsafe-swiftshader",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
  "--no-first-run",
];

/** What each picture shows; `act` prepares the page after the sample is open. */
const SCENES = [
  { file: "edit.png", sample: "Vault", act: (page) => lift(page, "+1500mm") },
  {
    file: "variations.png",
    sample: "Dome",
    act: async (page) => {
      await lift(page, "+900mm");
      await page
        .getByRole("button", { name: /variations/i })
        .first()
        .click();
      await page.getByRole("slider", { name: "Variation 1" }).waitFor({ timeout: 30_000 });
      await page.getByRole("slider", { name: "Variation 1" }).fill("0.6");
      await settled(page);
    },
  },
  { file: "trihex.png", sample: "Tri-hex", act: (page) => lift(page, "+600mm") },
];

async function settled(page) {
  await page.waitForTimeout(500);
  await page.getByRole("button", { name: "Cancel" }).and(page.locator(":disabled")).waitFor();
  await page.waitForTimeout(1500);
}

async function lift(page, amount) {
  await page.getByRole("button", { name: "Add handle" }).click();
  const z = page.getByRole("table", { name: "Handles" }).getByRole("spinbutton", { name: "Z" });
  await z.fill(amount);
  await z.press("Enter");
  await settled(page);
}

const server = await serve(new URL("../dist/", import.meta.url).pathname, 0);
const browser = await chromium.launch({ executablePath: "/usr/bin/chromium", args: FLAGS });
const only = process.argv.slice(2);
for (const { file, sample, act } of SCENES) {
  if (only.length > 0 && !only.includes(file)) continue;
  const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
  await page.goto(server.url);
  await page.getByRole("status").filter({ hasText: "points" }).waitFor({ timeout: 60_000 });
  const chooser = page.getByRole("combobox", { name: "Sample" });
  const options = await chooser.locator("option").allTextContents();
  const label = options.find((option) => option.toLowerCase().startsWith(sample.toLowerCase()));
  await chooser.selectOption({ label: label ?? sample });
  await settled(page);
  await act(page);
  await page.screenshot({ path: new URL(`../docs/pictures/${file}`, import.meta.url).pathname });
  console.log(`docs/pictures/${file}: ${await page.getByRole("status").first().textContent()}`);
  await page.close();
}
await browser.close();
server.close?.();
process.exit(0);
