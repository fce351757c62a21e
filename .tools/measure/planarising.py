#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What planarising with its defaults does to the shared meshes: the figures of decisions 13 and 49.

    /usr/bin/python3 .tools/measure/planarising.py [FOLDER]

Every mesh that is not flat, first with the defaults of `planish project`, then with its boundary kept.
Panels, folds and boundaries are measured by the survey's own code.
"""

import json
import sys
import tempfile
from pathlib import Path

import numpy as np
from survey import ROOT, Topology, damage, mean_edge, read_obj, run

PLANISH = ROOT / "build" / "native" / "planish"


def measure(path, options, scratch):
    out, report = scratch / "flat.obj", scratch / "report.json"
    run(PLANISH, ["project", path, *options, "-o", out, "--report", report])
    before, faces = read_obj(path)
    after, _ = read_obj(out)
    topology = Topology(faces)
    said = json.loads(report.read_text())
    spoilt = [damage(before[face], after[face]) for face in faces]
    sharp = [float(np.percentile(topology.folds(points), 95)) for points in (before, after)]
    return {"bent": said["planarity_mm_per_m"]["before_max"], "left": said["planarity_mm_per_m"]["after_max"],
            "spoilt": sum(d is not None for d in spoilt), "concave": spoilt.count("concave"), "folds": sharp,
            "move": float(np.linalg.norm(after - before, axis=1).max()) / mean_edge(before, faces),
            "boundary_moved": int(np.any(before != after, axis=1)[topology.boundary].sum())}


def words(row):
    flat = "flat" if row["left"] <= 1e-6 else f"{row['left']:.3g} mm/m left"
    return (f"{row['spoilt']} | {row['folds'][0]:.1f} → {row['folds'][1]:.1f} "
            f"({row['folds'][1] / max(row['folds'][0], 1e-9):.2f}) | {row['move']:.2f} | {flat}")


def main():
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT.parent / "shared" / "meshes"
    columns = "newly spoilt | fold p95, ° | largest move, edges | result"
    print(f"| mesh (mm/m) | {columns} | boundary kept: {columns} | boundary points moved |")
    print("|" + " --- |" * 10)
    with tempfile.TemporaryDirectory() as name:
        scratch = Path(name)
        for path in sorted(folder.glob("*.obj")):
            free = measure(path, [], scratch)
            if free["bent"] <= 1e-6:
                continue
            kept = measure(path, ["--keep-boundary"], scratch)
            print(f"| {path.stem} ({free['bent']:.3g}) | {words(free)} | {words(kept)} "
                  f"| {kept['boundary_moved']} |", flush=True)


if __name__ == "__main__":
    main()
