// SPDX-License-Identifier: MIT
// Settings and weights as autosave packs them, by the places of version 1.
import type { EditSettings, VariationWeights } from "../solver/protocol.ts";
import { DEFAULT_SETTINGS } from "./design.ts";
import { CUT, NUMBERED, PLACES, type Place, SHAPE, SYMMETRY, WEIGHTS } from "./v1/settings.ts";

export const writeWeights = (weights: VariationWeights): number[] => WEIGHTS.map((w) => weights[w]);

const WRITTEN_LENGTHS = [5, 9, 13, 14];

/** The number of a list of supports; 0 where it has none or says nothing. */
const numberOf = (supports: readonly string[]): number =>
  Math.max(
    0,
    NUMBERED.findIndex((known) => known.join() === supports.join()),
  );

function pack(settings: EditSettings, place: Place): number | string {
  if (place === "keepBoundary") {
    return Number(settings.keepBoundary) + 2 * numberOf(settings.supports);
  }
  const value = settings[place];
  return typeof value === "boolean" ? Number(value) : value;
}

export function writeSettings(settings: EditSettings): unknown[] {
  const packed = PLACES.map((place) => pack(settings, place));
  const different = PLACES.findLastIndex((place, k) => packed[k] !== pack(DEFAULT_SETTINGS, place));
  const length = WRITTEN_LENGTHS.find((places) => places > different);
  const whole = [...packed.slice(0, length), ...(settings.keepShape ? [SHAPE] : [])];
  const { limits, keepOuts, clearance, constraints, supports } = settings;
  const apart = clearance > 0 ? [`clearance=${clearance}`] : [];
  const stand = numberOf(supports) > 0 ? [] : supports;
  const images = settings.symmetry.map((one) => SYMMETRY + one);
  const parted = settings.cuts.map((one) => CUT + one);
  const listed = [...limits, ...keepOuts, ...apart, ...images, ...parted, ...constraints, ...stand];
  return listed.length > 0 ? [...whole, listed] : whole;
}
