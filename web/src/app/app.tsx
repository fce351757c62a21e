// SPDX-License-Identifier: MIT
import { useEffect } from "preact/hooks";
import { ready } from "../state/store.ts";
import { FileDrop } from "../ui/file-drop.tsx";
import { Inspector } from "../ui/inspector.tsx";
import { StatusLine } from "../ui/status-line.tsx";
import { TopBar } from "../ui/top-bar.tsx";
import { ViewportPane } from "../ui/viewport-pane.tsx";
import { listenToShortcuts } from "./shortcuts.ts";

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
    </FileDrop>
  );
}
