// SPDX-License-Identifier: MIT
// The module that reads and writes documents: GLB, designs as text, cutting packages, drawings, offsets, panels
// made more alike.
import type { AlikeModule } from "./planish_alike.d.ts";
import type { GlbModule } from "./planish_glb.d.ts";
import type { ShopModule } from "./planish_shop.d.ts";

export type * from "./planish_alike.d.ts";
export type * from "./planish_glb.d.ts";
export type * from "./planish_shop.d.ts";

export interface DocumentsModule extends AlikeModule, GlbModule, ShopModule {}

export default function createPlanishDocuments(options?: object): Promise<DocumentsModule>;
