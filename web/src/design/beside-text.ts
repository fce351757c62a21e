// SPDX-License-Identifier: MIT
// What a page keeps beside a design that it writes as text: "page", which the core passes over.
import type { Result } from "../result/result.ts";
import type { Camera } from "./camera.ts";
import {
  type Companions,
  type CompanionsJson,
  listOf,
  MOST_VARIANTS,
  readCompanions,
  type Variant,
  writeCompanions,
} from "./companions.ts";
import type { DesignText } from "./design-value.ts";
import { isName, isRecord, type Json, readCamera, writeCamera } from "./reading.ts";
import { readVariant } from "./v1/steps.ts";
import { type VariantJson, variantText } from "./variant-text.ts";

export interface Beside {
  readonly camera: Camera | null;
  readonly companions: Companions | undefined;
}

interface BesideJson extends CompanionsJson {
  /** Camera: position and target. */
  c?: number[];
}

/** The design's JSON with what is beside it; its own text stays as it is, number by number.
 * @param variants those of the companions */
export function withBeside(
  text: string,
  { camera, companions }: Beside,
  variants: readonly VariantJson[],
): string {
  const json: BesideJson = {
    ...(camera && { c: writeCamera(camera) }),
    ...(companions && writeCompanions(companions, variants)),
  };
  const end = text.lastIndexOf("}");
  if (end < 0 || Object.keys(json).length === 0) return text;
  return `${text.slice(0, end).trimEnd()},\n "page": ${JSON.stringify(json)}${text.slice(end)}`;
}

/** What reads a design's text: the core. */
export type ReadText = (text: string) => Promise<Result<DesignText>>;

/** Version 1 has the settings of a variant packed as "w". */
async function readAnyVariant(value: unknown, readCore: ReadText): Promise<Variant | null> {
  if (isRecord(value) && "w" in value) return readVariant(value);
  const { n: name } = isRecord(value) ? value : {};
  const text = isName(name) ? variantText(value) : null;
  const read = text === null ? null : await readCore(text);
  if (!isName(name) || !read?.ok) return null;
  const { planarised, handles, settings, families, mark } = read.value;
  return mark && { name, steps: { planarised, handles, settings, families, mark } };
}

async function readVariants({ s }: Json, read: ReadText): Promise<Variant[]> {
  const variants: Variant[] = [];
  for (const one of listOf(s, MOST_VARIANTS)) {
    const variant = await readAnyVariant(one, read);
    if (variant) variants.push(variant);
  }
  return variants;
}

function pageOf(text: string): Json | null {
  if (!text.includes('"page"')) return null;
  try {
    const json: unknown = JSON.parse(text);
    return isRecord(json) && isRecord(json.page) ? json.page : null;
  } catch {
    return null;
  }
}

/** Any text gives what can be read of it. */
export async function readBeside(text: string, read: ReadText): Promise<Beside> {
  const beside = pageOf(text);
  if (!beside) return { camera: null, companions: undefined };
  const companions = readCompanions(beside, await readVariants(beside, read));
  return { camera: readCamera(beside.c) ?? null, companions };
}
