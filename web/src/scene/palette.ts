// SPDX-License-Identifier: MIT
// Colours of the model, for a light and a dark page.
export interface Palette {
  readonly paper: string;
  readonly panel: string;
  readonly edge: string;
  readonly ghost: string;
  readonly sky: string;
  readonly ground: string;
  readonly shadow: number;
  /** Panel neutral to the deepest displacement. */
  readonly displacement: readonly string[];
  /** Just over the tolerance to far over it. */
  readonly planarity: readonly string[];
}

export const LIGHT: Palette = {
  paper: "#F7F6F2",
  panel: "#F3F0E9",
  edge: "#6E6A61",
  ghost: "#2456D6",
  sky: "#FFFFFF",
  ground: "#D9D2C3",
  shadow: 0.16,
  displacement: ["#F3F0E9", "#BFC9E4", "#8AA3E0", "#5A74D2", "#3B47AE", "#2B1F78"],
  planarity: ["#F3F0E9", "#F3CF86", "#E59A45", "#CC5B2C", "#9C1F1F"],
};

export const DARK: Palette = {
  paper: "#15181B",
  panel: "#A29F97",
  edge: "#2A2C2E",
  ghost: "#7EA2FF",
  sky: "#DCE3EA",
  ground: "#3A3733",
  shadow: 0.45,
  displacement: ["#A29F97", "#8594B4", "#7396D6", "#6A8CF0", "#7B78F5", "#A06BFF"],
  planarity: ["#A29F97", "#B39A5C", "#D98E3F", "#E0662F", "#F0413A"],
};
