// SPDX-License-Identifier: MIT
// Dialogs, for commands that open them from elsewhere: whatever has one says here how it opens.
import { useEffect } from "preact/hooks";
import { kept } from "../../state/page.ts";
import { usePage } from "../page-context.ts";

/** One on each page, which stays shut until something says how it opens. */
export const door = () => kept(() => ({ open: (): unknown => undefined }));

export const paletteDoor = door();

/** Says how it opens for as long as the component is there; `open` is that of the first time. */
export function useDoor(which: ReturnType<typeof door>, open: () => unknown): void {
  const mine = which(usePage());
  useEffect(() => {
    const shut = mine.open;
    mine.open = open;
    return () => {
      mine.open = shut;
    };
  }, []);
}
