// SPDX-License-Identifier: MIT
// What a link says: packed by a page, or as text by a script.
import { fromDesign } from "../share/design-value.ts";
import { decodeLink } from "../share/link.ts";
import { refuse } from "../share/refusal.ts";
import { isTextLink, unpackText } from "../share/text-link.ts";
import { run } from "./connection.ts";
import type { Parsed } from "./expression.ts";
import type { Steps } from "./recipe.ts";
import { problem } from "./store.ts";
import { inTurn } from "./turns.ts";

async function readText(text: string): Promise<Parsed<Steps>> {
  const question = { kind: "readDesign", text } as const;
  const answer = await run("reading the link", question, "design");
  if (!answer) return refuse(problem.value ?? "The link was not read.");
  const read = fromDesign(answer.reading);
  if (!read.ok) return read;
  const { source } = read.value;
  if (!source) return refuse("The mesh of this link lies beside it. Open the mesh as a file.");
  return { ok: true, value: { ...read.value, source, camera: null } };
}

/** Any string gives a recipe or a sentence that says what is wrong with it; it never throws. */
export async function readLink(hash: string): Promise<Parsed<Steps>> {
  if (!isTextLink(hash)) return decodeLink(hash);
  const text = await unpackText(hash);
  if (!text.ok) return text;
  let read: Parsed<Steps> = refuse("The link was not read.");
  await inTurn(async () => {
    read = await readText(text.value);
  });
  return read;
}
