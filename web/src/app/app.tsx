// SPDX-License-Identifier: MIT

import { useSignalEffect } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { FileDrop } from "../ui/file-drop.tsx";
import { Inspector, SheetFold } from "../ui/inspector.tsx";
import { usePage } from "../ui/page-context.ts";
import { StatusLine } from "../ui/status-line.tsx";
import { TopBar } from "../ui/top-bar.tsx";
import { ViewportPane } from "../ui/viewport-pane.tsx";
import { listenToShortcuts } from "./shortcuts.ts";

export function App() {
  const page = usePage();
  useEffect(() => listenToShortcuts(page), []);
  useSignalEffect(() => {
    document.title = `${page.designName.value} · Planish`;
  });
  return (
    <FileDrop>
      <TopBar />
      <main
        class="work"
        aria-busy={!page.ready.value}
        data-fetching={page.fetching}
        data-unsaved={page.unsaved}
      >
        <ViewportPane />
        <SheetFold />
        <Inspector />
      </main>
      <StatusLine />
    </FileDrop>
  );
}
