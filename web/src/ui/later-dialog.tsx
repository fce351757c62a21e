// SPDX-License-Identifier: MIT

import { useSignal } from "@preact/signals";
import type { ComponentChild, FunctionComponent } from "preact";
import { useRef } from "preact/hooks";
import { fetchPart } from "../state/later.ts";
import { Dialog } from "./dialog.tsx";
import { usePage } from "./page-context.ts";

export interface DialogPart {
  readonly title: string;
  /** Takes the width of the window. */
  readonly wide?: boolean;
  readonly Content: FunctionComponent;
}

/** One dialog for several contents, which are fetched when one of them opens for the first time; what
 * is in it ends when it closes. */
export function useLaterDialog<Name extends string>(
  id: string,
  load: () => Promise<Readonly<Record<Name, DialogPart>>>,
): { readonly open: (name: Name) => Promise<void>; readonly element: ComponentChild } {
  const page = usePage();
  const dialog = useRef<HTMLDialogElement>(null);
  const part = useSignal<DialogPart | null>(null);
  const open = async (name: Name): Promise<void> => {
    const found = (await fetchPart(page, load))?.[name];
    if (!found) return;
    part.value = { ...found }; // what is in it begins anew
    dialog.current?.showModal();
  };
  // The event comes later than the closing: it may be open again.
  const close = (): void => {
    if (!dialog.current?.open) part.value = null;
  };
  const shown = part.value;
  const element = (
    <Dialog dialog={dialog} id={id} title={shown?.title ?? ""} wide={shown?.wide} onClose={close}>
      {shown && <shown.Content key={shown} />}
    </Dialog>
  );
  return { open, element };
}
