// SPDX-License-Identifier: MIT
import { signal } from "@preact/signals";
import type { ComponentType } from "preact";
import { fetchPart } from "../state/later.ts";
import { ready } from "../state/store.ts";

/** A part of the page that comes by itself once the page can be used; nothing is there before. */
export function later<P extends object = object>(
  load: () => Promise<ComponentType<P>>,
): ComponentType<P> {
  const part = signal<ComponentType<P> | null>(null);
  let asked = false;
  const ask = async (): Promise<void> => {
    part.value = await fetchPart(load);
    asked = part.value !== null;
  };
  return function Later(props: P) {
    const Part = part.value;
    if (Part) return <Part {...props} />;
    if (ready.value && !asked) {
      asked = true;
      void ask();
    }
    return null;
  };
}
