// SPDX-License-Identifier: MIT
// The dialogs for the workshop: where they open, and what the menu Export says of them.
import { notReady } from "../../ui/commands/command.ts";
import { door, useDoor } from "../../ui/commands/doors.ts";
import type { ExportCommand } from "../../ui/commands/export-commands.ts";
import { useLaterDialog } from "../../ui/later-dialog.tsx";

const DOORS = { package: door(), drawings: door(), ifc: door() };

const dialog = (name: string, about: string, which: keyof typeof DOORS): ExportCommand => ({
  label: name,
  name,
  about,
  refusal: notReady,
  run: (page) => DOORS[which](page).open(),
});

export const SHOP_EXPORTS = [
  dialog("Cutting package…", "DXF and tables (zip)", "package"),
  dialog("Drawings…", "Plan, elevations, section", "drawings"),
  dialog("IFC…", "Plates for building models", "ifc"),
];

export function ShopDialogs() {
  const { open, element } = useLaterDialog("shop", async () => {
    const { shopDialogs } = await import("./shop-dialogs.ts");
    return shopDialogs;
  });
  useDoor(DOORS.package, () => open("package"));
  useDoor(DOORS.drawings, () => open("drawings"));
  useDoor(DOORS.ifc, () => open("ifc"));
  return element;
}
