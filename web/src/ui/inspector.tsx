// SPDX-License-Identifier: MIT

import { useSignalEffect } from "@preact/signals";
import type { ComponentProps } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { shownTab, TABS, type Tab } from "../state/inspector.ts";
import { Ask } from "./ask.tsx";
import { EditSection } from "./edit-section.tsx";
import { usePage } from "./page-context.ts";
import { OpenedFile, SECTIONS, Strips } from "./places.ts";

interface TabWords {
  readonly label: string;
  /** What its "?" explains. */
  readonly about: ComponentProps<typeof Ask>["about"];
}

const WORDS: Readonly<Record<Tab, TabWords>> = {
  edit: {
    label: "Edit",
    about: ["edit", "reach", "softness", "boundary", "circular", "conical"],
  },
  explore: { label: "Explore", about: "explore" },
  check: { label: "Check and make", about: "exact" },
};

/** Folds the controls, which are a sheet under the view on a telephone: folded, they leave it the room. */
export function SheetFold() {
  const page = usePage();
  const folded = page.sheetFolded;
  // What asks for attention is in there.
  useSignalEffect(() => {
    if (page.importReport.value || page.typedMove.value) folded.value = false;
  });
  return (
    <button
      type="button"
      class="sheet-fold"
      aria-expanded={!folded.value}
      aria-controls="inspector"
      onClick={() => {
        folded.value = !folded.value;
      }}
    >
      Controls
    </button>
  );
}

/** Where a key goes from a tab; null if it is not for tabs. */
function tabAfter(key: string, tab: Tab): Tab | null {
  const [at, count] = [TABS.indexOf(tab), TABS.length];
  const places: Readonly<Record<string, number>> = {
    ArrowRight: (at + 1) % count,
    ArrowLeft: (at + count - 1) % count,
    Home: 0,
    End: count - 1,
  };
  return TABS[places[key] ?? -1] ?? null;
}

function Tabs() {
  const page = usePage();
  const shown = shownTab(page);
  const list = useRef<HTMLDivElement>(null);
  return (
    <div class="tab-bar">
      <div
        ref={list}
        class="tabs"
        role="tablist"
        aria-label="Controls"
        onKeyDown={(event) => {
          const next = tabAfter(event.key, shown.value);
          if (!next) return;
          event.preventDefault();
          shown.value = next;
          list.current?.querySelector<HTMLElement>(`#tab-${next}`)?.focus();
        }}
      >
        {TABS.map((tab) => (
          <button
            key={tab}
            id={`tab-${tab}`}
            type="button"
            role="tab"
            class="tab"
            aria-selected={tab === shown.value}
            aria-controls={`panel-${tab}`}
            tabIndex={tab === shown.value ? 0 : -1}
            onClick={() => {
              shown.value = tab;
            }}
          >
            {WORDS[tab].label}
          </button>
        ))}
      </div>
      <Ask key={shown.value} about={WORDS[shown.value].about} />
    </div>
  );
}

/** A tab's panel. All three are there, one is in sight: what was typed or unfolded in the others stays. */
function Panel({ tab }: { tab: Tab }) {
  const page = usePage();
  const Sections = SECTIONS[tab];
  return (
    <div
      id={`panel-${tab}`}
      class="tab-panel"
      role="tabpanel"
      aria-labelledby={`tab-${tab}`}
      hidden={shownTab(page).value !== tab}
    >
      {tab === "edit" && <OpenedFile />}
      {tab === "edit" && <EditSection />}
      <Sections />
    </div>
  );
}

export function Inspector() {
  const page = usePage();
  const under = useRef<HTMLDivElement>(null);
  const tab = shownTab(page).value;
  useEffect(() => under.current?.scrollTo(0, 0), [tab]);
  // The import report is read before anything else is done with the file.
  useSignalEffect(() => {
    if (page.importReport.value) shownTab(page).value = "edit";
  });
  return (
    <aside id="inspector" class="inspector" aria-label="Inspector">
      <Tabs />
      <div ref={under} class="inspector-body">
        <Strips />
        {TABS.map((one) => (
          <Panel key={one} tab={one} />
        ))}
      </div>
    </aside>
  );
}
