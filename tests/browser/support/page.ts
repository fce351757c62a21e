// SPDX-License-Identifier: MIT
// A real browser on the built site, served as plain files under a sub-path.
import { readFile } from "node:fs/promises";
import type { Browser, BrowserContext, BrowserContextOptions, Page } from "playwright-core";
import { expect } from "vitest";
import { launch } from "../../../.tools/browser.mjs";
import { serve } from "../../../.tools/serve.mjs";
import { DEFAULT_SETTINGS } from "../../../web/src/design/design.ts";
import { encodeLink } from "../../../web/src/design/link.ts";
import type { Recipe } from "../../../web/src/design/recipe.ts";

export type Prepare = (context: BrowserContext) => Promise<void>;

export interface Site {
  readonly url: string;
  /** A new visitor; `prepare` runs before the page loads. */
  open(options?: BrowserContextOptions, hash?: string, prepare?: Prepare): Promise<Page>;
  /** A visitor who opens a link to the vault under the raw weights, which nobody has edited. */
  openVault(options?: BrowserContextOptions, prepare?: Prepare): Promise<Page>;
  /** One more tab of the same visitor. */
  openTab(page: Page): Promise<Page>;
  close(): Promise<void>;
}

/** Fails the test that uses the page if anything is logged as an error or fetched from elsewhere. */
function watch(page: Page, origin: string, complaints: string[]): void {
  page.on("pageerror", (error) => complaints.push(`uncaught: ${error.message}`));
  page.on("console", (message) => {
    if (message.type() === "error") complaints.push(`console: ${message.text()}`);
  });
  page.on("request", (request) => {
    const { protocol, origin: from } = new URL(request.url());
    if (protocol.startsWith("http") && from !== origin)
      complaints.push(`request: ${request.url()}`);
  });
}

const VAULT: Recipe = {
  source: { kind: "sample", name: "vault", size: 21 },
  planarised: null,
  handles: [],
  settings: DEFAULT_SETTINGS,
  families: [],
  unit: "m",
  camera: null,
  mark: { hash: 0, moved: 0, probes: [] }, // of no shape
};

/** Waits until the page can be used. */
export const usable = (page: Page): Promise<void> =>
  expect.poll(() => status(page)).not.toContain("loading");

/** PLANISH_SITE names another build to test, so that a long run survives the next one. */
export async function openSite(directory = process.env.PLANISH_SITE ?? "dist"): Promise<Site> {
  const { server, url } = await serve(directory, { prefix: "/under/a/path/" });
  const browser: Browser = await launch();
  const complaints: string[] = [];
  const tabIn = async (context: BrowserContext, hash: string): Promise<Page> => {
    const page = await context.newPage();
    watch(page, new URL(url).origin, complaints);
    await page.goto(url + hash);
    await usable(page);
    return page;
  };
  const open: Site["open"] = async (options = {}, hash = "", prepare = async () => {}) => {
    const viewport = { width: 900, height: 640 };
    // What pulses is drawn without a graphics card here, and takes half a core from the solver.
    const context = await browser.newContext({ viewport, reducedMotion: "reduce", ...options });
    if (process.env.CI) context.setDefaultTimeout(90_000); // as patient as vitest.config.ts
    await prepare(context);
    return tabIn(context, hash);
  };
  return {
    url,
    open,
    openVault: async (options, prepare) => open(options, await encodeLink(VAULT), prepare),
    openTab: (page) => tabIn(page.context(), ""),
    async close() {
      await browser.close();
      server.close();
      expect(complaints).toEqual([]);
    },
  };
}

export const status = async (page: Page): Promise<string> =>
  (await page.getByRole("status").textContent()) ?? "";

export const movedCount = async (page: Page): Promise<number> =>
  Number(/(\d+) of \d+ points move/.exec(await status(page))?.[1] ?? Number.NaN);

/** Waits until nothing runs, and no part of the page that will run is being fetched. */
export const idle = (page: Page): Promise<void> =>
  expect
    .poll(async () => {
      const fetching = await page.locator("main").getAttribute("data-fetching");
      return fetching === "0" && page.getByRole("button", { name: "Cancel" }).isDisabled();
    })
    .toBe(true);

/** Unfolds what few need: there the raw weights are. */
export async function openAdvanced(page: Page): Promise<void> {
  await page.getByText("Advanced", { exact: true }).click();
  await page.getByRole("slider", { name: "Locality" }).waitFor();
}

/** Adds a handle if there is none and moves it: "+40cm" raises it. */
export async function typeTarget(page: Page, z: string): Promise<void> {
  const field = page.getByRole("table", { name: "Handles" }).getByRole("spinbutton", { name: "Z" });
  if ((await field.count()) === 0) {
    await page.getByRole("button", { name: "Add handle" }).click();
    await idle(page);
  }
  await field.first().fill(z);
  await field.first().press("Enter");
  await expect.poll(() => movedCount(page)).toBeGreaterThan(0);
  await idle(page);
}

type Press = (page: Page) => Promise<void>;
const openButton: Press = (page) => page.getByRole("button", { name: "Open file" }).click();

/** Picks a file, without waiting for what the page makes of it. */
export async function pickFile(
  page: Page,
  name: string,
  content: string | Buffer,
  press = openButton,
): Promise<void> {
  const chooser = page.waitForEvent("filechooser");
  // The page catches the chooser from its own thread, which lets a key or a click overtake: two answers of
  // that thread say that the order to catch it has been carried out.
  await page.evaluate(() => 0);
  await page.evaluate(() => 0);
  await press(page);
  const buffer = Buffer.from(content);
  await (await chooser).setFiles({ name, mimeType: "application/octet-stream", buffer });
}

export async function openFile(page: Page, name: string, content: string | Buffer): Promise<void> {
  await pickFile(page, name, content);
  await idle(page);
}

export async function exportAs(
  page: Page,
  format: "OBJ" | "GLB" | "3DM" | "PLY" | "PNG" | "JSON",
): Promise<Buffer> {
  await page.getByRole("button", { name: "Export" }).click();
  const download = page.waitForEvent("download");
  await page.getByRole("button", { name: format, exact: true }).click();
  return readFile(await (await download).path());
}

/** The design as it would be saved for other programs. */
export const obj = async (page: Page): Promise<string> => (await exportAs(page, "OBJ")).toString();
