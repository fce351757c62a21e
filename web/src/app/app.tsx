// SPDX-License-Identifier: MIT
import { useEffect } from "preact/hooks";
import { ready } from "../state/store.ts";
import { FileDrop } from "../ui/file-drop.tsx";
import { Inspector } from "../ui/inspector.tsx";
import { later } from "../ui/later.tsx";
import { StatusLine } from "../ui/status-line.tsx";
import { TopBar } from "../ui/top-bar.tsx";
import { ViewportPane } from "../ui/viewport-pane.tsx";
import { listenToShortcuts } from "./shortcuts.ts";

const ImportReport = later(() =>
  import("../ui/import-report.tsx").then((part) => part.ImportReport),
);

export function App() {
  useEffect(() => listenToShortcuts(), []);
  return (
    <FileDrop>
      <TopBar />
      <main class="work" aria-busy={!ready.value}>
        <ViewportPane />
        <Inspector />
      </main>
      <StatusLine />
      <ImportReport />
    </FileDrop>
  );
}
