// SPDX-License-Identifier: MIT
// A link that Python writes has the text that the page writes of the same design.
import { execFileSync } from "node:child_process";
import { expect, it } from "vitest";
import { unpackLink } from "../../web/src/design/link.ts";
import { loadDocuments } from "../parity/support/planish.ts";
import { PYTHON } from "./support/places.ts";

const MESH = "# Dachfl\u00e4che\r\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
const file = { file: "roof.obj", format: "obj" };
const HEAD = { format: "planish-design", version: 1 };
const DESIGNS = {
  sample: {
    source: { sample: "vault", size: 12 },
    handles: [[78, 6, 6, 4]],
    supports: ["level=z:3,4"],
    options: { shape: true, softness: 5, keep_out: ["below=-0.001"], bounds: ["fold=+5"] },
  },
  text: { source: { ...file, text: MESH }, symmetry: ["x"] },
  bytes: {
    source: { ...file, bytes: Buffer.from(MESH).toString("base64") },
    cuts: ["split=0:0,2"],
  },
};

const LINK = `import sys, planish
print(planish.Design(sys.stdin.read()).link("https://example.org/"))`;

it.each(Object.entries(DESIGNS))("of a design with %s", async (_, recipe) => {
  const text = JSON.stringify({ ...HEAD, ...recipe });
  const link = execFileSync(PYTHON, ["-c", LINK], { input: text }).toString().trim();
  const documents = await loadDocuments();
  const { design, problem } = documents.readDesign(text);
  if (!design) throw new Error(problem);
  expect(new URL(link).hash).toMatch(/^#v2=[\w-]+$/);
  expect(await unpackLink(new URL(link).hash)).toEqual({
    ok: true,
    value: documents.writeLinkText(design),
  });
});
