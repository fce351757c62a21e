// SPDX-License-Identifier: MIT
import { expect, it } from "vitest";
import { layOut } from "../../web/src/features/second-layer/offset.ts";
import { done, GIVEN_UP, refuse } from "../../web/src/result/result.ts";
import { enqueue } from "../../web/src/state/action-queue.ts";
import { setTarget, shownPoint, undo } from "../../web/src/state/editing.ts";
import { openFile } from "../../web/src/state/files.ts";
import { openSample } from "../../web/src/state/opening.ts";
import { report } from "../../web/src/state/telling.ts";
import { openedPage, pageAlone } from "./support/page-here.ts";

it("what goes wrong is said, what goes well takes it back, what is given up leaves it", () => {
  const page = pageAlone();
  report(page, refuse("No."));
  expect(page.problem.value).toBe("No.");
  report(page, GIVEN_UP);
  expect(page.problem.value).toBe("No.");
  report(page, done(1));
  expect(page.problem.value).toBeNull();
});

it("a queued action reports what comes of its action, once, and hands it on", async () => {
  const page = pageAlone();
  const said: (string | null)[] = [];
  page.problem.subscribe((sentence) => said.push(sentence));
  expect(await enqueue(page, async () => refuse("No."))).toEqual(refuse("No."));
  expect(await enqueue(page, async () => undefined)).toBeUndefined();
  expect(await enqueue(page, async () => done("yes"))).toEqual(done("yes"));
  expect(said).toEqual([null, "No.", null]);
});

it("operations give what they say", async () => {
  let refusing = false;
  const page = await openedPage("roof", ({ kind, job }) =>
    refusing && kind !== "restore" ? { kind: "failed", job, message: "No.", fatal: false } : null,
  );
  refusing = true;
  const [x, y, z] = shownPoint(page, 220);
  for (const asked of [
    () => setTarget(page, 220, [x, y, z + 0.2]),
    () => openSample(page, "dome"),
    () => layOut(page, { distance: 0.1, form: "" }),
    () => openFile(page, new File(["v 0 0 0"], "a.obj")),
  ]) {
    page.problem.value = null;
    expect(await asked()).toEqual(refuse("No."));
    expect(page.problem.value).toBe("No.");
  }
  refusing = false;
  expect((await setTarget(page, 220, [x, y, z + 0.2]))?.ok).toBe(true);
  expect(page.problem.value).toBeNull();
  report(page, refuse("Something else."));
  expect(await undo(page)).toBeUndefined();
  expect(page.problem.value).toBe("Something else.");
});
