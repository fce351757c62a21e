// SPDX-License-Identifier: MIT
// How far the lines of the open mesh are from conjugate directions, measured once.
import type { Page } from "../../state/page.ts";
import { conjugacy, UNKNOWN } from "./conjugacy.ts";

/** Of the mesh that is open. */
export function measureNet(page: Page): void {
  const of = page.mesh.peek();
  if (of && page.conjugacy.peek()?.of !== of) page.conjugacy.value = { of, angles: conjugacy(of) };
}

/** Degrees of each panel of the open mesh; null until they are measured. */
export function netAngles(page: Page): Float32Array | null {
  const measured = page.conjugacy.value;
  return measured && measured.of === page.mesh.value ? measured.angles : null;
}

/** Of all panels: what is known of fewer says nothing about the net. */
const LEAST_KNOWN = 0.5;

/** Degrees: what half of the panels that are known exceed, and the largest; null where too few are known. */
export function netFault(angles: Float32Array): { half: number; most: number } | null {
  const known = angles.filter((angle) => angle !== UNKNOWN).sort();
  if (known.length < LEAST_KNOWN * angles.length) return null;
  const [half, most] = [known[Math.floor(known.length / 2)], known.at(-1)];
  return half === undefined || most === undefined ? null : { half, most };
}
