// SPDX-License-Identifier: MIT
import { usePage } from "../../ui/page-context.ts";

/** More would not help to decide what to change. */
const MOST = 4;

/** The panels that hold the targets back, each to be looked at. */
export function HoldingPanels() {
  const page = usePage();
  const report = page.freedom.value;
  if (!report || report.holding.length === 0) return null;
  const { holding, borne } = report;
  return (
    <p>
      {`${holding.length === 1 ? "One panel bears" : "These panels bear"} ${Math.round(100 * borne)} % of the pull, the first most: `}
      {holding.slice(0, MOST).map((panel) => (
        <button
          key={panel}
          type="button"
          class="point-button"
          aria-label={`Show panel ${panel}`}
          onClick={() => {
            page.selectedPanel.value = panel;
          }}
        >
          {panel}
        </button>
      ))}
      {holding.length > MOST && `and ${holding.length - MOST} more`}
    </p>
  );
}
