// SPDX-License-Identifier: MIT
// What is said about the lines of a net: of meshes that are not flat, which few visitors open.
import { apart } from "../../ui/apart.tsx";

export const ConjugacyScale = apart(() =>
  import("./conjugacy-scale.tsx").then((part) => part.ConjugacyScale),
);

export const NetNote = apart(() => import("./net-note.tsx").then((part) => part.NetNote));
