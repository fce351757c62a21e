// SPDX-License-Identifier: MIT
// What the dialogs for the workshop hold.

import { SecondLayer } from "../features/second-layer/second-layer.tsx";
import { CuttingPackage } from "../features/shop/cutting-package.tsx";
import { IfcModel } from "../features/shop/ifc-model.tsx";
import { StructureDrawings } from "../features/shop/structure-drawings.tsx";
import type { DialogPart } from "./later-dialog.tsx";

export const shopDialogs = {
  package: { title: "Cutting package", Content: CuttingPackage },
  drawings: { title: "Drawings", Content: StructureDrawings },
  layer: { title: "Second layer", Content: SecondLayer },
  ifc: { title: "IFC", Content: IfcModel },
} satisfies Record<string, DialogPart>;
