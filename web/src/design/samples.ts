// SPDX-License-Identifier: MIT
/** The built-in meshes, as the chooser shows them. Names are the command line's. */
export interface Sample {
  readonly name: string;
  readonly label: string;
  readonly size: number;
}

export const SAMPLES: readonly Sample[] = [
  { name: "roof", label: "Roof", size: 21 },
  { name: "vault", label: "Vault", size: 21 },
  { name: "dome", label: "Dome", size: 24 },
  { name: "freeform", label: "Freeform roof", size: 24 },
  { name: "hex", label: "Hexagonal shell", size: 24 },
  { name: "trihex", label: "Tri-hex shell", size: 24 },
];

/** Opened on the first visit; painted before the solver is there. Curved both ways, so that a point
 * pulled anywhere gives a soft bump. */
export const FIRST_SAMPLE: Sample = { name: "roof", label: "Roof", size: 21 };
