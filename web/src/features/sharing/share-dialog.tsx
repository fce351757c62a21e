// SPDX-License-Identifier: MIT

import { useSignal } from "@preact/signals";
import type { ComponentChild } from "preact";
import { useRef } from "preact/hooks";
import { fetchPart } from "../../state/later.ts";
import { CommandButton } from "../../ui/command-button.tsx";
import { type Command, notReady } from "../../ui/commands/command.ts";
import { door, useDoor } from "../../ui/commands/doors.ts";
import { Dialog } from "../../ui/dialog.tsx";
import { Icon } from "../../ui/icon.tsx";
import { usePage } from "../../ui/page-context.ts";

const shareDoor = door();

export const SHARE: Command = {
  label: "Share",
  refusal: notReady,
  run: (page) => shareDoor(page).open(),
};

export function ShareDialog() {
  const page = usePage();
  const dialog = useRef<HTMLDialogElement>(null);
  const content = useSignal<ComponentChild>(null);
  const open = async (): Promise<void> => {
    const part = await fetchPart(page, () => import("./shared-link.tsx"));
    const shared = await part?.share(page);
    if (!part || !shared) return;
    const close = (): void => dialog.current?.close();
    // Begins with the link as it is now, whatever was chosen for the last.
    content.value = <part.SharedLink key={shared.link} shared={shared} onClose={close} />;
    dialog.current?.showModal();
  };
  useDoor(shareDoor, open);
  return (
    <>
      <CommandButton look="bar-button" icon={<Icon name="share" />} command={SHARE} />
      <Dialog dialog={dialog} id="share" title="Share this design">
        {content.value}
      </Dialog>
    </>
  );
}
