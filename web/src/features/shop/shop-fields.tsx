// SPDX-License-Identifier: MIT
// What the dialogs for the workshop ask for.
import { usePage } from "../../ui/page-context.ts";
import "./shop-fields.css";
import type { Signal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { UNITS, type Unit, unitWord } from "../../quantity/units.ts";
import { type Scope, selectedPanels } from "./shop.ts";

interface LengthProps {
  readonly label: string;
  readonly value: Signal<string>;
  /** What an empty field stands for. */
  readonly otherwise?: string;
  readonly min?: string;
}

const idOf = (label: string): string => `shop-${label.replace(/\W+/g, "-")}`;

/** A number, empty for what it says. */
export function NumberRow({ label, value, otherwise = "none", min = "0" }: LengthProps) {
  return (
    <>
      <label for={idOf(label)}>{label}</label>
      <input
        id={idOf(label)}
        type="number"
        min={min}
        step="any"
        placeholder={otherwise}
        value={value.value}
        onInput={({ currentTarget }) => {
          value.value = currentTarget.value;
        }}
      />
    </>
  );
}

interface TextProps {
  readonly label: string;
  readonly value: Signal<string>;
  /** How it is written. */
  readonly placeholder: string;
}

export function TextRow({ label, value, placeholder }: TextProps) {
  return (
    <>
      <label for={idOf(label)}>{label}</label>
      <input
        id={idOf(label)}
        type="text"
        spellcheck={false}
        placeholder={placeholder}
        value={value.value}
        onInput={({ currentTarget }) => {
          value.value = currentTarget.value;
        }}
      />
    </>
  );
}

interface ChoiceProps<T extends string> {
  readonly label: string;
  readonly value: Signal<T>;
  readonly choices: readonly { readonly value: T; readonly text: string; readonly off?: boolean }[];
}

/** One of several. */
export function ChoiceRow<T extends string>({ label, value, choices }: ChoiceProps<T>) {
  return (
    <>
      <label for={idOf(label)}>{label}</label>
      <select
        id={idOf(label)}
        class="select"
        value={value.value}
        onChange={({ currentTarget }) => {
          const chosen = choices.find((choice) => choice.value === currentTarget.value);
          if (chosen) value.value = chosen.value;
        }}
      >
        {choices.map((choice) => (
          <option key={choice.value} value={choice.value} disabled={choice.off ?? false}>
            {choice.text}
          </option>
        ))}
      </select>
    </>
  );
}

/** On or off. */
export function SwitchRow({ label, value }: { label: string; value: Signal<boolean> }) {
  return (
    <>
      <label for={idOf(label)}>{label}</label>
      <input
        id={idOf(label)}
        type="checkbox"
        checked={value.value}
        onChange={({ currentTarget }) => {
          value.value = currentTarget.checked;
        }}
      />
    </>
  );
}

export function UnitRow({ label, value }: { label: string; value: Signal<Unit> }) {
  const choices = UNITS.map((word) => ({ value: word, text: unitWord(word) }));
  return <ChoiceRow label={label} value={value} choices={choices} />;
}

export function ScopeRow({ label, value }: { label: string; value: Signal<Scope> }) {
  const page = usePage();
  const count = selectedPanels(page).length;
  const choices = [
    { value: "all", text: "All panels" },
    { value: "remake", text: "What must be made again" },
    { value: "selected", text: `What is selected (${count})`, off: count === 0 },
  ] as const;
  return <ChoiceRow label={label} value={value} choices={choices} />;
}

interface FormProps {
  readonly save: string;
  readonly onSave: () => Promise<void>;
  /** What was saved, in words. */
  readonly said: string | null;
  /** Why it cannot be saved like this, which the rows say. */
  readonly refused?: string;
  readonly children: ComponentChildren;
}

/** The rows of a dialog, and the button that saves. */
export function ShopForm({ save, onSave, said, refused = "", children }: FormProps) {
  const page = usePage();
  return (
    <form
      class="shop-form"
      onSubmit={(event) => {
        event.preventDefault();
        if (!refused) void onSave();
      }}
    >
      {children}
      <div class="dialog-actions">
        <span aria-live="polite">{said}</span>
        <button type="submit" class="button" disabled={page.busy.value || refused !== ""}>
          {save}
        </button>
      </div>
    </form>
  );
}
