// SPDX-License-Identifier: MIT

import { useSignal } from "@preact/signals";
import type { ComponentChild } from "preact";
import { useRef } from "preact/hooks";
import { fetchPart } from "../../state/later.ts";
import { CommandButton } from "../../ui/command-button.tsx";
import { COMMANDS } from "../../ui/commands/commands.ts";
import { useDoors } from "../../ui/commands/doors.ts";
import { Dialog } from "../../ui/dialog.tsx";
import { Icon } from "../../ui/icon.tsx";
import { usePage } from "../../ui/page-context.ts";

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
  useDoors({ share: open });
  return (
    <>
      <CommandButton look="bar-button" icon={<Icon name="share" />} command={COMMANDS.share} />
      <Dialog dialog={dialog} id="share" title="Share this design">
        {content.value}
      </Dialog>
    </>
  );
}
