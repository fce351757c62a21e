// SPDX-License-Identifier: MIT

import { useSignal } from "@preact/signals";
import { parseLength } from "../quantity/expression.ts";
import { formatCoordinate, type Unit } from "../quantity/units.ts";
import type { Result } from "../result/result.ts";
import { say } from "../state/telling.ts";
import { usePage } from "./page-context.ts";

interface LimitFieldProps {
  readonly label: string;
  readonly about: string;
  readonly value: number;
  /** null: a plain number. */
  readonly unit: Unit | null;
  readonly invalid: boolean;
  /** What 0 is called; an empty field says it, too. */
  readonly zero?: string;
  readonly onApply: (value: number) => void;
}

function parse(text: string, unit: Unit | null, current: number): Result<number> {
  if (unit) return parseLength(text, current, unit);
  const value = text.trim() === "" ? Number.NaN : Number(text.replace(",", ".").replace("°", ""));
  if (Number.isFinite(value)) return { ok: true, value };
  return { ok: false, reason: `"${text.trim()}" is not a number.` };
}

/** One number of a limit, applied by Enter or on leaving; lengths take units and arithmetic. */
export function LimitField(props: LimitFieldProps) {
  const page = usePage();
  const { label, about, value, unit, invalid, zero, onApply } = props;
  const shown = zero !== undefined && value === 0 ? zero : formatCoordinate(value);
  const text = useSignal<string | null>(null);
  const unreadable = useSignal(false);

  const apply = (): void => {
    const typed = text.value;
    if (typed === null || typed === shown) {
      text.value = null;
      return;
    }
    const nought = zero !== undefined && ["", zero].includes(typed.trim());
    const parsed = nought ? ({ ok: true, value: 0 } as const) : parse(typed, unit, value);
    unreadable.value = !parsed.ok;
    if (parsed.ok) {
      text.value = null;
      onApply(parsed.value);
    } else say(page, `${label}: ${parsed.reason}`);
  };

  return (
    <input
      type="text"
      inputMode="text"
      autocomplete="off"
      spellcheck={false}
      class="number"
      aria-label={label}
      aria-description={about}
      aria-invalid={invalid || unreadable.value}
      disabled={!page.ready.value}
      value={text.value ?? shown}
      onFocus={({ currentTarget }) => currentTarget.select()}
      onInput={({ currentTarget }) => {
        text.value = currentTarget.value;
      }}
      onBlur={apply}
      onKeyDown={({ key }) => {
        if (key === "Enter") apply();
        else if (key === "Escape") {
          text.value = null;
          unreadable.value = false;
        }
      }}
    />
  );
}
