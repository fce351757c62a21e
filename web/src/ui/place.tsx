// SPDX-License-Identifier: MIT
import type { ComponentType } from "preact";
import { kept, type Page } from "../state/page.ts";
import { later } from "./later.tsx";
import { usePage } from "./page-context.ts";

/** A place among the controls: draws what features put there, on each page its own, in that order. */
export function place<P extends object = object>() {
  const parts = kept((): ComponentType<P>[] => []);
  const put = (page: Page, Part: ComponentType<P>): void => void parts(page).push(Part);
  return Object.assign(
    (props: P) => parts(usePage()).map((Part, k) => <Part key={k} {...props} />),
    {
      put,
      /** Puts there the component `name` of a module that comes once the page can be used. */
      later: <Name extends string>(
        page: Page,
        name: Name,
        load: () => Promise<Readonly<Record<Name, ComponentType<P>>>>,
      ): void => {
        put(
          page,
          later(() => load().then((part) => part[name])),
        );
      },
    },
  );
}

export type Place = ReturnType<typeof place<object>>;
