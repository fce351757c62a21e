// SPDX-License-Identifier: MIT
// Build only: the parts of the page that come by themselves as soon as it can be used are one file.
// Left alone, every module that two of them use would be a small file of its own, and many small
// files pack worse than one.

interface Module {
  readonly importers: readonly string[];
  readonly dynamicImporters: readonly string[];
  readonly importedIds: readonly string[];
}

interface Graph {
  getModuleInfo(id: string): Module | null;
}

/** A module and all that import it, directly or by others, without waiting for it. */
function importersOf(id: string, graph: Graph): readonly Module[] {
  const seen = new Set([id]);
  const found: Module[] = [];
  for (const one of seen) {
    const info = graph.getModuleInfo(one);
    if (!info) continue;
    found.push(info);
    for (const importer of info.importers) seen.add(importer);
  }
  return found;
}

/** Puts parts of features into their places, or lists the features that do. */
const registers = (id: string): boolean => /\/features\/.*(register|all-features)\.ts$/.test(id);

/** A component that fetches others by `later()`, which it does as soon as the page can be used, as places do. */
const fetchesLater = (id: string, graph: Graph): boolean =>
  registers(id) ||
  (graph.getModuleInfo(id)?.importedIds.some((one) => one.endsWith("/ui/later.tsx")) ?? false);

/** A part of the shell's controls, or a component or the commands of a feature: the rest of it is drawn in the view. */
const isControl = (id: string): boolean =>
  id.includes("/src/ui/") ||
  registers(id) ||
  (id.includes("/src/features/") && /(\.tsx|-commands\.ts)$/.test(id));

/**
 * Names the file for a module; null leaves it to the bundler. What the view, a drag or a link that
 * opens fetches, too, is a file beside that: none of these is to wait for the rest.
 */
export function partOfControls(id: string, graph: Graph): string | null {
  const waits = importersOf(id, graph).flatMap(({ dynamicImporters }) => dynamicImporters);
  if (!waits.some((one) => fetchesLater(one, graph))) return null;
  return waits.every(isControl) ? "controls" : "shared";
}
