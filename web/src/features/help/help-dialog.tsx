// SPDX-License-Identifier: MIT
import { useRef } from "preact/hooks";
import { CommandButton } from "../../ui/command-button.tsx";
import type { Command } from "../../ui/commands/command.ts";
import { door, useDoor } from "../../ui/commands/doors.ts";
import { Dialog } from "../../ui/dialog.tsx";
import { Icon } from "../../ui/icon.tsx";
import { later } from "../../ui/later.tsx";

const HelpText = later(() => import("./help-text.tsx").then((part) => part.HelpText));

const helpDoor = door();

export const HELP: Command = {
  label: "Help",
  run: (page) => helpDoor(page).open(),
};

export function HelpDialog() {
  const dialog = useRef<HTMLDialogElement>(null);
  useDoor(helpDoor, () => dialog.current?.showModal());
  return (
    <>
      <CommandButton look="bar-button" icon={<Icon name="help" />} command={HELP} />
      <Dialog dialog={dialog} id="help" title="How it works">
        <HelpText />
      </Dialog>
    </>
  );
}
