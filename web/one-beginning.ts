// SPDX-License-Identifier: MIT
// Build only: what the page needs at once is one file. Left alone, every module that a later part
// uses too would be a small file of its own, and many small files pack worse than one.

interface Graph {
  getModuleInfo(id: string): {
    readonly isEntry: boolean;
    readonly importers: readonly string[];
  } | null;
}

/** Whether the page's entry imports a module, directly or by others, without waiting for it. */
function isNeededAtOnce(id: string, graph: Graph): boolean {
  const seen = new Set([id]);
  for (const one of seen) {
    const info = graph.getModuleInfo(one);
    if (info?.isEntry) return true;
    for (const importer of info?.importers ?? []) seen.add(importer);
  }
  return false;
}

/** Names the file for a module; null leaves it to the bundler. */
export const oneBeginning = (id: string, graph: Graph): string | null =>
  isNeededAtOnce(id, graph) ? "page" : null;
