// SPDX-License-Identifier: MIT
import { useRef } from "preact/hooks";
import { exportDesign, exportMesh, exportPicture, exportRhino } from "../export/exporting.ts";
import { ready } from "../state/store.ts";
import { Icon } from "./icon.tsx";
import { useLaterDialog } from "./later-dialog.tsx";

const CHOICES = [
  { name: "OBJ", about: "Polygons, every digit", run: () => exportMesh("obj") },
  { name: "GLB", about: "3D scene, polygons kept", run: () => exportMesh("glb") },
  { name: "3DM", about: "Rhino, opens again", run: () => exportRhino() },
  { name: "PLY", about: "Polygons, binary", run: () => exportMesh("ply") },
  { name: "JSON", about: "Design, opens again", run: () => exportDesign() },
  { name: "PNG", about: "Picture of this view", run: () => exportPicture() },
] as const;

export function ExportMenu() {
  const menu = useRef<HTMLDivElement>(null);
  const { open, element } = useLaterDialog("shop", async () => {
    const { shopDialogs } = await import("./shop-dialogs.ts");
    return shopDialogs;
  });
  const choices = [
    ...CHOICES,
    { name: "Cutting package…", about: "DXF and tables (zip)", run: () => open("package") },
    { name: "Drawings…", about: "Plan, elevations, section", run: () => open("drawings") },
    { name: "IFC…", about: "Plates for building models", run: () => open("ifc") },
  ];
  return (
    <div class="menu-anchor">
      <button
        type="button"
        class="bar-button"
        disabled={!ready.value}
        popovertarget="export-menu"
        title="Export"
      >
        <Icon name="download" />
        <span class="bar-label">Export</span>
      </button>
      <div id="export-menu" class="menu" popover="auto" ref={menu}>
        {choices.map(({ name, about, run }) => (
          <div key={name} class="menu-item">
            <button
              type="button"
              aria-describedby={`export-${name}`}
              onClick={() => {
                menu.current?.hidePopover();
                void run();
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
