// SPDX-License-Identifier: MIT
// What the dialogs for the workshop hold.

import { CuttingPackage } from "../features/shop/cutting-package.tsx";
import { IfcModel } from "../features/shop/ifc-model.tsx";
import { StructureDrawings } from "../features/shop/structure-drawings.tsx";
import type { DialogPart } from "./later-dialog.tsx";

export const shopDialogs = {
  package: { title: "Cutting package", Content: CuttingPackage },
  drawings: { title: "Drawings", Content: StructureDrawings },
  ifc: { title: "IFC", Content: IfcModel },
} satisfies Record<string, DialogPart>;
