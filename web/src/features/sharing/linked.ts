// SPDX-License-Identifier: MIT
// What a link says: packed by a page, or as text by a script.

import { fromDesign } from "../../design/design-value.ts";
import { decodeLink } from "../../design/link.ts";
import type { Steps } from "../../design/recipe.ts";
import { isTextLink, unpackText } from "../../design/text-link.ts";
import { type Result, refuse } from "../../result/result.ts";
import { run } from "../../state/connection.ts";
import type { Page } from "../../state/page.ts";
import { inTurn } from "../../state/turns.ts";

const NOT_READ = refuse("The link was not read.");

async function readText(page: Page, text: string): Promise<Result<Steps>> {
  const question = { kind: "readDesign", text } as const;
  const answer = await run(page, "reading the link", question, "design");
  if (!answer.ok) return answer.reason ? answer : NOT_READ;
  const read = fromDesign(answer.value.reading);
  if (!read.ok) return read;
  const { source } = read.value;
  if (!source) return refuse("The mesh of this link lies beside it. Open the mesh as a file.");
  return { ok: true, value: { ...read.value, source, camera: null } };
}

/** Any string gives a recipe or a sentence that says what is wrong with it; it never throws. */
export async function readLink(page: Page, hash: string): Promise<Result<Steps>> {
  if (!isTextLink(hash)) return decodeLink(hash);
  const text = await unpackText(hash);
  if (!text.ok) return text;
  let read: Result<Steps> = NOT_READ;
  await inTurn(page, async () => {
    read = await readText(page, text.value);
    return undefined;
  });
  return read;
}
