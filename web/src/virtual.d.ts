// SPDX-License-Identifier: MIT
declare module "virtual:first-mesh" {
  const mesh: {
    readonly positions: readonly number[];
    readonly offsets: readonly number[];
    readonly vertices: readonly number[];
  };
  export default mesh;
}

declare module "rhino3dm/rhino3dm.module.js" {
  export { default } from "rhino3dm";
}
