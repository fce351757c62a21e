// SPDX-License-Identifier: MIT
// Links as a page writes and reads them, where there is no page: the core in node reads and writes the text.
import { readBeside, withBeside } from "../../../web/src/design/beside-text.ts";
import type { Companions } from "../../../web/src/design/companions.ts";
import { type DesignText, fromDesign, toDesign } from "../../../web/src/design/design-value.ts";
import { packLink, unpackLink } from "../../../web/src/design/link.ts";
import type { Steps } from "../../../web/src/design/recipe.ts";
import { decodeLink as decodeFirst, PREFIX } from "../../../web/src/design/v1/link.ts";
import { type VariantJson, variantJson } from "../../../web/src/design/variant-text.ts";
import type { Result } from "../../../web/src/result/result.ts";
import { loadDocuments } from "../../parity/support/planish.ts";

const documents = await loadDocuments();

async function textOf(steps: Steps): Promise<string> {
  const { source } = steps;
  const file =
    source.kind === "file" ? new Uint8Array(await source.bytes.arrayBuffer()) : undefined;
  return documents.writeLinkText(toDesign(steps, file));
}

async function variantsOf(steps: Steps, companions: Companions): Promise<VariantJson[]> {
  const variants: VariantJson[] = [];
  for (const { name, steps: done } of companions.variants)
    variants.push(variantJson(name, await textOf({ ...steps, ...done })));
  return variants;
}

/** The design's text with what is beside it. */
export async function linkText(steps: Steps): Promise<string> {
  const { camera, companions } = steps;
  const variants = companions ? await variantsOf(steps, companions) : [];
  return withBeside(await textOf(steps), { camera, companions }, variants);
}

export const encodeLink = async (steps: Steps): Promise<string> => packLink(await linkText(steps));

export const readText = async (text: string): Promise<Result<DesignText>> =>
  fromDesign(documents.readDesign(text));

/** What a page reads of a link, of whatever version. */
export async function decodeLink(hash: string): Promise<Result<Steps>> {
  if (hash.startsWith(PREFIX)) return decodeFirst(hash);
  const text = await unpackLink(hash);
  if (!text.ok) return text;
  const read = await readText(text.value);
  if (!read.ok) return read;
  const { source, ...steps } = read.value;
  if (!source) throw new Error("no mesh");
  return { ok: true, value: { ...steps, source, ...(await readBeside(text.value, readText)) } };
}
