// SPDX-License-Identifier: MIT
// Somebody who opens the built site in Debian's Firefox. It has WebGL only with a screen, so the tests run
// under Xvfb (.tools/ci/checks.py); playwright-core cannot drive it, puppeteer-core does by WebDriver BiDi.
import { mkdtemp, readdir, readFile, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import puppeteer, { type Page } from "puppeteer-core";
import { expect } from "vitest";
import { serve } from "../../../.tools/page/serve.mjs";
import { SITE } from "../../browser/support/server.ts";

export interface Visitor {
  readonly page: Page;
  readonly url: string;
  status(): Promise<string>;
  /** How many points the status line says move. */
  moved(): Promise<number>;
  /** How often the page says that a link gave what it was shared as. */
  verified(): Promise<number>;
  press(name: string): Promise<void>;
  /** What the browser saved, once it is there. */
  download(press: () => Promise<void>): Promise<string>;
  /** Nothing was logged as an error. */
  leave(): Promise<void>;
}

/** What Firefox says of parts that still come while one goes to another address or closes the window; it
 * reports it as an error of the page. That a part cannot be had the page would say itself. */
const LEFT = /^(Error: )?Failed to load .* A ServiceWorker intercepted the request/;

/** Waits until the page can be used. */
export const usable = ({ status }: Visitor): Promise<void> =>
  expect.poll(status).toMatch(/points move/);

/** Goes there; the page may still be loading.
 * @param preferences of Firefox, beside its own */
export async function visit(preferences: Record<string, unknown> = {}): Promise<Visitor> {
  const { server, url } = await serve(SITE, { prefix: "/under/a/path/" });
  const saved = await mkdtemp(join(tmpdir(), "planish-firefox-"));
  const browser = await puppeteer.launch({
    browser: "firefox",
    executablePath: "/usr/bin/firefox-esr",
    headless: false,
    extraPrefsFirefox: {
      "webgl.force-enabled": true,
      "browser.download.folderList": 2,
      "browser.download.dir": saved,
      "browser.download.always_ask_before_handling_new_types": false,
      ...preferences,
    },
  });
  const complaints: string[] = [];
  const page = await browser.newPage();
  const complain = (text: string): void => {
    if (!LEFT.test(text)) complaints.push(text);
  };
  page.on("pageerror", (error) => complain(String(error)));
  page.on("console", (message) => {
    if (message.type() === "error") complain(message.text());
  });
  await page.setViewport({ width: 900, height: 640 });
  await page.goto(url);
  const status = (): Promise<string> =>
    page.$eval("[role=status]", (line) => line.textContent ?? "");
  const visitor: Visitor = {
    page,
    url,
    status,
    moved: async () => Number(/(\d+) of \d+ points move/.exec(await status())?.[1] ?? Number.NaN),
    verified: () => page.evaluate(() => (document.body.innerText.match(/Verified:/g) ?? []).length),
    press: (name) => page.locator(`::-p-aria([name="${name}"][role="button"])`).click(),
    async download(press) {
      const before = await readdir(saved);
      // The browser makes an empty file, writes beside it, and puts that in its place.
      let text = "";
      const complete = async (): Promise<string> => {
        const name = (await readdir(saved)).find(
          (name) => !(before.includes(name) || name.endsWith(".part")),
        );
        if (name) text = await readFile(join(saved, name), "utf8").catch(() => "");
        return text;
      };
      await press();
      await expect.poll(complete).not.toBe("");
      return text;
    },
    async leave() {
      await browser.close();
      server.close();
      await rm(saved, { recursive: true });
      expect(complaints).toEqual([]);
    },
  };
  return visitor;
}
