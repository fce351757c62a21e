// SPDX-License-Identifier: MIT
// The suites of page_tests.py: their files in the order given, and, where places in the sources are given, a
// line for each file of tests that runs the innermost function around one ("all" where there is no function).
import { appendFileSync } from "node:fs";
import { join, relative } from "node:path";
import { fileURLToPath } from "node:url";
import { mergeConfig, parseSync } from "vite";
import { BaseSequencer } from "vitest/node";
import unit from "../../web/vitest.config.ts";
import page from "../../web/vitest.page.config.ts";

const { suite, order, places, reached } = JSON.parse(process.env.PLANISH_REACHED);
const tree = fileURLToPath(new URL("../..", import.meta.url));

class Ordered extends BaseSequencer {
  sort(files) {
    const place = ({ moduleId }) => order.indexOf(relative(tree, moduleId));
    return files.sort((a, b) => place(a) - place(b));
  }
}

/** Bodies of functions around an offset, the outermost first. */
function* bodiesAround(node, at) {
  if (at < node.start || at >= node.end) return;
  const { body } = node;
  if (/Function/.test(node.type) && body && at >= body.start && at < body.end) yield body;
  for (const child of Object.values(node).flat()) {
    if (child && typeof child.type === "string") yield* bodiesAround(child, at);
  }
}

function offsetOf(code, [line, column]) {
  const before = code.split("\n").slice(0, line);
  return before.reduce((sum, each) => sum + each.length + 1, column);
}

function noted(code, id, inFile) {
  const { program } = parseSync(id, code);
  const inserted = inFile.flatMap(([number, , ...place]) => {
    const body = [...bodiesAround(program, offsetOf(code, place))].pop();
    if (!body) appendFileSync(reached, `all ${number}\n`);
    const call = `globalThis.reached?.(${number})`;
    if (!body) return [];
    if (body.type === "BlockStatement") return [[body.start + 1, ` ${call};`]];
    return [
      [body.start, `(${call}, `],
      [body.end, ")"],
    ];
  });
  inserted.sort((a, b) => b[0] - a[0]);
  return inserted.reduce((text, [at, what]) => text.slice(0, at) + what + text.slice(at), code);
}

const notes = {
  name: "reached",
  enforce: "pre",
  transform(code, id) {
    const inFile = places.filter(([, path]) => join(tree, path) === id);
    return inFile.length > 0 ? { code: noted(code, id, inFile), map: null } : null;
  },
};

const setupFiles = [fileURLToPath(new URL("reached.mjs", import.meta.url))];

export default mergeConfig(suite === "page" ? page : unit, {
  plugins: places.length > 0 ? [notes] : [],
  test: {
    sequence: { sequencer: Ordered },
    provide: { reached },
    ...(places.length > 0 && { setupFiles }),
  },
});
