// SPDX-License-Identifier: MIT
// What the dialogs for the workshop hold.

import type { DialogPart } from "../../ui/later-dialog.tsx";
import { CuttingPackage } from "./cutting-package.tsx";
import { IfcModel } from "./ifc-model.tsx";
import { StructureDrawings } from "./structure-drawings.tsx";

export const shopDialogs = {
  package: { title: "Cutting package", Content: CuttingPackage },
  drawings: { title: "Drawings", Content: StructureDrawings },
  ifc: { title: "IFC", Content: IfcModel },
} satisfies Record<string, DialogPart>;
