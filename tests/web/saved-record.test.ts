// SPDX-License-Identifier: MIT
import { readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";
import { fromBase64Url } from "../../web/src/bytes/base64url.ts";
import type { Group } from "../../web/src/design/groups.ts";
import { fileKey, type KeptFiles, storeDesign } from "../../web/src/design/saved-design.ts";
import type { SavedRecord } from "../../web/src/design/saved-record.ts";
import { StepFiles } from "../../web/src/design/saved-steps.ts";
import { readRecord, storeRecord } from "../../web/src/design/stored-record.ts";
import { decodeRecord } from "../../web/src/design/v1/record.ts";
import { OF_NEWER_PAGE } from "../../web/src/features/saving/slot.ts";
import { EDITED, FILE, OPENED, RECORD } from "./support/golden-designs.ts";

const files: KeptFiles = new Map([[fileKey(FILE), FILE.bytes]]);

/** As IndexedDB keeps it. */
const kept = (record: SavedRecord): unknown => structuredClone(storeRecord(record));

const FULL: SavedRecord = {
  ...RECORD,
  figure: "figure-1",
  present: {
    ...EDITED,
    planarised: {
      smooth: 100,
      keepBoundary: true,
      keepShape: true,
      constraints: ["circular:1e-9"],
      within: 0.3,
      flat: 20,
    },
    settings: {
      ...EDITED.settings,
      keepShape: true,
      softness: 5,
      limits: ["angle=60:120"],
      constraints: ["conical:1e-9"],
      keepOuts: ["below=0"],
      clearance: 0.5,
      supports: ["level=z:3"],
      symmetry: ["x"],
      cuts: ["strip=1-2"],
    },
    report: {
      ...EDITED.report,
      worstExcess: 0,
      sharpestFold: { before: 3.5, after: 14.25 },
      motion: { raised: 1, lowered: 0.5, slide: 0 },
      seconds: Number.NaN,
    },
    variation: EDITED.variation && {
      ...EDITED.variation,
      weights: {
        fairness: 7.5,
        sparsity: 0.3,
        closeness: 4,
        correlation: 0.5,
        spread: 3,
        family: 9,
      },
    },
  },
  views: [{ name: "From the street", camera: { position: [0.1, -2, 3], target: [0, 0, 0.25] } }],
  note: "A note",
  section: { axis: 2, at: 0.1, flipped: true },
  groups: [{ name: "Ridge", of: "points", members: [0, 3], colour: 1 }] satisfies Group[],
  steps: { past: ["step-a-1"], future: ["step-b-2"] },
};

describe("a saved record", () => {
  it("comes back to the same bits", async () => {
    const read = await readRecord(kept(FULL), files);
    expect(read).toEqual({ kind: "record", record: FULL });
    if (read.kind !== "record") return;
    const { positions } = read.record.present.shape;
    const bits = (array: Float64Array) => new BigUint64Array(array.slice().buffer);
    expect(bits(positions)).toEqual(bits(RECORD.present.shape.positions));
  });

  it("keeps of an array what the design has, not the memory around it", () => {
    const large = new Float64Array(100_000);
    const shape = { moved: Int32Array.of(0), positions: large.subarray(3, 6) };
    expect(storeDesign({ ...EDITED, shape }).shape.positions.buffer.byteLength).toBe(24);
  });

  it("has what later pages added to a design as usual", async () => {
    const { clearance: _, ...settings } = FULL.present.settings;
    const { worstExcess: __, ...report } = FULL.present.report;
    const older = { ...FULL.present, settings, report } as typeof FULL.present;
    const read = await readRecord(kept({ ...FULL, present: older }), files);
    if (read.kind !== "record") throw new Error(read.kind);
    expect(read.record.present.settings.clearance).toBe(0);
    expect(read.record.present.report.worstExcess).toBe(0);
  });

  it("without its file is damaged, of a newer version is newer", async () => {
    expect(await readRecord(kept(RECORD), new Map())).toEqual({ kind: "damaged" });
    const newer = { ...storeRecord(RECORD), version: 3 };
    expect(await readRecord(newer, files)).toEqual({ kind: "newer" });
    for (const odd of [null, 7, "", {}, [], { version: "x" }, { version: 1 }, new Blob(["a"])])
      expect(await readRecord(odd, files)).toEqual({ kind: "damaged" });
  });

  it("is of a newer version to a page of version 1, which leaves its slot alone", async () => {
    expect(decodeRecord(OF_NEWER_PAGE, files)).toEqual({ kind: "newer" });
  });

  it("leaves out views from nowhere, and such a camera, never the design", async () => {
    const view = (name: string, x: number) => ({
      name,
      camera: { position: [x, 0, 1], target: [0, 0, 0] } as const,
    });
    const views = [view("a", 1), view("b", Number.NaN), view("c", 3)];
    const { camera } = view("", Number.NaN);
    const read = await readRecord(kept({ ...RECORD, camera, views }), files);
    if (read.kind !== "record") throw new Error(read.kind);
    expect(read.record).toEqual({ ...RECORD, camera: null, views: [view("a", 1), view("c", 3)] });
  });
});

/** What the last page of version 1 kept: FULL, and its steps. */
const packed: Record<"record" | "past" | "future", string> = JSON.parse(
  readFileSync(new URL("./golden/record-v1.json", import.meta.url), "utf8"),
);
const unpacked = (text: string) => Uint8Array.from(fromBase64Url(text) ?? []);

describe("a record of version 1", () => {
  it("opens as it was: the first that was published, and the last", async () => {
    const first = await readRecord(unpacked(GOLDEN), files);
    expect(first).toEqual({ kind: "record", record: RECORD });
    const last = await readRecord(unpacked(packed.record), files);
    expect(last).toEqual({ kind: "record", record: FULL });
  });

  it("opens with its history", async () => {
    const steps = new Map<string, unknown>([...files]);
    steps.set("step-a-1", new Blob([unpacked(packed.past)]));
    steps.set("step-b-2", new Blob([unpacked(packed.future)]));
    const history = await new StepFiles().restore(FULL.present, FULL.steps, steps);
    expect(history).toEqual({ past: [EDITED], present: FULL.present, future: [OPENED] });
  });

  it("is whole or damaged, wherever it is cut or changed", async () => {
    const bytes = unpacked(packed.record);
    expect(await readRecord(bytes, new Map())).toEqual({ kind: "damaged" });
    for (let cut = 0; cut < bytes.length; cut += 3)
      expect((await readRecord(bytes.slice(0, cut), files)).kind).toBe("damaged");
    for (let at = 0; at < bytes.length; ++at) {
      const other = bytes.slice();
      other[at] = (other[at] ?? 0) ^ 0x10;
      expect((await readRecord(other, files)).kind).not.toBe("record");
    }
  });
});

/** Version 1 as it was when it was published. */
const GOLDEN =
  "UExOUwEAAACMnQCL4gUAAHsidGltZSI6MTc5MDAwMDAwMDAwMCwidW5pdCI6Im1tIiwiY2FtZXJhIjpbMSwyLDMsMCwtMC41LDAuMjVdLCJwcmVzZW50Ijp7InNvdXJjZSI6WyJ2YXVsdCIsMjFdLCJwbGFuYXJpc2VkIjpmYWxzZSwiaGFuZGxlcyI6WzAsMTBdLCJzZXR0aW5ncyI6WzEwMDAsMSwwLjUsInNlY29uZCIsIm5ld3RvbiJdLCJzaGFwZSI6W1sxMCwzXSxbMTMsOV1dLCJyZXBvcnQiOnsic3RhdHVzIjoiY29udmVyZ2VkIiwibW92ZWRWZXJ0aWNlcyI6MywibWF4RGlzcGxhY2VtZW50IjoxLjI1LCJ3b3JzdEdhcCI6MWUtMTYsIndvcnN0TW1QZXJNIjoxZS0xMiwiaGFuZGxlRXJyb3IiOjAuNSwib2JqZWN0aXZlIjoxMi41LCJpdGVyYXRpb25zIjo3LCJzZWNvbmRzIjowLjAyLCJyZXNpZHVhbHMiOltdfSwidmFyaWF0aW9uIjp7IngiOlsyMiwzXSwiYXNrZWQiOjQsImVpZ2VuYmFzaXMiOmZhbHNlLCJlYXJsaWVyIjpbeyJ4IjpbMjUsMV0sImFza2VkIjoxLCJlaWdlbmJhc2lzIjp0cnVlfV0sImNlbnRyZSI6W1syNiwzXSxbMjksOV1dLCJleGFjdCI6dHJ1ZX19LCJzbmFwc2hvdHMiOlt7ImlkIjoiYSIsIm5hbWUiOiJMb3cgcm9vZiIsInRpbWUiOjEsInBpY3R1cmUiOiJkYXRhOmltYWdlL3dlYnA7YmFzZTY0LEFBQUEiLCJkZXNpZ24iOnsic291cmNlIjpbInLDtm9mIDxiPi5vYmoiLCJvYmoiLDM2NDcwOTE5MDksNDJdLCJwbGFuYXJpc2VkIjp0cnVlLCJoYW5kbGVzIjpbMzgsMF0sInNldHRpbmdzIjpbMTAwMCwxLDAuNSwic2Vjb25kIiwibmV3dG9uIl0sInNoYXBlIjpbWzM4LDBdLFszOCwwXV0sInJlcG9ydCI6eyJzdGF0dXMiOiJjb252ZXJnZWQiLCJtb3ZlZFZlcnRpY2VzIjowLCJtYXhEaXNwbGFjZW1lbnQiOjEuMjUsIndvcnN0R2FwIjoxZS0xNiwid29yc3RNbVBlck0iOjFlLTEyLCJoYW5kbGVFcnJvciI6MC41LCJvYmplY3RpdmUiOjEyLjUsIml0ZXJhdGlvbnMiOjcsInNlY29uZHMiOjAuMDIsInJlc2lkdWFscyI6W119LCJ2YXJpYXRpb24iOm51bGx9fSx7ImlkIjoiYiIsIm5hbWUiOiIiLCJ0aW1lIjoyLCJwaWN0dXJlIjoiIiwiZGVzaWduIjp7InNvdXJjZSI6WyJ2YXVsdCIsMjFdLCJwbGFuYXJpc2VkIjpmYWxzZSwiaGFuZGxlcyI6WzM4LDEwXSwic2V0dGluZ3MiOlsxMDAwLDEsMC41LCJzZWNvbmQiLCJuZXd0b24iXSwic2hhcGUiOltbNDgsM10sWzUxLDldXSwicmVwb3J0Ijp7InN0YXR1cyI6ImNvbnZlcmdlZCIsIm1vdmVkVmVydGljZXMiOjMsIm1heERpc3BsYWNlbWVudCI6MS4yNSwid29yc3RHYXAiOjFlLTE2LCJ3b3JzdE1tUGVyTSI6MWUtMTIsImhhbmRsZUVycm9yIjowLjUsIm9iamVjdGl2ZSI6MTIuNSwiaXRlcmF0aW9ucyI6Nywic2Vjb25kcyI6MC4wMiwicmVzaWR1YWxzIjpbXX0sInZhcmlhdGlvbiI6eyJ4IjpbNjAsM10sImFza2VkIjo0LCJlaWdlbmJhc2lzIjpmYWxzZSwiZWFybGllciI6W3sieCI6WzYzLDFdLCJhc2tlZCI6MSwiZWlnZW5iYXNpcyI6dHJ1ZX1dLCJjZW50cmUiOltbNjQsM10sWzY3LDldXSwiZXhhY3QiOnRydWV9fX1dfQAAAAAAgGtAMzMzMzMzJEDNzMzMzMwjQFVVVVVVVdU_AAAAAAAAAAAAAAAAAAAUQAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAPA_AAAAAAAACEAAAAAAAAAcQAAAAAAAgGtAmpmZmZmZuT-amZmZmZnJPzMzMzMzM9M_VVVVVVVV1T8AAAAAAAAAgAEAAAAAAAAAnHUAiDzkN34YLURU-yEJQJXWJugLLhG-AAAAAAAA4D8AAAAAAADQvwAAAAAAAAAAVVVVVVVV1T8AAAAAAAAIQAAAAAAAABxAAAAAAACAa0CamZmZmZmpP5qZmZmZmbk_MzMzMzMzwz9VVVVVVVXFPwAAAAAAAACAAAAAAAAAAACcdQCIPOQnfhgtRFT7Ifk_ldYm6AsuAb4AAAAAAIBrQDMzMzMzMyRAzczMzMzMI0BVVVVVVVXVPwAAAAAAAAAAAAAAAAAAFEAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAADwPwAAAAAAAAhAAAAAAAAAHEAAAAAAAIBrQJqZmZmZmbk_mpmZmZmZyT8zMzMzMzPTP1VVVVVVVdU_AAAAAAAAAIABAAAAAAAAAJx1AIg85Dd-GC1EVPshCUCV1iboCy4RvgAAAAAAAOA_AAAAAAAA0L8AAAAAAAAAAFVVVVVVVdU_AAAAAAAACEAAAAAAAAAcQAAAAAAAgGtAmpmZmZmZqT-amZmZmZm5PzMzMzMzM8M_VVVVVVVVxT8AAAAAAAAAgAAAAAAAAAAAnHUAiDzkJ34YLURU-yH5P5XWJugLLgG-";
