// SPDX-License-Identifier: MIT
import { useDoors } from "../../ui/commands/doors.ts";
import { useLaterDialog } from "../../ui/later-dialog.tsx";

/** Where the palette opens; what is in it is fetched then. */
export function PaletteDialog() {
  const { open, element } = useLaterDialog("commands", async () => {
    const { CommandPalette } = await import("./command-palette.tsx");
    return { palette: { title: "Commands", Content: CommandPalette } };
  });
  useDoors({ palette: () => open("palette") });
  return element;
}
