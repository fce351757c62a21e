// SPDX-License-Identifier: MIT
import { describe, expect, it } from "vitest";
import { fromBase64Url } from "../../web/src/bytes/base64url.ts";
import type { Group } from "../../web/src/design/groups.ts";
import { type Files, fileKey } from "../../web/src/design/saved-design.ts";
import { decodeRecord, encodeRecord } from "../../web/src/design/saved-record.ts";
import { FILE, RECORD } from "./support/golden-designs.ts";

const files: Files = new Map([[fileKey(FILE), FILE.bytes]]);

describe("a saved record", () => {
  it("comes back to the same bits", () => {
    const sharpestFold = { before: 3.5, after: 14.25 };
    const report = { ...RECORD.present.report, worstExcess: 0, sharpestFold };
    const settings = {
      ...RECORD.present.settings,
      limits: ["angle=60:120"],
      constraints: ["conical:1e-9"],
    };
    const present = { ...RECORD.present, report, settings };
    const [position, target] = [[0.1, -2, 3] as const, [0, 0, 0.25] as const];
    const views = [{ name: "From the street", camera: { position, target } }];
    const section = { axis: 2, at: 0.1, flipped: true } as const;
    const groups: readonly Group[] = [
      { name: "Ridge", of: "points", members: [0, 3], colour: 1 },
      { name: "Doors", of: "panels", members: [2], colour: null },
    ];
    const record = { ...RECORD, figure: "figure-1", present, views, section, groups };
    const read = decodeRecord(encodeRecord(record), files);
    expect(read).toEqual({ kind: "record", record });
    if (read.kind !== "record") return;
    const { positions } = read.record.present.shape;
    const bits = (array: Float64Array) => new BigUint64Array(array.slice().buffer);
    expect(bits(positions)).toEqual(bits(RECORD.present.shape.positions));
  });

  it("of version 1 opens for ever", () => {
    const read = decodeRecord(fromBase64Url(GOLDEN) ?? new Uint8Array(0), files);
    expect(read).toEqual({ kind: "record", record: RECORD });
  });

  it("without its file is damaged, of a newer version is newer", () => {
    const bytes = encodeRecord(RECORD);
    expect(decodeRecord(bytes, new Map())).toEqual({ kind: "damaged" });
    new DataView(bytes.buffer).setUint32(4, 2, true);
    expect(decodeRecord(bytes, files)).toEqual({ kind: "newer" });
  });

  it("leaves out a camera or a picture that its reader would refuse, never the design", () => {
    const camera = { position: [Number.NaN, 0, 1], target: [0, 0, 0] } as const;
    const [first] = RECORD.snapshots;
    if (!first) throw new Error("no snapshot");
    const odd = [
      "data:,",
      "data:image/svg+xml;base64,AAAA",
      `data:image/png;base64,${"A".repeat(300_000)}`,
    ];
    const many = Array.from({ length: 1500 }, (_, k) => ({ ...first, picture: odd[k % 3] ?? "" }));
    const row = { vertex: 7, target: [1, 2, 3], pinned: true } as const;
    const present = { ...RECORD.present, handles: Array.from({ length: 150_000 }, () => row) };
    const read = decodeRecord(encodeRecord({ ...RECORD, camera, present, snapshots: many }), files);
    const snapshots = many.map((snapshot) => ({ ...snapshot, picture: "" }));
    expect(read.kind).toBe("record");
    if (read.kind !== "record") return;
    expect(read.record.camera).toBeNull();
    expect(read.record.snapshots).toEqual(snapshots);
    expect(read.record.present.handles).toHaveLength(150_000);
  });

  it("leaves out views that are none, and all but the last of one name", () => {
    const view = (name: string, x: number) => ({
      name,
      camera: { position: [x, 0, 1], target: [0, 0, 0] } as const,
    });
    const views = [view("a", 1), view("b", Number.NaN), view("a", 2), view("c", 3)];
    const read = decodeRecord(encodeRecord({ ...RECORD, views }), files);
    if (read.kind !== "record") throw new Error(read.kind);
    expect(read.record).toEqual({ ...RECORD, views: [view("a", 2), view("c", 3)] });
  });

  it("is whole or damaged, wherever it is cut or changed", () => {
    const bytes = encodeRecord(RECORD);
    for (let cut = 0; cut < bytes.length; cut += 3)
      expect(decodeRecord(bytes.slice(0, cut), files).kind).toBe("damaged");
    for (let at = 0; at < bytes.length; ++at) {
      const other = bytes.slice();
      other[at] = (other[at] ?? 0) ^ 0x10;
      expect(decodeRecord(other, files).kind).not.toBe("record");
    }
  });
});

