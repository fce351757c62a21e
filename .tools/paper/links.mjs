// SPDX-License-Identifier: MIT
// Links of recorded designs: replayed in the page's own solver (in node), marked with what that
// gave, and written as the page does. The command line's last bits may be others: rounding
// differs between the two builds by up to 1e-9 of the mesh; the largest difference is reported.
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { createServer, runnerImport } from "vite";
import { ROOT } from "./command.mjs";

const BUILT = new URL("../../build/wasm/wasm/", import.meta.url);

async function load(name) {
  const { default: create } = await import(new URL(`${name}.mjs`, BUILT).href);
  return create({ wasmBinary: readFileSync(new URL(`${name}.wasm`, BUILT)) });
}

/** What a link carries, as the page reads a design; its mark is the command line's. */
function toRecipe(design, camera, { fromDesign }, { readDesign }) {
  const read = fromDesign(readDesign(JSON.stringify(design)));
  if (!read.ok) throw new Error(read.reason);
  return { ...read.value, camera };
}

/** The worker's side of the page, asked without a worker. */
class Solver {
  #dispatcher;
  #reply = null;

  constructor({ Dispatcher }, module) {
    this.#dispatcher = new Dispatcher(module, (reply) => {
      if (reply.kind !== "progress" && reply.kind !== "reading") this.#reply = reply;
    });
  }

  async ask(request) {
    await this.#dispatcher.handle({ job: 1, ...request });
    if (this.#reply.kind === "failed") throw new Error(this.#reply.message);
    return this.#reply;
  }

  /** What replaying `recipe` gives, and its mark. */
  async replay(recipe, { toDesign }) {
    const { source, planarised, settings } = recipe;
    const { cuts } = settings;
    await this.ask({ kind: "open", source, planarise: planarised, symmetry: null, cuts });
    const { shape, deviation } = await this.ask({ kind: "replay", design: toDesign(recipe) });
    const { mark } = await this.ask({ kind: "mark", shape });
    return { mark, deviation };
  }
}

const PAGE = {
  link: "/web/src/design/link.ts",
  beside: "/web/src/design/beside-text.ts",
  text: "/web/src/design/design-value.ts",
  dispatch: "/web/src/solver/dispatch.ts",
};

async function withPageModules(use) {
  const plugin = fileURLToPath(new URL("../../web/core-defaults.ts", import.meta.url));
  const { module } = await runnerImport(plugin);
  const server = await createServer({
    root: ROOT,
    configFile: false,
    logLevel: "error",
    resolve: { alias: { "@wasm": fileURLToPath(BUILT) } },
    plugins: [module.coreDefaults(fileURLToPath(BUILT), (url) => import(url))],
    server: { middlewareMode: true, watch: null },
    optimizeDeps: { noDiscovery: true },
  });
  try {
    const names = Object.keys(PAGE);
    const modules = await Promise.all(names.map((name) => server.ssrLoadModule(PAGE[name])));
    return await use(Object.fromEntries(names.map((name, k) => [name, modules[k]])));
  } finally {
    await server.close();
  }
}

/** One { link, moved, deviation } per { design, camera }: its fragment ("#v2=…"), and how far apart
 * page and command line are, model units. */
export const linksOf = (views) =>
  withPageModules(async ({ link, beside, text, dispatch }) => {
    const solver = new Solver(dispatch, await load("planish"));
    const files = await load("planish_documents");
    const links = [];
    for (const view of views) {
      const native = toRecipe(view.design, view.camera, text, files);
      const { mark, deviation } = await solver.replay(native, text);
      const design = files.writeLinkText(text.toDesign({ ...native, mark }));
      links.push({
        link: link.packLink(beside.withBeside(design, { camera: view.camera }, [])),
        moved: mark.moved,
        deviation,
      });
    }
    return links;
  });
