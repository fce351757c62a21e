// SPDX-License-Identifier: MIT
import { isHidden } from "../state/hidden-panels.ts";
import type { Page } from "../state/page.ts";
import { refusedPull } from "../state/refused-pull.ts";
import { settled, shortfalls } from "../state/shortfall.ts";
import { displayPlace } from "./display-place.ts";
import type { Pull } from "./pull-lines.ts";

/** To where the handles were asked to go; those that stop on the way leave their target open. */
export function askedPulls(page: Page): Pull[] {
  const held = refusedPull(page).value;
  const short = new Set(shortfalls(page).value.flatMap((s) => (s.noticeable ? [s.vertex] : [])));
  const asked = (held?.handles ?? page.handles.value).filter(
    ({ vertex, pinned }) => !pinned && !isHidden(page, vertex),
  );
  return asked.map(({ vertex, target }) => {
    const open = held !== null || (settled(page).value && short.has(vertex));
    return { vertex, to: displayPlace(page, target), open };
  });
}
