// SPDX-License-Identifier: MIT
import { useRef } from "preact/hooks";
import { fetchPart } from "../state/later.ts";
import { ready } from "../state/store.ts";
import { Icon } from "./icon.tsx";
import { useLaterDialog } from "./later-dialog.tsx";

type Exporting = typeof import("../export/exporting.ts");

/** Of a part that is fetched when something is exported. */
const by = (write: (part: Exporting) => Promise<void>) => async (): Promise<void> => {
  const part = await fetchPart(() => import("../export/exporting.ts"));
  if (part) await write(part);
};

const CHOICES = [
  { name: "OBJ", about: "Polygons, every digit", run: by((part) => part.exportMesh("obj")) },
  { name: "GLB", about: "3D scene, polygons kept", run: by((part) => part.exportMesh("glb")) },
  { name: "3DM", about: "Rhino, opens again", run: by((part) => part.exportRhino()) },
  { name: "PLY", about: "Polygons, binary", run: by((part) => part.exportMesh("ply")) },
  { name: "JSON", about: "Design, opens again", run: by((part) => part.exportDesign()) },
  { name: "PNG", about: "Picture of this view", run: by((part) => part.exportPicture()) },
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
    { name: "Second layer…", about: "At a distance, shown and in GLB", run: () => open("layer") },
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
