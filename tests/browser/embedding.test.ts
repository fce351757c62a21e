// SPDX-License-Identifier: MIT
// Needs: frames.
// The page within other people's pages, which live at another origin.
import { readFileSync } from "node:fs";
import { createServer, type Server } from "node:http";
import type { AddressInfo } from "node:net";
import { type Browser, chromium, type FrameLocator, type Page } from "playwright-core";
import { afterAll, beforeAll, expect, inject, it } from "vitest";
import { serve } from "../../.tools/page/serve.mjs";
import type { PlanishEditor } from "../../wasm/package/src/planish-editor.ts";
import { drawNothing } from "./support/drawing.ts";
import { SITE } from "./support/server.ts";

/** A design with its result, as another visitor has made it. */
const SCENE = JSON.parse(
  readFileSync(new URL("../../docs/scenes/figure-8-b.json", import.meta.url), "utf8"),
);

const ELEMENT = readFileSync(`${SITE}/planish-editor.js`);

let browser: Browser;
let hostUrl = "";
/** A site whose files every origin may fetch, as a sandboxed frame needs it, and one as plain as can be. */
let open: Awaited<ReturnType<typeof serve>>;
let plain: Awaited<ReturnType<typeof serve>>;
let hostServer: Server;

/** What the host page has seen. */
interface HostWindow extends Window {
  readonly seen: { readonly type: string; readonly detail: Readonly<Record<string, unknown>> }[];
  readonly editor: PlanishEditor;
  readonly heard: unknown[];
}

const hostPage = (attributes: string): string => `<!doctype html>
<title>A page of someone else's</title>
<script type="module" src="/planish-editor.js"></script>
<planish-editor style="height: 560px" ${attributes}></planish-editor>
<script>
  window.seen = [];
  window.editor = document.querySelector("planish-editor");
  for (const type of ["ready", "design", "status", "select"])
    editor.addEventListener(type, ({ detail }) => seen.push({ type, detail }));
</script>`;

beforeAll(async () => {
  browser = await chromium.connect(inject("browser"));
  open = await serve(SITE, { prefix: "/planish/", open: true });
  plain = await serve(SITE, { prefix: "/planish/" });
  hostServer = createServer((request, response) => {
    const { pathname, searchParams } = new URL(request.url ?? "/", "http://localhost");
    const script = pathname === "/planish-editor.js";
    response.writeHead(200, { "content-type": script ? "text/javascript" : "text/html" });
    response.end(script ? ELEMENT : hostPage(searchParams.get("attributes") ?? ""));
  });
  await new Promise<void>((done) => hostServer.listen(0, done));
  hostUrl = `http://localhost:${(hostServer.address() as AddressInfo).port}/`;
});
afterAll(async () => {
  await browser.close();
  for (const server of [open.server, plain.server, hostServer]) server.close();
});

interface Visit {
  readonly page: Page;
  readonly inside: FrameLocator;
  readonly complaints: string[];
}

/** A visitor of the host page, once its editor is ready. */
async function visit(attributes: string): Promise<Visit> {
  // The theme of a frame follows its element only where nobody emulates one.
  const context = await browser.newContext({ reducedMotion: "reduce", colorScheme: null });
  await drawNothing(context);
  const page = await context.newPage();
  const complaints: string[] = [];
  page.on("pageerror", (error) => complaints.push(error.message));
  page.on("console", (message) => {
    const icon = message.location().url.endsWith("favicon.ico");
    if (message.type() === "error" && !icon) complaints.push(message.text());
  });
  await page.goto(`${hostUrl}?attributes=${encodeURIComponent(attributes)}`);
  await expect.poll(() => count(page, "ready")).toBe(1);
  return { page, inside: page.frameLocator("planish-editor iframe"), complaints };
}

const seen = (page: Page, type: string): Promise<Readonly<Record<string, unknown>>[]> =>
  page.evaluate(
    (wanted) =>
      (window as unknown as HostWindow).seen
        .filter((event) => event.type === wanted)
        .map(({ detail }) => detail),
    type,
  );
const count = async (page: Page, type: string): Promise<number> => (await seen(page, type)).length;

/** Types a height into the table of handles, as a user of the frame does. */
async function raise(inside: FrameLocator, z: string): Promise<void> {
  await inside.getByRole("button", { name: "Add handle" }).click();
  const field = inside.getByRole("table", { name: "Handles" }).getByRole("spinbutton");
  const height = field.and(inside.getByRole("spinbutton", { name: "Z" }));
  await height.first().fill(z);
  await height.first().press("Enter");
}

