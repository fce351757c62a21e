// SPDX-License-Identifier: MIT
import { type Apply, useAhead } from "./ahead.ts";

interface SliderProps {
  readonly label: string;
  readonly value: number;
  readonly min: number;
  readonly max: number;
  readonly step: number;
  readonly disabled: boolean;
  /** What the two ends mean, in words. */
  readonly ends?: readonly [string, string];
  /** What it does to the design on screen, said in the place of the ends; "" without one. */
  readonly effect?: string;
  readonly shown?: string;
  /** The value with its unit, where `shown` alone does not say it. */
  readonly spoken?: string;
  readonly onInput: (value: number) => void;
  /** Values from where on, downwards and upwards, it should not go; null for none. */
  readonly stops?: readonly [number | null, number | null] | undefined;
  /** Keys pressed while the slider keeps the focus are one burst; a pointer makes none. */
  readonly onCommit: Apply;
}

const KEYS = /^(Arrow|Page|Home|End)/;

export function Slider(props: SliderProps) {
  const { label, min, max, step, disabled, ends, stops, onInput, onCommit } = props;
  const id = `slider-${label.toLowerCase().replace(/\W+/g, "-")}`;
  const ahead = useAhead(id, props.value);
  const { value } = ahead;
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
          if (KEYS.test(key)) ahead.beginBurst();
        }}
        onPointerDown={ahead.endBurst}
        onBlur={ahead.endBurst}
        onInput={({ currentTarget }) => {
          ahead.set(currentTarget.valueAsNumber);
          onInput(currentTarget.valueAsNumber);
        }}
        onChange={({ currentTarget }) => void ahead.apply(currentTarget.valueAsNumber, onCommit)}
      />
      {stops && (
        <div class="slider-stops" aria-hidden="true">
          {stops[0] !== null && (
            <span class="low" style={{ width: `calc(${share(stops[0])} + 8px)` }} />
          )}
          {stops[1] !== null && (
            <span class="high" style={{ width: `calc(100% - ${share(stops[1])} + 8px)` }} />
          )}
        </div>
      )}
      {props.effect && <p class="quiet small effect">{props.effect}</p>}
      {ends && !props.effect && (
        <div class="slider-ends" aria-hidden="true">
          <span>{ends[0]}</span>
          <span>{ends[1]}</span>
        </div>
      )}
    </div>
  );
}
