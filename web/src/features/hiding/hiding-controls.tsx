// SPDX-License-Identifier: MIT
// Hides what is selected, the panels at points or one panel, or shows it alone.

import eyeOff from "lucide-static/icons/eye-off.svg?raw";
import focus from "lucide-static/icons/focus.svg?raw";
import { counted } from "../../quantity/counted.ts";
import { hiddenPanels } from "../../state/hidden-panels.ts";
import { CommandButton } from "../../ui/command-button.tsx";
import { Drawing } from "../../ui/icon.tsx";
import { usePage } from "../../ui/page-context.ts";
import { showAll } from "./hiding.ts";
import { HIDING_COMMANDS } from "./hiding-commands.ts";
import "./hiding-controls.css";
import "../../ui/offset-note.css";

const { hide, isolate } = HIDING_COMMANDS;

/** Among the tools of the selected points. */
export function SelectionSightTools() {
  return (
    <span class="strip-part">
      <CommandButton
        look="tool"
        command={hide}
        hint="those at these points; the design keeps them"
      />
      <CommandButton look="tool" command={isolate} hint="those at these points" />
    </span>
  );
}

export function SightTools() {
  return (
    <span class="sight-tools">
      <CommandButton
        look="tool"
        icon={<Drawing markup={eyeOff} />}
        command={hide}
        hint="the panels at the selected points, or the selected one; the design keeps them"
      />
      <CommandButton
        look="tool"
        icon={<Drawing markup={focus} />}
        command={isolate}
        hint="those at the selected points, or the selected one"
      />
    </span>
  );
}

/** Says that the view does not show everything, and offers the way back. */
export function HiddenNote() {
  const page = usePage();
  const { size } = hiddenPanels(page).value;
  if (size === 0) return null;
  return (
    <section class="offset-note" aria-label="Hidden panels">
      <span>{`${counted(size, "panel")} hidden in the view`}</span>
      <button
        type="button"
        class="button small"
        title="Show all (Shift H)"
        onClick={() => showAll(page)}
      >
        Show all
      </button>
    </section>
  );
}
