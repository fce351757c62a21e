// SPDX-License-Identifier: MIT
import { hiddenPanels } from "../../state/hidden-panels.ts";
import { fetchPart } from "../../state/later.ts";
import type { Page } from "../../state/page.ts";
import type { Command } from "../../ui/commands/command.ts";

const hiding = (
  name: string,
  label: string,
  key: string,
  refusal: (page: Page) => string,
  act: keyof typeof import("./hiding.ts"),
): Command => ({
  name,
  label,
  keys: [key],
  heard: "view",
  refusal,
  run: async (page) => (await fetchPart(page, () => import("./hiding.ts")))?.[act](page),
});

const noPanel = (page: Page): string =>
  page.selection.value.length > 0 || page.selectedPanel.value !== null
    ? ""
    : "No point or panel is selected.";

const nothingHidden = (page: Page): string =>
  hiddenPanels(page).value.size > 0 ? "" : "No panel is hidden.";

export const HIDING_COMMANDS = {
  hide: hiding("Hide", "Hide the selected panels", "H", noPanel, "hideSelected"),
  isolate: hiding("Isolate", "Show only the selected panels", "I", noPanel, "isolateSelected"),
  showAll: hiding("Show all", "Show all panels", "Shift+H", nothingHidden, "showAll"),
};

export const HIDING_KEYS =
  "hide the panels that are selected, or at the selected points; show only those; show all. The design keeps all of them";
