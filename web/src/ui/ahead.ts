// SPDX-License-Identifier: MIT
// What a field shows while the design still follows: keys come faster than results, and an answer
// to an earlier key must not undo a later one.
import { useSignal } from "@preact/signals";
import { kept } from "../state/page.ts";
import { usePage } from "./page-context.ts";

/** Resolves once `value` is what the design has. `burst`: the keys that set it; null if none did. */
export type Apply = (value: number, burst: string | null) => unknown;

interface Ahead {
  /** What to show. */
  readonly value: number;
  readonly set: (wanted: number) => void;
  readonly apply: (wanted: number, apply: Apply) => Promise<void>;
  /** Keys pressed from here to the end of the burst are one step of the history. */
  readonly beginBurst: () => void;
  readonly endBurst: () => void;
}

/** How many bursts of keys there were: each is named by its number. */
const bursts = kept(() => ({ count: 0 }));

export function useAhead(name: string, applied: number): Ahead {
  const page = usePage();
  const ahead = useSignal<number | null>(null);
  const burst = useSignal<string | null>(null);
  return {
    value: ahead.value ?? applied,
    set: (wanted) => {
      ahead.value = wanted;
    },
    apply: async (wanted, apply) => {
      await apply(wanted, burst.value);
      if (ahead.value === wanted) ahead.value = null;
    },
    beginBurst: () => {
      burst.value ??= `${name} ${++bursts(page).count}`;
    },
    endBurst: () => {
      burst.value = null;
    },
  };
}
