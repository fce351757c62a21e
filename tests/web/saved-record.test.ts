// SPDX-License-Identifier: MIT
import { describe, expect, it } from "vitest";
import { fromBase64Url } from "../../web/src/share/base64url.ts";
import { type Files, fileKey } from "../../web/src/share/saved-design.ts";
import { decodeRecord, encodeRecord } from "../../web/src/share/saved-record.ts";
import { FILE, RECORD } from "./support/golden-designs.ts";

const files: Files = new Map([[fileKey(FILE), FILE.bytes]]);

describe("a saved record", () => {
  it("comes back to the same bits", () => {
    const read = decodeRecord(encodeRecord(RECORD), files);
    expect(read).toEqual({ kind: "record", record: RECORD });
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
  "UExOUwEAAADYWkd_eAUAAHsidGltZSI6MTc5MDAwMDAwMDAwMCwidW5pdCI6Im1tIiwiY2FtZXJhIjpbMSwyLDMsMCwtMC41LDAuMjVdLCJwcmVzZW50Ijp7InNvdXJjZSI6WyJ2YXVsdCIsMjFdLCJwbGFuYXJpc2VkIjpmYWxzZSwiaGFuZGxlcyI6WzAsMTBdLCJzZXR0aW5ncyI6WzEwMDAsMSwwLjUsInNlY29uZCIsIm5ld3RvbiJdLCJzaGFwZSI6W1sxMCwzXSxbMTMsOV1dLCJyZXBvcnQiOnsic3RhdHVzIjoiY29udmVyZ2VkIiwibW92ZWRWZXJ0aWNlcyI6MywibWF4RGlzcGxhY2VtZW50IjoxLjI1LCJ3b3JzdEdhcCI6MWUtMTYsIndvcnN0TW1QZXJNIjoxZS0xMiwiaGFuZGxlRXJyb3IiOjAuNSwib2JqZWN0aXZlIjoxMi41LCJpdGVyYXRpb25zIjo3LCJzZWNvbmRzIjowLjAyLCJyZXNpZHVhbHMiOltdfSwidmFyaWF0aW9uIjp7IngiOlsyMiwzXSwiY2VudHJlIjpbWzI1LDNdLFsyOCw5XV0sImFza2VkIjo0LCJlaWdlbmJhc2lzIjpmYWxzZSwiZXhhY3QiOnRydWV9fSwic25hcHNob3RzIjpbeyJpZCI6ImEiLCJuYW1lIjoiTG93IHJvb2YiLCJ0aW1lIjoxLCJwaWN0dXJlIjoiZGF0YTppbWFnZS93ZWJwO2Jhc2U2NCxBQUFBIiwiZGVzaWduIjp7InNvdXJjZSI6WyJyw7ZvZiA8Yj4ub2JqIiwib2JqIiwzNjQ3MDkxOTA5LDQyXSwicGxhbmFyaXNlZCI6dHJ1ZSwiaGFuZGxlcyI6WzM3LDBdLCJzZXR0aW5ncyI6WzEwMDAsMSwwLjUsInNlY29uZCIsIm5ld3RvbiJdLCJzaGFwZSI6W1szNywwXSxbMzcsMF1dLCJyZXBvcnQiOnsic3RhdHVzIjoiY29udmVyZ2VkIiwibW92ZWRWZXJ0aWNlcyI6MCwibWF4RGlzcGxhY2VtZW50IjoxLjI1LCJ3b3JzdEdhcCI6MWUtMTYsIndvcnN0TW1QZXJNIjoxZS0xMiwiaGFuZGxlRXJyb3IiOjAuNSwib2JqZWN0aXZlIjoxMi41LCJpdGVyYXRpb25zIjo3LCJzZWNvbmRzIjowLjAyLCJyZXNpZHVhbHMiOltdfSwidmFyaWF0aW9uIjpudWxsfX0seyJpZCI6ImIiLCJuYW1lIjoiIiwidGltZSI6MiwicGljdHVyZSI6IiIsImRlc2lnbiI6eyJzb3VyY2UiOlsidmF1bHQiLDIxXSwicGxhbmFyaXNlZCI6ZmFsc2UsImhhbmRsZXMiOlszNywxMF0sInNldHRpbmdzIjpbMTAwMCwxLDAuNSwic2Vjb25kIiwibmV3dG9uIl0sInNoYXBlIjpbWzQ3LDNdLFs1MCw5XV0sInJlcG9ydCI6eyJzdGF0dXMiOiJjb252ZXJnZWQiLCJtb3ZlZFZlcnRpY2VzIjozLCJtYXhEaXNwbGFjZW1lbnQiOjEuMjUsIndvcnN0R2FwIjoxZS0xNiwid29yc3RNbVBlck0iOjFlLTEyLCJoYW5kbGVFcnJvciI6MC41LCJvYmplY3RpdmUiOjEyLjUsIml0ZXJhdGlvbnMiOjcsInNlY29uZHMiOjAuMDIsInJlc2lkdWFscyI6W119LCJ2YXJpYXRpb24iOnsieCI6WzU5LDNdLCJjZW50cmUiOltbNjIsM10sWzY1LDldXSwiYXNrZWQiOjQsImVpZ2VuYmFzaXMiOmZhbHNlLCJleGFjdCI6dHJ1ZX19fV19AAAAAACAa0AzMzMzMzMkQM3MzMzMzCNAVVVVVVVV1T8AAAAAAAAAAAAAAAAAABRAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA8D8AAAAAAAAIQAAAAAAAABxAAAAAAACAa0CamZmZmZm5P5qZmZmZmck_MzMzMzMz0z9VVVVVVVXVPwAAAAAAAACAAQAAAAAAAACcdQCIPOQ3fhgtRFT7IQlAldYm6AsuEb4AAAAAAADgPwAAAAAAANC_AAAAAAAAAAAAAAAAAAAIQAAAAAAAABxAAAAAAACAa0CamZmZmZmpP5qZmZmZmbk_MzMzMzMzwz9VVVVVVVXFPwAAAAAAAACAAAAAAAAAAACcdQCIPOQnfhgtRFT7Ifk_ldYm6AsuAb4AAAAAAIBrQDMzMzMzMyRAzczMzMzMI0BVVVVVVVXVPwAAAAAAAAAAAAAAAAAAFEAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAADwPwAAAAAAAAhAAAAAAAAAHEAAAAAAAIBrQJqZmZmZmbk_mpmZmZmZyT8zMzMzMzPTP1VVVVVVVdU_AAAAAAAAAIABAAAAAAAAAJx1AIg85Dd-GC1EVPshCUCV1iboCy4RvgAAAAAAAOA_AAAAAAAA0L8AAAAAAAAAAAAAAAAAAAhAAAAAAAAAHEAAAAAAAIBrQJqZmZmZmak_mpmZmZmZuT8zMzMzMzPDP1VVVVVVVcU_AAAAAAAAAIAAAAAAAAAAAJx1AIg85Cd-GC1EVPsh-T-V1iboCy4Bvg";
