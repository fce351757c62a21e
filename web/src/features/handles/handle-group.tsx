// SPDX-License-Identifier: MIT
// Many handles, or many pins, as one row of the table.

import { removeHandles } from "../../state/editing.ts";
import { selectThese } from "../../state/selection.ts";
import { Icon } from "../../ui/icon.tsx";
import { usePage } from "../../ui/page-context.ts";
import type { HandleGroupProps } from "../../ui/places.ts";

export function HandleGroup({ rows, kind, listed }: HandleGroupProps) {
  const page = usePage();
  const vertices = rows.map(({ vertex }) => vertex);
  const words = `${rows.length} ${kind}`;
  return (
    <tr class="group">
      <th scope="row" colSpan={5}>
        {words}
        <button
          type="button"
          class="button small"
          aria-description={words}
          onClick={() => selectThese(page, vertices)}
        >
          Select
        </button>
        <button
          type="button"
          class="button small"
          aria-description={words}
          aria-pressed={listed.value}
          onClick={() => {
            listed.value = !listed.value;
          }}
        >
          List
        </button>
      </th>
      <td class="narrow">
        <button
          type="button"
          class="icon-button"
          aria-label="Remove"
          aria-description={words}
          title={`Remove ${words}`}
          onClick={() => void removeHandles(page, vertices)}
        >
          <Icon name="close" />
        </button>
      </td>
    </tr>
  );
}
