// SPDX-License-Identifier: MIT
// The commands that features bring.
import { kept, type Page } from "../../state/page.ts";
import type { Command } from "./command.ts";

export interface CommandGroup {
  readonly of: readonly Command[];
  /** What Help says of their keys; "" where they have none. */
  readonly keysDo: string;
}

/** Those that have a key or a button from the start. */
export const commandGroups = kept((): CommandGroup[] => []);

export function offerCommands(page: Page, of: readonly Command[], keysDo = ""): void {
  commandGroups(page).push({ of, keysDo });
}

/** How those come that the palette alone has, as they are when it opens. */
export const laterCommands = kept((): (() => Promise<readonly Command[]>)[] => []);
