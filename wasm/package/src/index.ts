// SPDX-License-Identifier: MIT
export type { Command } from "./core.ts";
export { options } from "./core.ts";
export { Design, Replay } from "./design.ts";
export { Edit, type EditOptions, type ExploreOptions, edit, Family, Variation } from "./edit.ts";
export { type ErrorKind, PlanishError } from "./error.ts";
export { Mesh } from "./mesh.ts";
export type { MeshFormat } from "./mesh-format.ts";
export { Mobility, type MobilityOptions, type MobilityRow, mobility } from "./mobility.ts";
export {
  type ConvertOptions,
  convert,
  type OffsetOptions,
  offset,
  type ProjectOptions,
  project,
} from "./operations.ts";
export type { BoundReport, Report, Violation } from "./report.ts";
export type { Bounds, Constraints, HandleTarget, ModelUnit } from "./request.ts";
export { type Progress, Shape } from "./shape.ts";
export { Types, type TypesOptions, type TypesReport, types } from "./types.ts";
