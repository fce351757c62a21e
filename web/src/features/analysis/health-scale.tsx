// SPDX-License-Identifier: MIT

import { panelsWith } from "../../state/panel-rows.ts";
import { TROUBLES } from "../../state/panel-trouble.ts";
import { usePage } from "../../ui/page-context.ts";
import { ClassScale } from "./class-scale.tsx";

const WORDS: readonly string[] = TROUBLES.map((word) =>
  word === "crosses itself" ? `${word} (bow-tie)` : word,
);

/** Whether panels can be made. */
export function HealthScale() {
  const page = usePage();
  const troubles = page.panelTroubles.value;
  const classes = WORDS.map((word, trouble) => ({
    word,
    place: trouble / (WORDS.length - 1),
    panels: troubles && panelsWith(trouble, troubles),
  }));
  return <ClassScale classes={classes} />;
}
