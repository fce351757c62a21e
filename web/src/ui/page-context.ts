// SPDX-License-Identifier: MIT
import { createContext } from "preact";
import { useContext } from "preact/hooks";
import type { Page } from "../state/page.ts";

const Context = createContext<Page | null>(null);

export const PageProvider = Context.Provider;

/** The page that a component is part of. */
export function usePage(): Page {
  const page = useContext(Context);
  if (!page) throw new Error("a component outside of a page");
  return page;
}
