// SPDX-License-Identifier: MIT
// Hides what is selected, the panels at points or one panel, or shows it alone.
import eyeOff from "lucide-static/icons/eye-off.svg?raw";
import focus from "lucide-static/icons/focus.svg?raw";
import { CommandButton } from "../../ui/command-button.tsx";
import { COMMANDS } from "../../ui/commands/commands.ts";
import { Drawing } from "../../ui/icon.tsx";
import "./sight-tools.css";

export function SightTools() {
  return (
    <span class="sight-tools">
      <CommandButton
        look="tool"
        icon={<Drawing markup={eyeOff} />}
        command={COMMANDS.hide}
        hint="the panels at the selected points, or the selected one; the design keeps them"
      />
      <CommandButton
        look="tool"
        icon={<Drawing markup={focus} />}
        command={COMMANDS.isolate}
        hint="those at the selected points, or the selected one"
      />
    </span>
  );
}
