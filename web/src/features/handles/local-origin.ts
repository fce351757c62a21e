// SPDX-License-Identifier: MIT
// Places of a survey have seven digits before the point; those from a point of the mesh can be read.
import { computed, signal } from "@preact/signals";
import type { OpenedMesh } from "../../solver/protocol.ts";
import { kept, type Page } from "../../state/page.ts";

const chosen = kept(() => signal<{ opened: WeakRef<OpenedMesh>; vertex: number } | null>(null));

/** The point, of the mesh that is open, that places are given from; null: the origin of the file. */
export const localOrigin = kept((page: Page) =>
  computed(() => {
    const origin = chosen(page).value;
    return origin && origin.opened.deref() === page.mesh.value ? origin.vertex : null;
  }),
);

export function setLocalOrigin(page: Page, vertex: number | null): void {
  const opened = page.mesh.value;
  chosen(page).value = opened && vertex !== null ? { opened: new WeakRef(opened), vertex } : null;
}
