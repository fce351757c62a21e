// SPDX-License-Identifier: MIT
// How many types of panels a shape has, and how many the mesh has: counted once someone asked for types.

import { NO_SHAPE } from "../design/design.ts";
import { counted } from "../quantity/counted.ts";
import type { OpenedMesh, Shape } from "../solver/protocol.ts";
import { client } from "./connection.ts";
import { kept, type Page } from "./page.ts";
import type { TypesChoice } from "./page-state.ts";

export interface TypeCount {
  readonly now: number;
  /** Of the mesh, where nothing has moved. */
  readonly before: number;
}

interface Own {
  /** What was counted last of a mesh. */
  before: { readonly of: OpenedMesh; readonly choice: TypesChoice; readonly count: number } | null;
}

const own = kept((): Own => ({ before: null }));

/** "61 types (52 before)". */
export const typeWords = ({ now, before }: TypeCount): string =>
  `${counted(now, "type")} (${before} before)`;

async function countOf(page: Page, choice: TypesChoice, shape: Shape): Promise<number | null> {
  const { share, mirrored } = choice;
  const copy = { moved: shape.moved.slice(), positions: shape.positions.slice() };
  const answer = await client(page)
    .ask({ kind: "types", share, mirrored, shape: copy })
    .catch(() => null); // overtaken by Cancel, or the solver is starting anew
  return answer?.kind === "types" && !answer.types.problem ? answer.types.sizes.length : null;
}

async function countBefore(page: Page, choice: TypesChoice): Promise<number | null> {
  const [mesh, { before }] = [page.mesh.peek(), own(page)];
  if (!mesh) return null;
  if (before?.of === mesh && before.choice === choice) return before.count;
  const count = await countOf(page, choice, NO_SHAPE);
  if (count !== null) own(page).before = { of: mesh, choice, count };
  return count;
}

/** null where they could not be counted. */
export async function countTypesOf(page: Page, shape: Shape): Promise<TypeCount | null> {
  const choice = page.typesChoice.peek();
  const before = await countBefore(page, choice);
  const now = before === null ? null : await countOf(page, choice, shape);
  return before === null || now === null ? null : { now, before };
}

/** null where nobody asked for types yet, too. */
export const countTypes = async (page: Page, shape: Shape): Promise<TypeCount | null> =>
  page.shownTypes.peek() ? countTypesOf(page, shape) : null;
