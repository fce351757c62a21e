// SPDX-License-Identifier: MIT
// What a handle that stops short leaves: the mesh, and what the note says of its way.
import type { Page } from "playwright-core";
import { type ObjMesh, readObj } from "../../browser/support/obj.ts";
import { exportAs } from "../../browser/support/page.ts";

export const exported = async (page: Page): Promise<ObjMesh> =>
  readObj((await exportAs(page, "OBJ")).toString());

/** Millimetres that panels allow, and that were asked for, of the note that says so. */
export async function allowed(page: Page): Promise<readonly number[]> {
  const why = page.getByRole("region", { name: "Why the target is not reached" });
  const said = /(?:allow|at) (\d+) of (\d+) mm/.exec((await why.textContent()) ?? "");
  const [, got, asked] = said ?? [];
  return [Number(got), Number(asked)];
}
