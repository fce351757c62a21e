// SPDX-License-Identifier: MIT
import { useSignal } from "@preact/signals";
import type { ComponentChild, FunctionComponent } from "preact";
import { useRef } from "preact/hooks";
import { fetchPart } from "../state/later.ts";
import { Dialog } from "./dialog.tsx";

export interface DialogPart {
  readonly title: string;
  readonly Content: FunctionComponent;
}

/** One dialog for several contents, which are fetched when one of them opens for the first time; what
 * is in it ends when it closes. */
export function useLaterDialog<Name extends string>(
  id: string,
  load: () => Promise<Readonly<Record<Name, DialogPart>>>,
): { readonly open: (name: Name) => Promise<void>; readonly element: ComponentChild } {
  const dialog = useRef<HTMLDialogElement>(null);
  const part = useSignal<DialogPart | null>(null);
  const open = async (name: Name): Promise<void> => {
    part.value = (await fetchPart(load))?.[name] ?? null;
    if (part.value) dialog.current?.showModal();
  };
  const close = (): void => {
    part.value = null;
  };
  const shown = part.value;
  const element = (
    <Dialog dialog={dialog} id={id} title={shown?.title ?? ""} onClose={close}>
      {shown && <shown.Content />}
    </Dialog>
  );
  return { open, element };
}
