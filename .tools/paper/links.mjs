// SPDX-License-Identifier: MIT
// Links of recorded designs: replayed in the page's own solver (in node), marked with what that
// gave, and written by the page's own encoder. The command line's last bits may be others: rounding
// differs between the two builds by up to 1e-9 of the mesh; the largest difference is reported.
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { createServer } from "vite";
import { ROOT } from "./command.mjs";

async function loadPlanish() {
  const built = new URL("../../build/wasm/wasm/", import.meta.url);
  const { default: create } = await import(new URL("planish.mjs", built).href);
  return create({ wasmBinary: readFileSync(new URL("planish.wasm", built)) });
}

/** What a link carries, as the page reads a design; its mark is the command line's. */
function toRecipe(design, camera, { readDesign }) {
  const read = readDesign(JSON.stringify(design));
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

  /** The base and the shape that `recipe` gives, by the steps of state/replaying.ts. */
  async replay({ source, planarised, handles, settings, families }, { toTargets }) {
    const { mesh } = await this.ask({ kind: "open", source, planarise: planarised });
    const targets = toTargets(handles);
    let shown = await this.ask({ kind: "edit", mode: "solve", targets, settings, budget: 1 });
    for (const { asked, eigenbasis, coefficients } of families) {
      await this.ask({ kind: "explore", dimension: asked, eigenbasis });
      await this.ask({ kind: "vary", coefficients });
      shown = await this.ask({ kind: "exact" });
    }
    return { base: mesh.positions, shape: shown.shape };
  }
}

const PAGE = {
  link: "/web/src/share/link.ts",
  recipe: "/web/src/state/recipe.ts",
  design: "/web/src/state/design.ts",
  text: "/web/src/share/design-text.ts",
  dispatch: "/web/src/solver/dispatch.ts",
};

async function withPageModules(use) {
  const server = await createServer({
    root: ROOT,
    configFile: false,
    logLevel: "error",
    resolve: {
      alias: { "@wasm": fileURLToPath(new URL("../../build/wasm/wasm", import.meta.url)) },
    },
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

/** One { link, moved, deviation } per { design, camera }: its fragment ("#v1=…"), and how far apart
 * page and command line are, model units. */
export const linksOf = (views) =>
  withPageModules(async ({ link, recipe, design, text, dispatch }) => {
    const solver = new Solver(dispatch, await loadPlanish());
    const links = [];
    for (const view of views) {
      const native = toRecipe(view.design, view.camera, text);
      const { base, shape } = await solver.replay(native, design);
      const mark = recipe.markOf(shape);
      const deviation = recipe.deviation(native.mark, shape, base);
      links.push({
        link: await link.encodeLink({ ...native, mark }),
        moved: mark.moved,
        deviation,
      });
    }
    return links;
  });
