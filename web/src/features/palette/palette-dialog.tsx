// SPDX-License-Identifier: MIT
import { paletteDoor, useDoor } from "../../ui/commands/doors.ts";
import { laterCommands } from "../../ui/commands/offered-commands.ts";
import { useLaterDialog } from "../../ui/later-dialog.tsx";
import { usePage } from "../../ui/page-context.ts";

/** Where the palette opens; what is in it is fetched then. */
export function PaletteDialog() {
  const page = usePage();
  const { open, element } = useLaterDialog("commands", async () => {
    const { CommandPalette } = await import("./command-palette.tsx");
    const more = (await Promise.all(laterCommands(page).map((list) => list()))).flat();
    return { palette: { title: "Commands", Content: () => <CommandPalette more={more} /> } };
  });
  useDoor(paletteDoor, () => open("palette"));
  return element;
}
