// SPDX-License-Identifier: MIT
import type { ComponentChild } from "preact";
import { type Command, refusalOf, titleOf } from "./commands/command.ts";
import { usePage } from "./page-context.ts";

interface CommandButtonProps {
  /** Classes of the button. */
  readonly look: string;
  readonly command: Command;
  /** Stands before the label, which gives way to it where there is little room. */
  readonly icon?: ComponentChild;
  /** A few words for its title. */
  readonly hint?: string;
}

/** A button that runs a command, or says why it cannot run now. */
export function CommandButton({ look, command, icon, hint }: CommandButtonProps) {
  const page = usePage();
  return (
    <button
      type="button"
      class={look}
      data-word={icon ? command.name : undefined}
      disabled={refusalOf(page, command) !== ""}
      title={titleOf(page, command, hint)}
      onClick={() => void command.run(page, "")}
    >
      {icon ? (
        <>
          {icon}
          <span class="bar-label">{command.label}</span>
        </>
      ) : (
        (command.name ?? command.label)
      )}
    </button>
  );
}
