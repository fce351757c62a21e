// SPDX-License-Identifier: MIT

import { CommandButton } from "../../ui/command-button.tsx";
import { useDoors } from "../../ui/commands/doors.ts";
import { MORE_COMMANDS } from "../../ui/commands/more-commands.ts";
import { useLaterDialog } from "../../ui/later-dialog.tsx";
import { usePage } from "../../ui/page-context.ts";
import { chooseFirst } from "./comparing.ts";

/** The button that opens it, once there are two designs of the mesh. */
export function CompareDialog() {
  const page = usePage();
  const { open, element } = useLaterDialog("compare", async () => {
    const { CompareDesigns } = await import("./compare-designs.tsx");
    chooseFirst(page);
    return { compare: { title: "Compare", wide: true, Content: CompareDesigns } };
  });
  useDoors({ compare: () => open("compare") });
  return (
    <>
      <CommandButton look="button wide" command={MORE_COMMANDS.compare} />
      {element}
    </>
  );
}
