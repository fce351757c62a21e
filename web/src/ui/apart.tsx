// SPDX-License-Identifier: MIT
import { signal } from "@preact/signals";
import type { ComponentType } from "preact";
import { fetchPart } from "../state/later.ts";
import { kept } from "../state/page.ts";
import { usePage } from "./page-context.ts";

/** A part of the page that is fetched once it is to be drawn and the page can be used; nothing is there before.
 * A file of its own, where its caller fetches nothing by `later()`. */
export function apart<P extends object = object>(
  load: () => Promise<ComponentType<P>>,
): ComponentType<P> {
  const own = kept(() => ({ part: signal<ComponentType<P> | null>(null), asked: false }));
  return function Apart(props: P) {
    const page = usePage();
    const mine = own(page);
    const Part = mine.part.value;
    if (Part) return <Part {...props} />;
    if (page.ready.value && !mine.asked) {
      mine.asked = true;
      void fetchPart(page, load).then((part) => {
        mine.part.value = part;
        mine.asked = part !== null;
      });
    }
    return null;
  };
}
