// SPDX-License-Identifier: MIT
import { useSignal } from "@preact/signals";

interface SliderProps {
  readonly label: string;
  readonly value: number;
  readonly min: number;
  readonly max: number;
  readonly step: number;
  readonly disabled: boolean;
  /** What the two ends mean, in words. */
  readonly ends?: readonly [string, string];
  readonly shown?: string;
  /** The value with its unit, where `shown` alone does not say it. */
  readonly spoken?: string;
  readonly onInput: (value: number) => void;
  /** Resolves once `value` is what the design has. Keys pressed while the slider keeps the focus
   * are one burst; null for a pointer. */
  readonly onCommit: (value: number, burst: string | null) => void | Promise<void>;
}

const KEYS = /^(Arrow|Page|Home|End)/;
let bursts = 0;

export function Slider(props: SliderProps) {
  const { label, min, max, step, disabled, ends, onInput, onCommit } = props;
  /** Set by the user and not in the design yet: an answer to an earlier key must not undo it. */
  const ahead = useSignal<number | null>(null);
  const value = ahead.value ?? props.value;
  const burst = useSignal<string | null>(null);
  const noBurst = (): void => {
    burst.value = null;
  };
  const commit = async (wanted: number): Promise<void> => {
    await onCommit(wanted, burst.value);
    if (ahead.value === wanted) ahead.value = null;
  };
  const id = `slider-${label.toLowerCase().replace(/\W+/g, "-")}`;
  /** Where the filled part begins: zero if it lies inside, else the low end. */
  const rest = Math.max(min, Math.min(0, max));
  const share = (x: number): string => `${(100 * (x - min)) / (max - min)}%`;
  const shown = props.shown ?? String(value);
  const spoken = props.spoken ?? shown;
  return (
    <div class="slider">
      <label for={id}>{label}</label>
      <span class="slider-value" aria-hidden="true">
        {shown}
      </span>
      <input
        id={id}
        type="range"
        min={min}
        max={max}
        step={step}
        value={value}
        aria-valuetext={ends ? `${spoken}: from ${ends[0]} to ${ends[1]}` : spoken}
        disabled={disabled}
        style={{ "--from": share(Math.min(value, rest)), "--to": share(Math.max(value, rest)) }}
        onKeyDown={({ key }) => {
          if (KEYS.test(key)) burst.value ??= `${id} ${++bursts}`;
        }}
        onPointerDown={noBurst}
        onBlur={noBurst}
        onInput={({ currentTarget }) => {
          ahead.value = currentTarget.valueAsNumber;
          onInput(currentTarget.valueAsNumber);
        }}
        onChange={({ currentTarget }) => void commit(currentTarget.valueAsNumber)}
      />
      {ends && (
        <div class="slider-ends" aria-hidden="true">
          <span>{ends[0]}</span>
          <span>{ends[1]}</span>
        </div>
      )}
    </div>
  );
}
