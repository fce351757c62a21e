// SPDX-License-Identifier: MIT
// What is wrong with a net, said before anything is solved.
import { useEffect, useRef } from "preact/hooks";
import type { ColourBy } from "../../state/page-state.ts";
import { usePage } from "../../ui/page-context.ts";
import { measureNet, netAngles, netFault } from "./net-angles.ts";
import { EAGER_POINTS } from "./planarise-preview.ts";

/** Degrees: of nets that become flat near the file half of the panels are less far off. */
const FAULT = 10;

/** Milliseconds after which the mesh is in view. */
const SEEN_AFTER_MS = 100;

/** The switch gives back the colours that were there. */
function ColourPanels() {
  const page = usePage();
  const before = useRef<ColourBy>("shape");
  return (
    <label class="check">
      <input
        type="checkbox"
        checked={page.colourBy.value === "conjugacy"}
        onChange={({ currentTarget }) => {
          if (currentTarget.checked) before.current = page.colourBy.peek();
          page.colourBy.value = currentTarget.checked ? "conjugacy" : before.current;
        }}
      />
      <span>Colour panels by it</span>
    </label>
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
