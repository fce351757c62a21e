// SPDX-License-Identifier: MIT
// A real browser on the built site, served as plain files under a sub-path.
import {
  type BrowserContext,
  type BrowserContextOptions,
  chromium,
  type Page,
} from "playwright-core";
import { expect, inject } from "vitest";
import { serve } from "../../../.tools/page/serve.mjs";
import { FIRST_SETTINGS } from "../../../web/src/design/design.ts";
import { PATIENCE } from "../../patience.ts";
import { encodeLink } from "../../web/support/links.ts";
import { vault } from "../../web/support/vault.ts";
import { drawNothing, type Prepare } from "./drawing.ts";
import { usable } from "./page.ts";

export interface Visit extends BrowserContextOptions {
  /** The 3D view is drawn. Drawing without a graphics card is half of what a test costs: only tests that
   * look at pixels ask for it. */
  readonly draws?: boolean;
  /** Not all that is asked for ever comes: nobody waits for the page's load event, which would wait for it. */
  readonly holdsBack?: boolean;
}

/** A visit with what keeps the page for use without a network; others have none. */
export const KEEPING: Visit = { serviceWorkers: "allow" };

export interface Site {
  readonly url: string;
  /** A new visitor; `prepare` runs before the page loads. */
  open(options?: Visit, hash?: string, prepare?: Prepare): Promise<Page>;
  /** A visitor who opens a link to the vault under the raw weights, which nobody has edited. */
  openVault(options?: Visit, prepare?: Prepare): Promise<Page>;
  /** A visitor who opens a link to a small vault under the page's own settings, which nobody has edited:
   * for what is solved often, or tried in all ways. */
  openSmall(options?: Visit, prepare?: Prepare): Promise<Page>;
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

/** The site that all test files share, or another build of it, which gets a server of its own. */
export async function openSite(directory: string | null = null): Promise<Site> {
  const own = directory === null ? null : await serve(directory, { prefix: "/under/a/path/" });
  const url = own?.url ?? inject("site");
  const browser = await chromium.connect(inject("browser"));
  const complaints: string[] = [];
  const tabIn = async (
    context: BrowserContext,
    hash: string,
    waitUntil: "load" | "domcontentloaded" = "load",
  ): Promise<Page> => {
    const page = await context.newPage();
    watch(page, new URL(url).origin, complaints);
    await page.goto(url + hash, { waitUntil });
    await usable(page);
    return page;
  };
  const open: Site["open"] = async (visit = {}, hash = "", prepare = async () => {}) => {
    const { draws = false, holdsBack = false, ...options } = visit;
    const viewport = { width: 900, height: 640 };
    // What pulses is drawn without a graphics card here, and takes half a core from the solver. A service
    // worker fetches and keeps all files at every visit: a quarter of what opening a page costs.
    const context = await browser.newContext({
      viewport,
      reducedMotion: "reduce",
      serviceWorkers: "block",
      ...options,
    });
    context.setDefaultTimeout(PATIENCE);
    if (!draws) await drawNothing(context);
    await prepare(context);
    return tabIn(context, hash, holdsBack ? "domcontentloaded" : "load");
  };
  return {
    url,
    open,
    openVault: async (options, prepare) => open(options, await encodeLink(vault(21)), prepare),
    openSmall: async (options, prepare) =>
      open(options, await encodeLink(vault(11, FIRST_SETTINGS)), prepare),
    openTab: (page) => tabIn(page.context(), ""),
    async close() {
      await browser.close();
      own?.server.close();
      expect(complaints).toEqual([]);
    },
  };
}
