// SPDX-License-Identifier: MIT
import { useEffect } from "preact/hooks";
import { CONJUGACY_END } from "../../state/ramp-ends.ts";
import { usePage } from "../../ui/page-context.ts";
import { measureNet, netAngles, netFault } from "./net-angles.ts";
import { EAGER_POINTS } from "./planarise-preview.ts";

/** How far lines are from conjugate directions; measured once someone looks, of a large mesh once it is asked for. */
export function ConjugacyScale() {
  const page = usePage();
  const opened = page.mesh.value;
  const waits = opened !== null && opened.report.vertices > EAGER_POINTS;
  useEffect(() => {
    if (!waits) measureNet(page);
  }, [opened]);
  const angles = netAngles(page);
  const fault = angles && netFault(angles);
  return (
    <>
      {waits && !angles && (
        <button
          type="button"
          class="button small"
          title="The page stands still meanwhile"
          onClick={() => measureNet(page)}
        >
          Measure all panels
        </button>
      )}
      <div class="legend-ends">
        <span>0°, conjugate</span>
        <span>{`${CONJUGACY_END}° or more`}</span>
      </div>
      <p class="legend-note">
        {fault
          ? `Lines of the mesh as opened, off those along which panels can be flat: half more than ${fault.half.toFixed(1)}°`
          : "Of panels with four corners, where the mesh bends"}
      </p>
    </>
  );
}
