// SPDX-License-Identifier: MIT
import { showNextPanel } from "../state/selection.ts";
import { usePage } from "./page-context.ts";
import "./legend-scales.css";

export interface NamedPanels {
  readonly name: string;
  readonly colour: string;
  readonly panels: readonly number[];
}

/** Panels of one colour with their name and count, never by colour alone; each leads to its panels in turn. */
export function NamedPanelsList({ all }: { all: readonly NamedPanels[] }) {
  const page = usePage();
  return (
    <ul class="legend-classes">
      {all.map(({ name, colour, panels }) => (
        <li key={name}>
          <button
            type="button"
            title="Go to the next of these panels"
            onClick={() => showNextPanel(page, panels)}
          >
            <span class="swatch" style={{ background: colour }} />
            {name} <span class="legend-count">{panels.length}</span>
          </button>
        </li>
      ))}
    </ul>
  );
}
