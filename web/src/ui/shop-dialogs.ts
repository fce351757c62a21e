// SPDX-License-Identifier: MIT
// What the dialogs for the workshop hold.
import { CuttingPackage } from "./cutting-package.tsx";
import { IfcModel } from "./ifc-model.tsx";
import type { DialogPart } from "./later-dialog.tsx";
import { SecondLayer } from "./second-layer.tsx";
import { StructureDrawings } from "./structure-drawings.tsx";

export const shopDialogs = {
  package: { title: "Cutting package", Content: CuttingPackage },
  drawings: { title: "Drawings", Content: StructureDrawings },
  layer: { title: "Second layer", Content: SecondLayer },
  ifc: { title: "IFC", Content: IfcModel },
} satisfies Record<string, DialogPart>;
