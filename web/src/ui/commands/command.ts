// SPDX-License-Identifier: MIT
// A command: something that the page can be told to do, whether by a key, a button or the palette.
import type { Page } from "../../state/page.ts";

export interface Command {
  /** As its button says it. */
  readonly label: string;
  /** Shorter, among others whose place says what they are about. */
  readonly name?: string;
  /** Spelled as in keys.ts; the first is the one that is said. */
  readonly keys?: readonly string[];
  /** Where its keys are heard; outside of fields that take text where nothing is said. */
  readonly heard?: Heard;
  /** Why it cannot run now, as a sentence; "" where it can. */
  readonly refusal?: (page: Page) => string;
  /** @param key the one that was pressed; "" for a button */
  readonly run: (page: Page, key: string) => unknown;
  /** Called when its key is let go of, or the window left while it is held. */
  readonly release?: (page: Page) => void;
  /** Means something by its keys alone: the palette does not list it. */
  readonly unlisted?: true;
}

/**
 * everywhere: in fields too. view: nowhere that letters are typed or a dialog or menu is open. arrows: as
 * view, and nowhere that arrows move or scroll something else.
 */
export type Heard = "everywhere" | "view" | "arrows";

/** Why nothing can be done to a design that is only looked at; "" where it is not. */
export const onlyLookedAt = (page: Page): string =>
  page.readOnly.value ? "This design can only be looked at." : "";

/** Why a command that needs the solver cannot run yet. */
export const notReady = (page: Page): string =>
  onlyLookedAt(page) || (page.ready.value ? "" : "The solver is not there yet.");

export const refusalOf = (page: Page, command: Command): string => command.refusal?.(page) ?? "";

/** "Ctrl Shift Z"; "" without one. */
export const keyOf = ({ keys }: Command): string => (keys?.[0] ?? "").replace(/\+(?=.)/g, " ");

/** What a button says while the pointer rests on it: "Undo (Ctrl Z)", and why it cannot be pressed, or
 * a hint. */
export function titleOf(page: Page, command: Command, hint = ""): string {
  const key = keyOf(command);
  const name = key ? `${command.label} (${key})` : command.label;
  const more = refusalOf(page, command) || hint;
  return more ? `${name}: ${more}` : name;
}
