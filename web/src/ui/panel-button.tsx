// SPDX-License-Identifier: MIT
import { usePage } from "./page-context.ts";

/** A panel's number, which selects it. `why`: goes on where "Show panel 7" ends. */
export function PanelButton({ panel, why = "" }: { panel: number; why?: string }) {
  const page = usePage();
  return (
    <button
      type="button"
      class="point-button"
      aria-label={`Show panel ${panel}${why}`}
      onClick={() => {
        page.selectedPanel.value = panel;
      }}
    >
      {panel}
    </button>
  );
}
