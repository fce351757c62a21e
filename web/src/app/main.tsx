// SPDX-License-Identifier: MIT
import "../ui/font.css";
import "../ui/tokens.css";
import "../ui/controls.css";
import "../ui/layout.css";
import "../ui/top-bar.css";
import "../ui/viewport.css";
import "../ui/marks.css";
import "../ui/drag-tools.css";
import "../ui/legend.css";
import "../ui/status-line.css";
import "../ui/dialog.css";
import "../ui/inspector.css";
import firstMesh from "virtual:first-mesh";
import { render } from "preact";
import { registerFeatures } from "../features/all-features.ts";
import { solverSpawner } from "../solver/spawn.ts";
import { keepFreedom, keepPanelFigures } from "../state/analysis.ts";
import { Page } from "../state/page.ts";
import { PageProvider } from "../ui/page-context.ts";
import { App } from "./app.tsx";
import { begin } from "./beginning.ts";
import { paintFirst } from "./first-paint.ts";

const page = new Page(solverSpawner());
registerFeatures(page);
paintFirst(page, location.hash, firstMesh);
const root = document.getElementById("app");
if (root)
  render(
    <PageProvider value={page}>
      <App />
    </PageProvider>,
    root,
  );
keepPanelFigures(page);
keepFreedom(page);
void begin(page);
