// SPDX-License-Identifier: MIT
// Colours of the model, for a light and a dark page.
export interface Palette {
  readonly paper: string;
  readonly panel: string;
  readonly edge: string;
  readonly ghost: string;
  /** The outline of the selected panel: at least 3 : 1 on a panel. */
  readonly selected: string;
  /** The outline of panels at a limit. */
  readonly limit: string;
  readonly sky: string;
  readonly ground: string;
  readonly shadow: number;
  /** Panel neutral to the deepest displacement. */
  readonly displacement: readonly string[];
  /** Panel neutral to the farthest inside of the old surface; outside is `displacement`. */
  readonly lowered: readonly string[];
  /** Just over the tolerance to far over it. */
  readonly planarity: readonly string[];
}

export const LIGHT: Palette = {
  paper: "#F7F6F2",
  panel: "#F3F0E9",
  edge: "#14120E",
  ghost: "#2456D6",
  selected: "#2456D6",
  limit: "#E8590C",
  sky: "#FFFFFF",
  ground: "#D9D2C3",
  shadow: 0.16,
  displacement: ["#F3F0E9", "#BFC9E4", "#8AA3E0", "#5A74D2", "#4C58CA", "#6142C4"],
  lowered: ["#F3F0E9", "#BFDCCF", "#86BEAA", "#4B9C88", "#2C8270", "#166855"],
  planarity: ["#F3F0E9", "#F3CF86", "#E59A45", "#CC5B2C", "#B3261E"],
};

export const DARK: Palette = {
  paper: "#15181B",
  panel: "#B4B3AF",
  edge: "#08090A",
  ghost: "#7EA2FF",
  selected: "#1D3FA8",
  limit: "#8A1C00",
  sky: "#DCE3EA",
  ground: "#33363B",
  shadow: 0.45,
  displacement: ["#B4B3AF", "#94A3C6", "#7396D6", "#6A8CF0", "#7B78F5", "#8F57F2"],
  lowered: ["#B4B3AF", "#93B5A8", "#6CAA97", "#439A85", "#2B8A75", "#1D7A66"],
  planarity: ["#B4B3AF", "#C7AA66", "#D98E3F", "#E0662F", "#F0413A"],
};
