// SPDX-License-Identifier: MIT
// Dialogs and menus, for commands that open them from elsewhere: whatever has one says here how it opens.
import { useEffect } from "preact/hooks";
import { kept, type Page } from "../../state/page.ts";
import { usePage } from "../page-context.ts";

export type Door = "compare" | "drawings" | "help" | "ifc" | "package" | "palette" | "share";

const doors = kept(() => new Map<Door, () => unknown>());

/** Does nothing where there is none. */
export const openDoor = (page: Page, name: Door): unknown => doors(page).get(name)?.();

/** Says how doors open for as long as the component is there; `open` is that of the first time. */
export function useDoors(open: Readonly<Partial<Record<Door, () => unknown>>>): void {
  const page = usePage();
  useEffect(() => {
    const names = Object.keys(open) as Door[];
    for (const name of names) doors(page).set(name, () => open[name]?.());
    return () => {
      for (const name of names) doors(page).delete(name);
    };
  }, []);
}
