// SPDX-License-Identifier: MIT
// One of a few words, with its label.
import { usePage } from "./page-context.ts";

interface ChoiceProps<T extends string> {
  readonly label: string;
  readonly value: T;
  readonly words: readonly (readonly [T, string])[];
  readonly onChoose: (value: T) => void;
}

export function Choice<T extends string>({ label, value, words, onChoose }: ChoiceProps<T>) {
  const page = usePage();
  return (
    <label class="field">
      <span>{label}</span>
      <select
        class="select"
        value={value}
        disabled={!page.ready.value}
        onChange={({ currentTarget }) => {
          const chosen = words.find(([word]) => word === currentTarget.value);
          if (chosen) onChoose(chosen[0]);
        }}
      >
        {words.map(([word, text]) => (
          <option key={word} value={word}>
            {text}
          </option>
        ))}
      </select>
    </label>
  );
}
