// SPDX-License-Identifier: MIT
import { GROUP_COLOURS } from "../../design/groups.ts";
import { groups, panelsOfGroup } from "../../state/groups.ts";
import { NamedPanelsList } from "../../ui/named-panels.tsx";
import { usePage } from "../../ui/page-context.ts";

/** The groups that have a colour, by name; each leads to its panels in turn. */
export function GroupsScale() {
  const page = usePage();
  const coloured = groups(page).value.flatMap((group) => {
    const colour = group.colour === null ? undefined : GROUP_COLOURS[group.colour];
    return colour ? [{ name: group.name, colour, panels: panelsOfGroup(page, group) }] : [];
  });
  if (coloured.length === 0) return <p class="legend-note">No group has a colour: see Groups.</p>;
  return <NamedPanelsList all={coloured} />;
}
