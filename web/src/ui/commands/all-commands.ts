// SPDX-License-Identifier: MIT
// Everything that the page can be told: what has a key or a button, and what the palette has beside it.
import { isKind } from "../../design/kept-kind.ts";
import { SAMPLES } from "../../design/samples.ts";
import { NUMBER_COMMANDS } from "../../features/numbers/numbering.ts";
import { SELECTION_COMMANDS } from "../../features/selecting/selection-commands.ts";
import { KEEP_VIEW } from "../../features/views/named-views.ts";
import { toggleCleanView } from "../../state/clean-view.ts";
import {
  goToRule,
  goToTab,
  layerAsked,
  layerCalls,
  RULES,
  rulesInOrder,
  viewOptionsShown,
} from "../../state/inspector.ts";
import { openSample } from "../../state/opening.ts";
import type { Page } from "../../state/page.ts";
import type { ColourBy } from "../../state/page-state.ts";
import { COLOURS } from "../colours.ts";
import { type Command, notReady } from "./command.ts";
import { COMMANDS } from "./commands.ts";
import { EXPORT_COMMANDS } from "./export-commands.ts";
import { MORE_COMMANDS } from "./more-commands.ts";

function colourBy(kind: ColourBy, label: string): Command {
  const missing = (page: Page): boolean =>
    isKind(kind) && page.mesh.value?.report.kinds[kind]?.worst === undefined;
  return {
    label: `Colour by ${label.toLowerCase()}`,
    refusal: (page) => (missing(page) ? "This mesh has no panels or nodes of this kind." : ""),
    run: (page) => {
      page.colourBy.value = kind;
    },
  };
}

/** The ways to sections that are out of sight. */
const PLACES: readonly Command[] = [
  { label: "Go to Edit", run: (page) => goToTab(page, "edit") },
  { label: "Go to Explore", run: (page) => goToTab(page, "explore") },
  { label: "Go to Check and make", run: (page) => goToTab(page, "check") },
  ...rulesInOrder.map((rule) => ({
    label: `Rules: ${RULES[rule].toLowerCase()}`,
    run: (page: Page) => goToRule(page, rule),
  })),
  {
    label: "View options",
    run: (page) => {
      viewOptionsShown(page).value = true;
    },
  },
  {
    label: "Second layer",
    refusal: notReady,
    run: (page) => {
      goToTab(page, "check");
      layerAsked(page).value = true;
      layerCalls(page).value += 1;
    },
  },
  { label: "Clean view", run: toggleCleanView },
];

export { viewCommands } from "../../features/views/named-views.ts";

/** All commands, in the order of the palette. */
export const ALL_COMMANDS: readonly Command[] = [
  ...Object.values(COMMANDS),
  ...Object.values(MORE_COMMANDS),
  ...PLACES,
  ...Object.values(SELECTION_COMMANDS),
  KEEP_VIEW,
  ...NUMBER_COMMANDS,
  ...Object.values(EXPORT_COMMANDS),
  ...COLOURS.map(([kind, label]) => colourBy(kind, label)),
  ...SAMPLES.map(
    ({ name, label }): Command => ({
      label: `Sample: ${label}`,
      refusal: notReady,
      run: (page) => openSample(page, name),
    }),
  ),
];
