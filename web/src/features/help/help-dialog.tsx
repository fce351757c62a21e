// SPDX-License-Identifier: MIT
import { useRef } from "preact/hooks";
import { CommandButton } from "../../ui/command-button.tsx";
import { COMMANDS } from "../../ui/commands/commands.ts";
import { useDoors } from "../../ui/commands/doors.ts";
import { Dialog } from "../../ui/dialog.tsx";
import { Icon } from "../../ui/icon.tsx";
import { later } from "../../ui/later.tsx";

const HelpText = later(() => import("./help-text.tsx").then((part) => part.HelpText));

export function HelpDialog() {
  const dialog = useRef<HTMLDialogElement>(null);
  useDoors({ help: () => dialog.current?.showModal() });
  return (
    <>
      <CommandButton look="bar-button" icon={<Icon name="help" />} command={COMMANDS.help} />
      <Dialog dialog={dialog} id="help" title="How it works">
        <HelpText />
      </Dialog>
    </>
  );
}
