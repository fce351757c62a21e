// SPDX-License-Identifier: MIT
// The module that reads and writes documents: GLB, designs as text, cutting packages, drawings, offsets.
import type { GlbModule } from "./planish_glb.d.ts";
import type { ShopModule } from "./planish_shop.d.ts";

export type * from "./planish_glb.d.ts";
export type * from "./planish_shop.d.ts";

export interface DocumentsModule extends GlbModule, ShopModule {}

export default function createPlanishDocuments(options?: object): Promise<DocumentsModule>;
