// SPDX-License-Identifier: MIT

import type { Camera } from "../design/camera.ts";
import { packLink } from "../design/link.ts";
import { done, type Result } from "../result/result.ts";
import type { Page } from "../state/page.ts";
import type { Taken } from "./companions.ts";
import { designText } from "./design-text.ts";

/** The link that opens the design and verifies it; within a queued action. */
export async function designLink(
  page: Page,
  camera: Camera | null,
  taken: Taken,
): Promise<Result<string>> {
  const label = "writing the link";
  const text = await designText(page, { format: "link", label, camera, taken });
  if (!text.ok) return text;
  const url = new URL(location.href);
  url.hash = "";
  return done(url.href + packLink(text.value));
}
