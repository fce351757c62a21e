// SPDX-License-Identifier: MIT
// Ranges of the axes for the keyboard: from and to of every axis, and choices of words.
import { type Filter, type Interval, withInterval, withWord } from "./filter.ts";
import type { Axis, Choice } from "./table.ts";

interface Props {
  readonly filter: Filter;
  readonly onFilter: (filter: Filter) => void;
}

const numberOf = (text: string): number | null => (text === "" ? null : Number(text));
const shortened = (value: number): string => String(Number(value.toPrecision(4)));

function Range({ axis, filter, onFilter }: Props & { readonly axis: Axis }) {
  const { column, label, low, high } = axis;
  const said: Interval = filter.intervals.get(column) ?? { from: null, to: null };
  const field = (end: "from" | "to", hint: number) => (
    <input
      type="number"
      step="any"
      aria-label={`${label}, ${end}`}
      placeholder={shortened(hint)}
      value={said[end] === null ? "" : shortened(said[end])}
      onChange={({ currentTarget }) =>
        onFilter(withInterval(filter, column, { ...said, [end]: numberOf(currentTarget.value) }))
      }
    />
  );
  return (
    <fieldset class="range">
      <legend>{label}</legend>
      {field("from", low)} to {field("to", high)}
    </fieldset>
  );
}

function WordChoice({ choice, filter, onFilter }: Props & { readonly choice: Choice }) {
  const { column, label, words } = choice;
  return (
    <label class="range">
      {label}
      <select
        value={filter.words.get(column) ?? ""}
        onChange={({ currentTarget }) => onFilter(withWord(filter, column, currentTarget.value))}
      >
        <option value="">all</option>
        {words.map((word) => (
          <option key={word}>{word}</option>
        ))}
      </select>
    </label>
  );
}

export function Ranges({
  axes,
  choices,
  ...rest
}: Props & { readonly axes: readonly Axis[]; readonly choices: readonly Choice[] }) {
  return (
    <div class="ranges">
      {axes.map((axis) => (
        <Range key={axis.column} axis={axis} {...rest} />
      ))}
      {choices.map((choice) => (
        <WordChoice key={choice.column} choice={choice} {...rest} />
      ))}
    </div>
  );
}
