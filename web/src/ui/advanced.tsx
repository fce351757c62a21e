// SPDX-License-Identifier: MIT
import type { EditSettings } from "../solver/protocol.ts";
import { DEFAULT_SETTINGS } from "../state/design.ts";
import { commitSettings } from "../state/editing.ts";
import { ready, settings } from "../state/store.ts";

interface ChoiceProps<T extends string> {
  readonly label: string;
  readonly value: T;
  readonly words: readonly (readonly [T, string])[];
  readonly onChoose: (value: T) => void;
}

function Choice<T extends string>({ label, value, words, onChoose }: ChoiceProps<T>) {
  return (
    <label class="field">
      <span>{label}</span>
      <select
        class="select"
        value={value}
        disabled={!ready.value}
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

const choose = (change: Partial<EditSettings>): void => void commitSettings(change);

const FAIRNESS = [
  ["laplacian", "Laplacian"],
  ["second", "Second differences"],
  ["third", "Third differences"],
] as const;

const ENGINES = [
  ["newton", "Newton, fast"],
  ["alm", "Augmented Lagrangian, the paper's"],
] as const;

const TOLERANCES: readonly (readonly [string, string])[] = [
  ["0.000001", "0.000001 mm/m"],
  ["0.001", "0.001 mm/m"],
  ["1", "1 mm/m"],
];

/** The settings that few need; the defaults are the command line's. */
export function Advanced() {
  const { fairness, engine, hardHandles, tolerance } = settings.value ?? DEFAULT_SETTINGS;
  const known = TOLERANCES.find(([value]) => Number(value) === tolerance);
  // A link or a file may have set another.
  const given = [String(tolerance), `${tolerance} mm/m`] as const;
  return (
    <details class="disclosure">
      <summary>Advanced</summary>
      <Choice
        label="Fairness"
        value={fairness}
        words={FAIRNESS}
        onChoose={(value) => choose({ fairness: value })}
      />
      <Choice
        label="Engine"
        value={engine}
        words={ENGINES}
        onChoose={(value) => choose({ engine: value })}
      />
      <Choice
        label="Tolerance"
        value={known?.[0] ?? given[0]}
        words={known ? TOLERANCES : [...TOLERANCES, given]}
        onChoose={(value) => choose({ tolerance: Number(value) })}
      />
      <label class="check">
        <input
          type="checkbox"
          checked={hardHandles}
          disabled={!ready.value}
          onChange={({ currentTarget }) => choose({ hardHandles: currentTarget.checked })}
        />
        <span>Meet the targets exactly</span>
      </label>
    </details>
  );
}
