// SPDX-License-Identifier: MIT
// Links of recorded designs, by the page's own encoder.
import { createServer } from "vite";
import { ROOT } from "./command.mjs";

/** What a link carries, from a design of docs/formats.md. */
function toRecipe({ source, planarised, unit, handles, pins, options, variations, result }) {
  const [variation] = variations ?? [];
  return {
    source: { kind: "sample", name: source.sample, size: source.size },
    planarised,
    handles: [
      ...handles.map(([vertex, ...target]) => ({ vertex, target, pinned: false })),
      ...pins.map((vertex) => ({ vertex, target: [0, 0, 0], pinned: true })),
    ],
    settings: {
      attraction: options.attraction,
      locality: options.locality,
      smoothness: options.smoothness,
      fairness: options.fairness,
      engine: options.solver,
    },
    variation: variation?.coefficients ?? null,
    unit,
    mark: {
      hash: Number.parseInt(result.hash, 16),
      moved: result.moved,
      probes: result.probes.flat(),
    },
  };
}

/** One fragment ("#v1=…") per design, in order. */
export async function linksOf(designs) {
  const server = await createServer({
    root: ROOT,
    configFile: false,
    logLevel: "error",
    server: { middlewareMode: true, watch: null },
    optimizeDeps: { noDiscovery: true },
  });
  try {
    const { encodeLink } = await server.ssrLoadModule("/web/src/share/link.ts");
    return await Promise.all(designs.map((design) => encodeLink(toRecipe(design))));
  } finally {
    await server.close();
  }
}
