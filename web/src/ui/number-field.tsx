// SPDX-License-Identifier: MIT

import { useSignal } from "@preact/signals";
import { parseLength } from "../quantity/expression.ts";
import { formatCoordinate, type Unit, unitWord } from "../quantity/units.ts";
import { say } from "../state/telling.ts";
import { type Apply, useAhead } from "./ahead.ts";
import { usePage } from "./page-context.ts";

interface NumberFieldProps {
  readonly label: string;
  readonly value: number;
  readonly unit: Unit;
  /** One press of an arrow key; ten times as much with Shift. */
  readonly step: number;
  readonly disabled: boolean;
  readonly context: string;
  /** Whether it is a place, not an amount: a minus alone goes to the other side of 0. */
  readonly place?: boolean;
  /** Arrow keys pressed while the field keeps the focus are one burst; what is typed makes none. */
  readonly onApply: Apply;
}

/** Places beyond 0 are rare where they were not before: it may have been meant as an amount. */
const meantAsAmount = (typed: string, before: number, after: number): boolean =>
  /^-[^=]/.test(typed) && before > 0 && after < 0;

/** A coordinate: typed with units and arithmetic, applied by Enter or on leaving. */
export function NumberField({
  label,
  value: applied,
  unit,
  step,
  disabled,
  context,
  place = false,
  onApply,
}: NumberFieldProps) {
  const page = usePage();
  /** What is being typed; null while the field only shows the value. */
  const text = useSignal<string | null>(null);
  const invalid = useSignal(false);
  const ahead = useAhead(label, applied);
  const { value } = ahead;

  const applyTyped = async (typed: string, wanted: number): Promise<void> => {
    const doubtful = place && meantAsAmount(typed, value, wanted);
    await onApply(wanted, null);
    if (doubtful)
      page.notice.value ??= `${label}: ${typed} is a place. To move by it, type -=${typed.slice(1)}.`;
  };

  const apply = (): void => {
    const typed = text.value?.trim() ?? null;
    if (typed === null || typed === formatCoordinate(value)) {
      text.value = null;
      return;
    }
    const parsed = parseLength(typed, value, unit);
    invalid.value = !parsed.ok;
    if (parsed.ok) {
      text.value = null;
      void applyTyped(typed, parsed.value);
    } else say(page, `${label}: ${parsed.reason}`);
  };

  const stepTo = (wanted: number): void => {
    ahead.set(wanted);
    ahead.beginBurst();
    void ahead.apply(wanted, onApply);
  };

  const onKeyDown = (event: KeyboardEvent): void => {
    if (event.key === "Enter") apply();
    else if (event.key === "Escape") {
      text.value = null;
      invalid.value = false;
    } else if (event.key === "ArrowUp" || event.key === "ArrowDown") {
      event.preventDefault();
      const size = event.shiftKey ? 10 * step : step;
      text.value = null;
      stepTo(value + (event.key === "ArrowUp" ? size : -size));
    }
  };

  return (
    <input
      type="text"
      role="spinbutton"
      inputMode="text"
      autocomplete="off"
      spellcheck={false}
      class="number"
      aria-label={label}
      aria-description={`${unitWord(unit)}, ${context}`}
      aria-valuenow={value}
      aria-valuetext={`${formatCoordinate(value)} ${unitWord(unit)}`}
      aria-invalid={invalid.value}
      title={`${label} = ${value} ${unit}${place ? "; +1 and -=1 move by 1, -1 is a place" : ""}`}
      disabled={disabled}
      value={text.value ?? formatCoordinate(value)}
      onFocus={({ currentTarget }) => currentTarget.select()}
      onInput={({ currentTarget }) => {
        text.value = currentTarget.value;
      }}
      onBlur={() => {
        ahead.endBurst();
        apply();
      }}
      onKeyDown={onKeyDown}
    />
  );
}