/** Version 1 as it was when it was published. */
const GOLDEN =
  "UExOUwEAAACMnQCL4gUAAHsidGltZSI6MTc5MDAwMDAwMDAwMCwidW5pdCI6Im1tIiwiY2FtZXJhIjpbMSwyLDMsMCwtMC41LDAuMjVdLCJwcmVzZW50Ijp7InNvdXJjZSI6WyJ2YXVsdCIsMjFdLCJwbGFuYXJpc2VkIjpmYWxzZSwiaGFuZGxlcyI6WzAsMTBdLCJzZXR0aW5ncyI6WzEwMDAsMSwwLjUsInNlY29uZCIsIm5ld3RvbiJdLCJzaGFwZSI6W1sxMCwzXSxbMTMsOV1dLCJyZXBvcnQiOnsic3RhdHVzIjoiY29udmVyZ2VkIiwibW92ZWRWZXJ0aWNlcyI6MywibWF4RGlzcGxhY2VtZW50IjoxLjI1LCJ3b3JzdEdhcCI6MWUtMTYsIndvcnN0TW1QZXJNIjoxZS0xMiwiaGFuZGxlRXJyb3IiOjAuNSwib2JqZWN0aXZlIjoxMi41LCJpdGVyYXRpb25zIjo3LCJzZWNvbmRzIjowLjAyLCJyZXNpZHVhbHMiOltdfSwidmFyaWF0aW9uIjp7IngiOlsyMiwzXSwiYXNrZWQiOjQsImVpZ2VuYmFzaXMiOmZhbHNlLCJlYXJsaWVyIjpbeyJ4IjpbMjUsMV0sImFza2VkIjoxLCJlaWdlbmJhc2lzIjp0cnVlfV0sImNlbnRyZSI6W1syNiwzXSxbMjksOV1dLCJleGFjdCI6dHJ1ZX19LCJzbmFwc2hvdHMiOlt7ImlkIjoiYSIsIm5hbWUiOiJMb3cgcm9vZiIsInRpbWUiOjEsInBpY3R1cmUiOiJkYXRhOmltYWdlL3dlYnA7YmFzZTY0LEFBQUEiLCJkZXNpZ24iOnsic291cmNlIjpbInLDtm9mIDxiPi5vYmoiLCJvYmoiLDM2NDcwOTE5MDksNDJdLCJwbGFuYXJpc2VkIjp0cnVlLCJoYW5kbGVzIjpbMzgsMF0sInNldHRpbmdzIjpbMTAwMCwxLDAuNSwic2Vjb25kIiwibmV3dG9uIl0sInNoYXBlIjpbWzM4LDBdLFszOCwwXV0sInJlcG9ydCI6eyJzdGF0dXMiOiJjb252ZXJnZWQiLCJtb3ZlZFZlcnRpY2VzIjowLCJtYXhEaXNwbGFjZW1lbnQiOjEuMjUsIndvcnN0R2FwIjoxZS0xNiwid29yc3RNbVBlck0iOjFlLTEyLCJoYW5kbGVFcnJvciI6MC41LCJvYmplY3RpdmUiOjEyLjUsIml0ZXJhdGlvbnMiOjcsInNlY29uZHMiOjAuMDIsInJlc2lkdWFscyI6W119LCJ2YXJpYXRpb24iOm51bGx9fSx7ImlkIjoiYiIsIm5hbWUiOiIiLCJ0aW1lIjoyLCJwaWN0dXJlIjoiIiwiZGVzaWduIjp7InNvdXJjZSI6WyJ2YXVsdCIsMjFdLCJwbGFuYXJpc2VkIjpmYWxzZSwiaGFuZGxlcyI6WzM4LDEwXSwic2V0dGluZ3MiOlsxMDAwLDEsMC41LCJzZWNvbmQiLCJuZXd0b24iXSwic2hhcGUiOltbNDgsM10sWzUxLDldXSwicmVwb3J0Ijp7InN0YXR1cyI6ImNvbnZlcmdlZCIsIm1vdmVkVmVydGljZXMiOjMsIm1heERpc3BsYWNlbWVudCI6MS4yNSwid29yc3RHYXAiOjFlLTE2LCJ3b3JzdE1tUGVyTSI6MWUtMTIsImhhbmRsZUVycm9yIjowLjUsIm9iamVjdGl2ZSI6MTIuNSwiaXRlcmF0aW9ucyI6Nywic2Vjb25kcyI6MC4wMiwicmVzaWR1YWxzIjpbXX0sInZhcmlhdGlvbiI6eyJ4IjpbNjAsM10sImFza2VkIjo0LCJlaWdlbmJhc2lzIjpmYWxzZSwiZWFybGllciI6W3sieCI6WzYzLDFdLCJhc2tlZCI6MSwiZWlnZW5iYXNpcyI6dHJ1ZX1dLCJjZW50cmUiOltbNjQsM10sWzY3LDldXSwiZXhhY3QiOnRydWV9fX1dfQAAAAAAgGtAMzMzMzMzJEDNzMzMzMwjQFVVVVVVVdU_AAAAAAAAAAAAAAAAAAAUQAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAPA_AAAAAAAACEAAAAAAAAAcQAAAAAAAgGtAmpmZmZmZuT-amZmZmZnJPzMzMzMzM9M_VVVVVVVV1T8AAAAAAAAAgAEAAAAAAAAAnHUAiDzkN34YLURU-yEJQJXWJugLLhG-AAAAAAAA4D8AAAAAAADQvwAAAAAAAAAAVVVVVVVV1T8AAAAAAAAIQAAAAAAAABxAAAAAAACAa0CamZmZmZmpP5qZmZmZmbk_MzMzMzMzwz9VVVVVVVXFPwAAAAAAAACAAAAAAAAAAACcdQCIPOQnfhgtRFT7Ifk_ldYm6AsuAb4AAAAAAIBrQDMzMzMzMyRAzczMzMzMI0BVVVVVVVXVPwAAAAAAAAAAAAAAAAAAFEAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAADwPwAAAAAAAAhAAAAAAAAAHEAAAAAAAIBrQJqZmZmZmbk_mpmZmZmZyT8zMzMzMzPTP1VVVVVVVdU_AAAAAAAAAIABAAAAAAAAAJx1AIg85Dd-GC1EVPshCUCV1iboCy4RvgAAAAAAAOA_AAAAAAAA0L8AAAAAAAAAAFVVVVVVVdU_AAAAAAAACEAAAAAAAAAcQAAAAAAAgGtAmpmZmZmZqT-amZmZmZm5PzMzMzMzM8M_VVVVVVVVxT8AAAAAAAAAgAAAAAAAAAAAnHUAiDzkJ34YLURU-yH5P5XWJugLLgG-";
