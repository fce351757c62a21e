// SPDX-License-Identifier: MIT
// What is seen before the solver is there.
import { isLink } from "../design/fragment.ts";
import { prepareDisplay } from "../mesh/display-mesh.ts";
import type { Page } from "../state/page.ts";

interface FirstMesh {
  readonly positions: readonly number[];
  readonly offsets: readonly number[];
  readonly vertices: readonly number[];
}

/** Paints the first sample, unless the address names a design, which is another mesh.
 * @param hash the address's fragment */
export function paintFirst(page: Page, hash: string, { positions, offsets, vertices }: FirstMesh) {
  if (isLink(hash)) return;
  page.displayMesh.value = prepareDisplay({
    display: Float32Array.from(positions),
    offsets: Int32Array.from(offsets),
    vertices: Int32Array.from(vertices),
  });
}
