// SPDX-License-Identifier: MIT
// What a stranger's JSON may say. Every reader gives a value of the right kind or null.
import { FILE_FORMATS, type FileFormat } from "../solver/file-formats.ts";
import type { Camera } from "./camera.ts";

export const LONGEST_NAME = 1_000;

export type Json = Readonly<Record<string, unknown>>;

export const isRecord = (value: unknown): value is Json =>
  typeof value === "object" && value !== null && !Array.isArray(value);

export const isNumber = (value: unknown): value is number =>
  typeof value === "number" && Number.isFinite(value);

export const isNumbers = (value: unknown, length?: number): value is number[] =>
  Array.isArray(value) &&
  (length === undefined || value.length === length) &&
  value.every((x) => isNumber(x));

export const isIndex = (value: unknown): value is number =>
  Number.isInteger(value) && (value as number) >= 0 && (value as number) < 2 ** 32;

export const isName = (value: unknown): value is string =>
  typeof value === "string" && value.length <= LONGEST_NAME;

export const readFormat = (value: unknown): FileFormat | null =>
  FILE_FORMATS.find((format) => format === value) ?? null;

/** Position and target; undefined if there is something else than a camera or nothing. */
export function readCamera(value: unknown): Camera | null | undefined {
  if (value === undefined || value === null) return null;
  if (!isNumbers(value, 6)) return undefined;
  const [a = 0, b = 0, c = 0, d = 0, e = 0, f = 0] = value;
  return { position: [a, b, c], target: [d, e, f] };
}

export const writeCamera = ({ position, target }: Camera): number[] =>
  [...position, ...target].map((x) => Number(x.toFixed(3)));
