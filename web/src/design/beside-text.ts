// SPDX-License-Identifier: MIT
// What a page keeps beside a design that it saves as text: "page", which the core passes over.
import type { Camera } from "./camera.ts";
import {
  type Companions,
  type CompanionsJson,
  readCompanions,
  writeCompanions,
} from "./companions.ts";
import { isRecord, readCamera, writeCamera } from "./reading.ts";

export interface Beside {
  readonly camera: Camera | null;
  readonly companions: Companions | undefined;
}

interface BesideJson extends CompanionsJson {
  /** Camera: position and target. */
  c?: number[];
}

/** The design's JSON with what is beside it; its own text stays as it is, number by number. */
export function withBeside(text: string, { camera, companions }: Beside): string {
  const json: BesideJson = {
    ...(camera && { c: writeCamera(camera) }),
    ...(companions && writeCompanions(companions)),
  };
  const end = text.lastIndexOf("}");
  if (end < 0 || Object.keys(json).length === 0) return text;
  return `${text.slice(0, end).trimEnd()},\n "page": ${JSON.stringify(json)}${text.slice(end)}`;
}

/** Any text gives what can be read of it. */
export function readBeside(text: string): Beside {
  const nothing = { camera: null, companions: undefined };
  if (!text.includes('"page"')) return nothing;
  try {
    const json: unknown = JSON.parse(text);
    const beside = isRecord(json) ? json.page : null;
    if (!isRecord(beside)) return nothing;
    return { camera: readCamera(beside.c) ?? null, companions: readCompanions(beside) };
  } catch {
    return nothing;
  }
}
