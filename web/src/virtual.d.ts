// SPDX-License-Identifier: MIT
declare module "virtual:first-mesh" {
  const mesh: {
    readonly positions: readonly number[];
    readonly offsets: readonly number[];
    readonly vertices: readonly number[];
  };
  export default mesh;
}
