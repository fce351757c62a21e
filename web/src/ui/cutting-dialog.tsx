// SPDX-License-Identifier: MIT
import { useSignal } from "@preact/signals";
import type { ComponentChild } from "preact";
import { useRef } from "preact/hooks";
import { fetchPart } from "../state/later.ts";
import { Dialog } from "./dialog.tsx";

/** The dialog for a cutting package; what is in it is fetched when it opens for the first time. */
export function useCuttingDialog(): {
  readonly open: () => Promise<void>;
  readonly element: ComponentChild;
} {
  const dialog = useRef<HTMLDialogElement>(null);
  const content = useSignal<ComponentChild>(null);
  const open = async (): Promise<void> => {
    const part = await fetchPart(() => import("./cutting-package.tsx"));
    if (!part) return;
    content.value = <part.CuttingPackage />;
    dialog.current?.showModal();
  };
  const element = (
    <Dialog dialog={dialog} id="cutting-package" title="Cutting package">
      {content.value}
    </Dialog>
  );
  return { open, element };
}