async function latestDesign(page: Page) {
  return (await seen(page, "design")).at(-1) ?? {};
}

it("an edit in the frame is told, a design set there verified or refused, and files come out", async () => {
  const { page, inside, complaints } = await visit(`src="${plain.url}"`);
  await raise(inside, "+60cm");
  await expect.poll(async () => Number((await latestDesign(page)).movedPoints)).toBeGreaterThan(0);
  const told = await latestDesign(page);
  expect(told.status).toBe("converged");
  const kept = await page.evaluate(() => (window as unknown as HostWindow).editor.design());
  expect((kept.result as { hash: unknown }).hash).toBeDefined();
  // In another frame, that knows nothing of the edit.
  const other = await visit(`src="${plain.url}"`);
  const outcome = await other.page.evaluate(
    (design) => (window as unknown as HostWindow).editor.set(design),
    kept,
  );
  expect(outcome).toEqual({
    verified: true,
    sentence: "Verified: the same result as when it was shared, to the last bit.",
  });
  await expect.poll(async () => (await latestDesign(other.page)).hash).toBe(told.hash);
  const again = await other.page.evaluate(() => (window as unknown as HostWindow).editor.design());
  expect(again).toEqual(kept);
  await page.context().close();
  await expectFiles(other.page);
  expect([...complaints, ...other.complaints]).toEqual([]);
  await expectRefused(other.page);
  await other.page.context().close();
});

/** A design that is none is refused with the sentence, and the one before stays. */
async function expectRefused(page: Page): Promise<void> {
  const before = await page.evaluate(() => (window as unknown as HostWindow).editor.design());
  const said = await page.evaluate(() =>
    (window as unknown as HostWindow).editor.set({ planish: "nothing" }).then(String, String),
  );
  expect(said).toMatch(/^Error: design\.json: /);
  const after = await page.evaluate(() => (window as unknown as HostWindow).editor.design());
  expect(after).toEqual(before);
}

/** A GLB, a JSON and a picture come out as files. */
async function expectFiles(page: Page): Promise<void> {
  const heads = await page.evaluate(async () => {
    const { editor } = window as unknown as HostWindow;
    const head = async (kind: "glb" | "json" | "png") => {
      const file = await editor.export(kind);
      return [
        file.type,
        String.fromCharCode(...new Uint8Array(await file.arrayBuffer()).slice(0, 4)),
      ];
    };
    return [await head("glb"), await head("json"), (await head("png"))[0]];
  });
  expect(heads).toEqual([
    ["model/gltf-binary", "glTF"],
    ["application/json", expect.stringMatching(/^\{/)],
    "image/png",
  ]);
}

it("a point chosen in the frame and another version are told, attributes reach the page", async () => {
  const { page, inside } = await visit(`src="${plain.url}" theme="dark"`);
  await inside.getByRole("button", { name: "Add handle" }).click();
  await expect.poll(async () => (await seen(page, "select")).at(-1)?.vertices).toHaveLength(1);
  const dark = () =>
    inside.locator("html").evaluate(() => matchMedia("(prefers-color-scheme: dark)").matches);
  expect(await dark()).toBe(true);
  await page.evaluate(() => {
    const { editor } = window as unknown as HostWindow;
    editor.theme = "light";
    editor.unit = "mm";
    editor.readonly = true;
  });
  await expect.poll(dark).toBe(false);
  await expect.poll(() => inside.getByLabel("Inspector").isVisible()).toBe(false);
  const design = await page.evaluate(() => (window as unknown as HostWindow).editor.design());
  expect(design.unit).toBe("mm");
  // As a page of another version would begin.
  await inside.locator("html").evaluate(() => {
    window.parent.postMessage({ planish: 2, event: "ready", detail: { version: 2 } }, "*");
  });
  await expect
    .poll(async () => (await seen(page, "status")).at(-1)?.problem)
    .toBe("The page speaks version 2, this element 1.");
  await page.context().close();
});

it("read-only it works in a sandbox: it shows, verifies and exports, and nothing moves a point", async () => {
  const { page, inside, complaints } = await visit(`src="${open.url}" readonly sandbox`);
  const frame = page.locator("planish-editor iframe");
  expect(await frame.getAttribute("sandbox")).toBe("allow-scripts");
  expect(await inside.locator("html").evaluate(() => self.origin)).toBe("null");
  const outcome = await page.evaluate(
    (given) => (window as unknown as HostWindow).editor.set(given),
    SCENE,
  );
  expect(outcome.verified).toBe(true);
  // The event follows the answer: the mark of what is shown is computed in the worker.
  await expect.poll(async () => Number((await latestDesign(page)).movedPoints)).toBeGreaterThan(0);
  const { hash } = await latestDesign(page);
  const canvas = await inside.getByLabel("3D view").boundingBox();
  if (!canvas) throw new Error("no 3D view");
  expect(canvas.height).toBeGreaterThan(0.8 * 560);
  const [x, y] = [canvas.x + canvas.width / 2, canvas.y + canvas.height / 2];
  await page.mouse.click(x, y);
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let k = 1; k <= 6; ++k) await page.mouse.move(x, y - 8 * k);
  await page.mouse.up();
  for (const key of ["p", "Control+z"]) await page.keyboard.press(key);
  const size = await page.evaluate(
    async () => (await (window as unknown as HostWindow).editor.export("glb")).size,
  );
  expect(size).toBeGreaterThan(1000);
  expect((await latestDesign(page)).hash).toBe(hash);
  expect(await inside.getByRole("button", { name: "Open file" }).isVisible()).toBe(false);
  expect(complaints).toEqual([]);
  await page.context().close();
});

