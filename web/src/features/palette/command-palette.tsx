// SPDX-License-Identifier: MIT
// Everything the page can be told, found by a few letters: a combobox whose list is always open.
import { useSignal } from "@preact/signals";
import "./command-palette.css";
import { useEffect, useLayoutEffect, useRef } from "preact/hooks";
import type { Page } from "../../state/page.ts";
import { allCommands } from "../../ui/commands/all-commands.ts";
import { type Command, keyOf, refusalOf } from "../../ui/commands/command.ts";
import { usePage } from "../../ui/page-context.ts";

/** How well a label meets what was typed; the less, the better. */
function rank(label: string, typed: string): number {
  const at = label.indexOf(typed);
  if (at < 0) return 3;
  return at === 0 ? 0 : label[at - 1] === " " ? 1 : 2;
}

/** The commands whose labels have every word that was typed, the best first. */
export function found(typed: string, commands: readonly Command[]): readonly Command[] {
  const sought = typed.trim().toLowerCase();
  const words = sought.split(/\s+/);
  const fits = ({ label }: Command): boolean =>
    words.every((word) => label.toLowerCase().includes(word));
  const by = (label: string): number => rank(label.toLowerCase(), sought);
  return commands.filter(fits).sort((a, b) => by(a.label) - by(b.label));
}

interface OptionProps {
  readonly command: Command;
  readonly id: string;
  readonly chosen: boolean;
  readonly onClick: () => void;
}

function Option({ command, id, chosen, onClick }: OptionProps) {
  const page = usePage();
  const option = useRef<HTMLDivElement>(null);
  useEffect(() => {
    if (chosen) option.current?.scrollIntoView({ block: "nearest" });
  }, [chosen]);
  const refusal = refusalOf(page, command);
  return (
    // biome-ignore lint/a11y/useKeyWithClickEvents: keys are the field's, which the focus stays in
    <div
      ref={option}
      id={id}
      class="palette-option"
      role="option"
      aria-selected={chosen}
      aria-disabled={refusal !== ""}
      tabIndex={-1}
      onMouseDown={(event) => event.preventDefault()}
      onClick={onClick}
    >
      <span>{command.label}</span>
      {refusal && <span class="palette-why">{refusal}</span>}
      {command.keys && <kbd class="palette-key">{keyOf(command)}</kbd>}
    </div>
  );
}

/** Where a key takes the choice in a list of `count`; null if it is not for the list. */
function moved(key: string, at: number, count: number): number | null {
  if (key === "ArrowDown") return (at + 1) % count;
  if (key === "ArrowUp") return (at + count - 1) % count;
  if (key === "PageDown") return Math.min(count - 1, at + 8);
  if (key === "PageUp") return Math.max(0, at - 8);
  return null;
}

/** The dialog is closed first, so that another may open. */
function run(page: Page, command: Command | undefined, field: HTMLInputElement | null): void {
  if (!command || refusalOf(page, command)) return;
  field?.closest("dialog")?.close();
  void command.run(page, "");
}

export function CommandPalette({ more }: { more: readonly Command[] }) {
  const page = usePage();
  const field = useRef<HTMLInputElement>(null);
  const typed = useSignal("");
  const at = useSignal(0);
  // The field takes the next key.
  useLayoutEffect(() => field.current?.focus(), []);
  const listed = allCommands(page, more).filter(({ unlisted }) => !unlisted);
  const offered = found(typed.value, listed);
  const onKeyDown = (event: KeyboardEvent): void => {
    if (event.isComposing || offered.length === 0) return;
    const next = moved(event.key, at.value, offered.length);
    if (next !== null) at.value = next;
    else if (event.key === "Enter") run(page, offered[at.value], field.current);
    else return;
    event.preventDefault();
  };
  return (
    <div class="palette">
      <input
        ref={field}
        type="text"
        class="palette-field"
        role="combobox"
        aria-label="Command"
        aria-expanded={true}
        aria-controls="palette-list"
        aria-autocomplete="list"
        aria-activedescendant={offered.length > 0 ? `palette-${at.value}` : undefined}
        autocomplete="off"
        spellcheck={false}
        placeholder="A few letters of a command"
        value={typed.value}
        onInput={({ currentTarget }) => {
          typed.value = currentTarget.value;
          at.value = 0;
        }}
        onKeyDown={onKeyDown}
      />
      <div id="palette-list" class="palette-list" role="listbox" aria-label="Commands">
        {offered.map((command, k) => (
          <Option
            key={command.label}
            command={command}
            id={`palette-${k}`}
            chosen={k === at.value}
            onClick={() => run(page, command, field.current)}
          />
        ))}
      </div>
      <p class="quiet small" aria-live="polite">
        {offered.length === 0 ? "No command has these letters." : ""}
      </p>
    </div>
  );
}
