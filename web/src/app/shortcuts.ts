// SPDX-License-Identifier: MIT

import type { Page } from "../state/page.ts";
import { refusalOf } from "../ui/commands/command.ts";
import { commandOf, commandsAtOnce } from "../ui/commands/commands.ts";
import { isHeard, spelled } from "../ui/commands/keys.ts";

function down(page: Page, event: KeyboardEvent): void {
  const key = spelled(event);
  const command = commandOf(page, key);
  if (!command || event.defaultPrevented || !isHeard(command.heard, event.target)) return;
  event.preventDefault();
  // A key that is held says so again and again.
  if (event.repeat && command.release) return;
  if (!refusalOf(page, command)) void command.run(page, key);
}

function up(page: Page, event: KeyboardEvent): void {
  commandOf(page, event.key.toUpperCase())?.release?.(page);
}

function letGo(page: Page): void {
  for (const { release } of commandsAtOnce(page)) release?.(page);
}

/** Keys from now on run commands. Returns how to stop listening. */
export function listenToShortcuts(page: Page): () => void {
  const off = new AbortController();
  window.addEventListener("keydown", (event) => down(page, event), { signal: off.signal });
  window.addEventListener("keyup", (event) => up(page, event), { signal: off.signal });
  window.addEventListener("blur", () => letGo(page), { signal: off.signal });
  return () => off.abort();
}
