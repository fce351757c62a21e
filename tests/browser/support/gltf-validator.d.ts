// SPDX-License-Identifier: MIT
declare module "gltf-validator" {
  interface Issues {
    readonly numErrors: number;
    readonly numWarnings: number;
    readonly numInfos: number;
    readonly numHints: number;
    readonly messages: readonly unknown[];
  }
  export function validateBytes(bytes: Uint8Array): Promise<{ readonly issues: Issues }>;
}
