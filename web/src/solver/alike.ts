// SPDX-License-Identifier: MIT
// The mesh of a session with more of its panels alike, opened in its place.
import type { PlanishModule, Session } from "@wasm/planish.mjs";
import { openedBuffers, readMesh } from "./opened-mesh.ts";
import type { Reply, Request } from "./protocol.ts";
import { keepCopy } from "./reading.ts";
import { insist, Refused } from "./refused.ts";

type AlikeRequest = Extract<Request, { kind: "alike" }>;

interface Made {
  readonly reply: Extract<Reply, { kind: "alike" }>;
  readonly transfer: Transferable[];
}

/** Throws Refused where the mesh that is open stays for a fault; with as many types it stays, too. */
export function makeAlike(
  module: PlanishModule,
  session: Session,
  { job, name, asked }: AlikeRequest,
): Made {
  const { problem, before, after, maxMove, file } = module.alike(session, asked);
  if (problem) throw new Refused(problem);
  const figures = { kind: "alike", job, before, after, maxMove } as const;
  if (after >= before) return { reply: { ...figures, opened: null }, transfer: [] };
  insist(session.openFile(file, "obj"));
  const mesh = readMesh(module, session, []);
  const opened = { source: keepCopy(name, "obj", file), mesh };
  return { reply: { ...figures, opened }, transfer: openedBuffers(mesh) };
}