it("messages of another version, window or origin are refused", async () => {
  const { page } = await visit(`src="${plain.url}"`);
  await page.evaluate(() => {
    const { editor } = window as unknown as HostWindow;
    const heard: unknown[] = [];
    Object.assign(window, { heard });
    window.addEventListener("message", ({ data }) => {
      if (data.ask >= 100) heard.push(data);
    });
    const frame = editor.shadowRoot?.querySelector("iframe")?.contentWindow;
    frame?.postMessage({ planish: 2, ask: 100, kind: "design", given: null }, "*");
  });
  const heard = () => page.evaluate(() => (window as unknown as HostWindow).heard);
  const refused = "This page speaks version 1 of messages, not 2.";
  await expect.poll(heard).toEqual([{ planish: 1, ask: 100, error: refused }]);
  // A page loaded for another origin, and after it one for this one, which others can reach.
  const ready = await page.evaluate(async (url) => {
    const frames = ["https://example.org", location.origin].map((origin) => {
      const frame = document.createElement("iframe");
      frame.src = `${url}?embed=${encodeURIComponent(origin)}`;
      document.body.append(frame);
      return frame;
    });
    const told = [0, 0];
    window.addEventListener("message", ({ source, data }) => {
      const k = frames.findIndex(({ contentWindow }) => contentWindow === source);
      if (data.planish && k >= 0) told[k] = (told[k] ?? 0) + 1;
    });
    while (told[1] === 0) await new Promise((resolve) => setTimeout(resolve, 100));
    await new Promise((resolve) => setTimeout(resolve, 1000));
    const ask = { planish: 1, ask: 101, kind: "design", given: null };
    frames[0]?.contentWindow?.postMessage(ask, "*");
    const foreign = document.createElement("iframe");
    foreign.setAttribute("sandbox", "allow-scripts");
    foreign.srcdoc = `<script>
      const look = { readonly: true, unit: null };
      parent.frames[1].postMessage({ planish: 1, ask: 102, kind: "look", given: look }, "*");
      parent.postMessage({ planish: 1, event: "design", detail: { hash: "forged" } }, "*");
    </script>`;
    const loaded = new Promise((resolve) => foreign.addEventListener("load", resolve));
    document.body.append(foreign);
    await loaded;
    await new Promise((resolve) => setTimeout(resolve, 1000));
    return told.map((times) => times > 0);
  }, plain.url);
  expect(ready).toEqual([false, true]);
  expect(await heard()).toHaveLength(1);
  expect((await seen(page, "design")).map(({ hash }) => hash)).not.toContain("forged");
  const own = page.frameLocator("body > iframe >> nth=1");
  expect(await own.getByLabel("Inspector").isVisible()).toBe(true);
  // Without all that it is a page in a frame like any other.
  await page.evaluate((url) => {
    const frame = document.createElement("iframe");
    frame.title = "plain";
    frame.src = url;
    document.body.append(frame);
  }, plain.url);
  const bare = page.frameLocator("iframe[title=plain]");
  await expect.poll(() => bare.getByRole("status").textContent()).toMatch(/0 of 425 points move/);
  await page.context().close();
});
