// SPDX-License-Identifier: MIT
import { GROUP_COLOURS } from "../../design/groups.ts";
import { groups, panelsOfGroup } from "../../state/groups.ts";
import { showNextPanel } from "../../state/selection.ts";
import { usePage } from "../../ui/page-context.ts";
import "../../ui/legend-scales.css";

/** The groups that have a colour, by name; each leads to its panels in turn. */
export function GroupsScale() {
  const page = usePage();
  const coloured = groups(page).value.filter(({ colour }) => colour !== null);
  if (coloured.length === 0) return <p class="legend-note">No group has a colour: see Groups.</p>;
  return (
    <ul class="legend-classes">
      {coloured.map((group) => (
        <li key={group.name}>
          <button
            type="button"
            title="Go to the next of these panels"
            onClick={() => showNextPanel(page, panelsOfGroup(page, group))}
          >
            <span class="swatch" style={{ background: GROUP_COLOURS[group.colour ?? 0] }} />
            {group.name} <span class="legend-count">{panelsOfGroup(page, group).length}</span>
          </button>
        </li>
      ))}
    </ul>
  );
}
