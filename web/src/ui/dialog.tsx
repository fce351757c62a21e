// SPDX-License-Identifier: MIT
import type { ComponentChildren, RefObject } from "preact";
import { Icon } from "./icon.tsx";

interface DialogProps {
  /** Opens by showModal, closes by close, Escape or its own button. */
  readonly dialog: RefObject<HTMLDialogElement | null>;
  readonly id: string;
  readonly title: string;
  /** Takes the width of the window. */
  readonly wide?: boolean | undefined;
  readonly onClose?: () => void;
  readonly children: ComponentChildren;
}

/** A modal dialog with its title and a button to close it. */
export function Dialog({ dialog, id, title, wide, onClose, children }: DialogProps) {
  return (
    <dialog
      ref={dialog}
      class={wide ? "dialog wide" : "dialog"}
      aria-labelledby={`${id}-title`}
      onClose={onClose}
    >
      <div class="dialog-head">
        <h2 id={`${id}-title`}>{title}</h2>
        <button
          type="button"
          class="icon-button"
          aria-label="Close"
          title="Close (Esc)"
          onClick={() => dialog.current?.close()}
        >
          <Icon name="close" />
        </button>
      </div>
      {children}
    </dialog>
  );
}
