// SPDX-License-Identifier: MIT

import { useRef } from "preact/hooks";
import { exportCommands } from "./commands/export-commands.ts";
import { Icon } from "./icon.tsx";
import { usePage } from "./page-context.ts";

export function ExportMenu() {
  const page = usePage();
  const menu = useRef<HTMLDivElement>(null);
  return (
    <div class="menu-anchor">
      <button
        type="button"
        class="bar-button"
        disabled={!page.ready.value}
        popovertarget="export-menu"
        title="Export"
      >
        <Icon name="download" />
        <span class="bar-label">Export</span>
      </button>
      <div id="export-menu" class="menu" popover="auto" ref={menu}>
        {exportCommands(page).map(({ name, about, run }) => (
          <div key={name} class="menu-item">
            <button
              type="button"
              aria-describedby={`export-${name}`}
              onClick={() => {
                menu.current?.hidePopover();
                void run(page, "");
              }}
            >
              {name}
            </button>
            <span class="menu-about" id={`export-${name}`}>
              {about}
            </span>
          </div>
        ))}
      </div>
    </div>
  );
}
