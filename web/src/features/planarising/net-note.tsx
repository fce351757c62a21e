// SPDX-License-Identifier: MIT
// What is wrong with a net, said before anything is solved.

import { useEffect } from "preact/hooks";
import { kept, type Page } from "../../state/page.ts";
import type { ColourBy } from "../../state/page-state.ts";
import { Check } from "../../ui/check.tsx";
import { usePage } from "../../ui/page-context.ts";
import { measureNet, netAngles, netFault } from "./net-angles.ts";
import { EAGER_POINTS } from "./planarise-preview.ts";

/** Degrees: of nets that become flat near the file half of the panels are less far off. */
const FAULT = 10;

/** Milliseconds after which the mesh is in view. */
const SEEN_AFTER_MS = 100;

/** The colours that the switch took away; null: none. */
const taken = kept(() => ({ colours: null as ColourBy | null }));

function colour(page: Page): void {
  taken(page).colours = page.colourBy.peek();
  page.colourBy.value = "conjugacy";
}

/** Other colours that were chosen since stay. */
function giveBack(page: Page): void {
  const { colours } = taken(page);
  taken(page).colours = null;
  if (colours && page.colourBy.peek() === "conjugacy") page.colourBy.value = colours;
}

/** The colours that were there come back with the switch, and where it goes: nothing else would say what they are. */
function ColourPanels() {
  const page = usePage();
  useEffect(() => () => giveBack(page), [page]);
  return (
    <Check
      label="Colour panels by it"
      checked={page.colourBy.value === "conjugacy"}
      onChange={(on) => {
        if (on) colour(page);
        else if (taken(page).colours) giveBack(page);
        else page.colourBy.value = "shape";
      }}
    />
  );
}

/** Where the lines of most panels are far from conjugate directions. */
export function NetNote() {
  const page = usePage();
  const opened = page.mesh.value;
  useEffect(() => {
    if (!opened || opened.report.vertices > EAGER_POINTS) return;
    const timer = setTimeout(() => measureNet(page), SEEN_AFTER_MS);
    return () => clearTimeout(timer);
  }, [opened]);
  const angles = netAngles(page);
  const fault = angles && netFault(angles);
  if (!fault || fault.half < FAULT) return null;
  const [half, most] = [fault.half, fault.most].map((angle) => `${angle.toFixed(0)}°`);
  return (
    <div class="note">
      <p>
        {`Lines run up to ${most} off those along which panels can be flat (conjugate directions), half of them more than ${half}: a flat mesh near the file is unlikely.`}
      </p>
      <ColourPanels />
    </div>
  );
}
