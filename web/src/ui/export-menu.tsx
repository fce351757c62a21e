// SPDX-License-Identifier: MIT

import { useRef } from "preact/hooks";
import { useDoors } from "./commands/doors.ts";
import { EXPORT_COMMANDS } from "./commands/export-commands.ts";
import { Icon } from "./icon.tsx";
import { useLaterDialog } from "./later-dialog.tsx";
import { usePage } from "./page-context.ts";

export function ExportMenu() {
  const page = usePage();
  const menu = useRef<HTMLDivElement>(null);
  const { open, element } = useLaterDialog("shop", async () => {
    const { shopDialogs } = await import("./shop-dialogs.ts");
    return shopDialogs;
  });
  useDoors({
    package: () => open("package"),
    drawings: () => open("drawings"),
    ifc: () => open("ifc"),
  });
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
        {Object.values(EXPORT_COMMANDS).map(({ name, about, run }) => (
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
      {element}
    </div>
  );
}
