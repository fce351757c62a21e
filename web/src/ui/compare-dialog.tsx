// SPDX-License-Identifier: MIT
import { chooseFirst } from "../state/comparing.ts";
import { CommandButton } from "./command-button.tsx";
import { useDoors } from "./commands/doors.ts";
import { MORE_COMMANDS } from "./commands/more-commands.ts";
import { useLaterDialog } from "./later-dialog.tsx";
import { usePage } from "./page-context.ts";

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
