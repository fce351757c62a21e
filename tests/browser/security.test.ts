// SPDX-License-Identifier: MIT
// Needs: network.
// Nothing that a file, a link or a name brings becomes markup or code; the page's policy holds as
// static files are served.
import { readdirSync, readFileSync } from "node:fs";
import type { Page } from "playwright-core";
import { describe, expect, it } from "vitest";
import { recipeOf } from "../../web/src/design/recipe.ts";
import { EDITED, FILE, MARK } from "../web/support/golden-designs.ts";
import { encodeLink } from "../web/support/links.ts";
import type { Prepare } from "./support/drawing.ts";
import { flatRoof } from "./support/faults.ts";
import { openSite } from "./support/open.ts";
import { kept, openFile, showTab, still, typeTarget, usable } from "./support/page.ts";
import { SITE } from "./support/server.ts";
import { site } from "./support/site.ts";

const PAYLOAD = `<img src=x onerror="window.owned=1"><svg onload="window.owned=1">`;

/** Any use of these with data would make markup of it; the page uses none after it has started. */
const trapMarkup: Prepare = async (context) => {
  await context.addInitScript(() => {
    const seen: string[] = [];
    Object.assign(window, { markup: seen });
    const inner = Object.getOwnPropertyDescriptor(Element.prototype, "innerHTML");
    Object.defineProperty(Element.prototype, "innerHTML", {
      ...inner,
      set(this: Element, text: string) {
        seen.push(text);
        inner?.set?.call(this, text);
      },
    });
  });
};

async function expectUnharmed(page: Page): Promise<void> {
  await still(page);
  expect(await page.evaluate("window.owned")).toBeUndefined();
  expect(await page.locator("img[src='x'], [onerror], [onload]").count()).toBe(0);
  const markup = await page.evaluate<string[]>("window.markup");
  // Icons come from the build, through the same door.
  expect(markup.filter((text) => !/^\s*(<!--.*?-->\s*)?<svg\b/s.test(text))).toEqual([]);
  expect(markup.filter((text) => /onerror|onload|script/i.test(text))).toEqual([]);
}

describe("markup in data stays text", () => {
  it("in file names, group names, snapshot names and messages about them, also after a reload", async () => {
    const page = await site.open({}, "", trapMarkup);
    const text = `g ${PAYLOAD}\no ${PAYLOAD}\nusemtl ${PAYLOAD}\n${flatRoof(6)}`;
    await openFile(page, `${PAYLOAD.replaceAll("/", "")}.obj`, text);
    await expect.poll(() => page.getByRole("heading", { name: /<img src=x/ }).count()).toBe(1);
    await page.getByRole("button", { name: "Start editing" }).click();
    await openFile(page, `${PAYLOAD}.exe`, "");
    expect(await page.getByRole("alert").innerText()).toContain("<img");
    await openFile(page, "broken.obj", `v 0 0 0\nf ${PAYLOAD}\n`);
    await expectUnharmed(page);
    await typeTarget(page, "+60cm");
    await showTab(page, "Explore");
    await page.getByRole("button", { name: "Take snapshot" }).click();
    const name = page.getByRole("textbox", { name: "Name of Snapshot 1" });
    await name.fill(PAYLOAD);
    await name.press("Enter");
    await kept(page);
    await page.reload();
    await usable(page);
    await expect.poll(() => page.getByRole("button", { name: /^Adopt <img/ }).count()).toBe(1);
    await expectUnharmed(page);
    await page.context().close();
  });

  it("in links", async () => {
    const sample = { ...EDITED, source: { kind: "sample", name: PAYLOAD, size: 3 } } as const;
    const file = { ...EDITED, handles: [], variation: null, source: { ...FILE, name: PAYLOAD } };
    for (const design of [sample, file]) {
      const page = await site.open(
        {},
        await encodeLink(recipeOf(design, "m", null, MARK)),
        trapMarkup,
      );
      await expectUnharmed(page);
      await page.context().close();
    }
  });
});

describe("the policy", () => {
  const html = readFileSync(`${SITE}/index.html`, "utf8");
  const written = /http-equiv="Content-Security-Policy" content="([^"]*)"/.exec(html)?.[1] ?? "";
  const policy = written.replaceAll("&#39;", "'");

  it("allows no script but the page's own files and WebAssembly, and stands before them", () => {
    expect(policy).toContain("default-src 'none'");
    expect(/script-src ([^;]*)/.exec(policy)?.[1]).toBe("'self' 'wasm-unsafe-eval'");
    expect(policy).not.toContain("unsafe-inline");
    expect(policy).not.toContain("'unsafe-eval'");
    expect(html).not.toMatch(/<script(?![^>]*\bsrc=)[^>]*>/);
    expect(html).not.toMatch(/\son\w+=|<style|\sstyle=/);
    expect(html.indexOf("Content-Security-Policy")).toBeLessThan(html.indexOf("<script"));
    expect(html.indexOf("Content-Security-Policy")).toBeLessThan(html.indexOf("<link"));
    // Nor is there any in the scripts, whatever the server sends as policy.
    const scripts = readdirSync(`${SITE}/assets`).filter((name) => name.endsWith(".js"));
    const texts = scripts.map((name) => readFileSync(`${SITE}/assets/${name}`, "utf8"));
    expect(scripts.some((name) => name.startsWith("rhino3dm"))).toBe(true);
    expect(scripts.filter((_, k) => /new Function\b|\beval\(/.test(texts[k] ?? ""))).toEqual([]);
  });

  it("is enforced", async () => {
    const own = await openSite();
    const page = await own.open();
    const blocked = await page.evaluate(async () => {
      const seen: string[] = [];
      document.addEventListener("securitypolicyviolation", ({ effectiveDirective }) =>
        seen.push(effectiveDirective),
      );
      const inline = document.createElement("script");
      inline.textContent = "window.owned = 1";
      document.head.append(inline);
      // In a task of the page's own: what the test itself evaluates is exempt.
      const answer = await new Promise((done) => {
        setTimeout(() => {
          try {
            done(new Function("return 1")());
          } catch {
            done("refused");
          }
        });
      });
      await fetch("https://example.com/").catch(() => {});
      await new Promise((done) => setTimeout(done, 100));
      return { seen, answer, owned: (window as unknown as { owned?: number }).owned };
    });
    expect(blocked.owned).toBeUndefined();
    expect(blocked.answer).toBe("refused");
    expect(blocked.seen.join()).toMatch(/script-src.*connect-src/);
    await page.context().close();
    // Each refusal was logged, which would fail any other test.
    await expect(own.close()).rejects.toThrow();
  });
});
