// SPDX-License-Identifier: MIT
// Everything that the page can be told: what has a key or a button, and what the palette has beside it.
import { isKind } from "../../design/kept-kind.ts";
import { SAMPLES } from "../../design/samples.ts";
import { goToRule, goToTab, RULES, rulesInOrder, viewOptionsShown } from "../../state/inspector.ts";
import { openSample } from "../../state/opening.ts";
import type { Page } from "../../state/page.ts";
import type { ColourBy } from "../../state/page-state.ts";
import { COLOURS } from "../colours.ts";
import { type Command, notReady } from "./command.ts";
import { commandsAtOnce } from "./commands.ts";
import { exportCommands } from "./export-commands.ts";
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
];

/** All commands, in the order of the palette; `more`: those of features that are fetched with it. */
export const allCommands = (page: Page, more: readonly Command[]): readonly Command[] => [
  ...commandsAtOnce(page),
  ...Object.values(MORE_COMMANDS),
  ...PLACES,
  ...more,
  ...exportCommands(page),
  ...COLOURS.map(([kind, label]) => colourBy(kind, label)),
  ...SAMPLES.map(
    ({ name, label }): Command => ({
      label: `Sample: ${label}`,
      refusal: notReady,
      run: (page) => openSample(page, name),
    }),
  ),
];
