// SPDX-License-Identifier: MIT
// What each place of the slider shows of meshes that were never made to be flat, and what is offered there.
import { existsSync, readFileSync } from "node:fs";
import { expect, it } from "vitest";
import { FAIR_FLAT } from "../../web/src/design/planarising.ts";
import { isMet } from "../../web/src/features/planarising/is-met.ts";
import { otherWays } from "../../web/src/features/planarising/other-ways.tsx";
import { PlanarisePreview } from "../../web/src/features/planarising/planarise-preview.ts";
import { PlanariseTrials } from "../../web/src/features/planarising/planarise-trial.ts";
import {
  FAR,
  nearWay,
  quickWay,
  STOPS,
  sizeOf,
  splitMost,
} from "../../web/src/features/planarising/stops.ts";
import { TrialMemory } from "../../web/src/features/planarising/trial-memory.ts";
import { openFile } from "../../web/src/state/files.ts";
import { NIGHTLY } from "../patience.ts";
import { pageHere } from "./support/page-here.ts";

const FOLDER = new URL("../../../shared/meshes/", import.meta.url);

const QUICK = ["quad_chebyshev_sphere", "hex_minsurface_messy"] as const;

const LONG = ["quad_heart", "pq_botanic_bubble", "quad_pillow", "mixed345_airport"] as const;

const MESHES = NIGHTLY ? [...QUICK, ...LONG] : QUICK;

const isThere = (name: string): boolean => existsSync(new URL(`${name}.obj`, FOLDER));

async function opened(name: string) {
  const page = pageHere();
  await openFile(page, new File([readFileSync(new URL(`${name}.obj`, FOLDER))], `${name}.obj`));
  const [mesh, design] = [page.mesh.value, page.draft.value];
  if (!mesh || !design) throw new Error("no mesh");
  return { page, mesh, design };
}

/** Seconds of a processor. */
async function spent(work: () => Promise<unknown>): Promise<string> {
  const before = process.cpuUsage();
  await work();
  const { user, system } = process.cpuUsage(before);
  return ((user + system) / 1e6).toFixed(2);
}

for (const name of MESHES) {
  it.skipIf(!isThere(name))(
    `${name}: each place of the slider shows a mesh within its distance, or what else there is`,
    async () => {
      const { page, mesh, design } = await opened(name);
      const preview = new PlanarisePreview(page, mesh, design);
      for (const { smooth, near } of STOPS) {
        const wish = { ...FAIR_FLAT, smooth, keepBoundary: false };
        const trial = await preview.show(0, wish);
        expect(page.planariseTrial.value.kind).toBe("shown");
        if (!trial) continue;
        const { largest } = trial.mesh.report.planarising;
        const [met, most] = [isMet(trial, design), near * sizeOf(mesh)];
        if (trial.instead)
          expect(trial.how.within).toBeCloseTo(most, 1 - Math.floor(Math.log10(most)));
        if (trial.instead) expect(largest).toBeLessThanOrEqual(trial.how.within);
        if (met && !trial.instead && largest <= FAR * sizeOf(mesh)) continue;
        const split = !met || trial.instead;
        const asked = { opened: mesh, wish, share: 0, splits: split };
        const ways = otherWays(asked, split ? null : trial, "m");
        expect(ways.length).toBeGreaterThan(0);
        // The first that is not refused, as the page lists them once their costs are known.
        const works = async (): Promise<boolean> => {
          for (const { how, share } of ways)
            if (await preview.show(splitMost(share, mesh), how)) return true;
          return false;
        };
        expect(await works()).toBe(true);
      }
      preview.end();
    },
    600_000,
  );

  it.runIf(NIGHTLY && isThere(name))(
    `${name}: how long it takes until something is shown`,
    async () => {
      const { page, mesh, design } = await opened(name);
      const { source, settings } = design;
      const wish = { ...FAIR_FLAT, keepBoundary: true };
      const run = (how: typeof wish): Promise<string> => {
        const trials = new PlanariseTrials(page.spawn, new TrialMemory(0));
        const wanted = { source, cuts: settings.cuts, how, split: 0 };
        return spent(() => trials.run(wanted).catch(() => null));
      };
      const quick = await run(quickWay(wish, mesh));
      const near = await run(nearWay({ ...wish, keepBoundary: false }, mesh));
      console.info(
        `${name}: opened, near the file ${quick} s, then ${near} s, as asked for ${await run(wish)} s`,
      );
    },
    600_000,
  );
}
