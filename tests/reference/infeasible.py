#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Edits that end as "infeasible_handles", against an independent interior-point method: does it get the handles nearer?

    /usr/bin/python3 tests/reference/infeasible.py [--edits N] [--kinds NAME,...] [--points N] [--seed N]
                                                   [--planish FILE] [--folder DIR] [--scratch DIR]

Over all points that the edit may move: the least distance of the handle from its target such that panels are flat and keep
their shape, within the stated limits and on the supports, all written anew (rows.py, interior_point.py), from the product's
answer and from the base. Says of each kind how many edits it gets more than a hundredth of the pull nearer, and by how much;
what it finds counts where it is flat, sound and within its rows. Exits with 1 where that is more than 5 of 100 edits, or
where these rows do not hold an answer of the product.
"""

import argparse
import json
import sys
import tempfile
from pathlib import Path

import numpy as np
from nearest import compare
from optimality import ROOT, survey
from stated_edits import NEEDS_BOUNDARY, NEEDS_SMOOTH, STATED, Edit

SAMPLES = [("vault", 7), ("dome", 7), ("freeform", 7), ("hex", 4), ("trihex", 4)]
SHARED = ["hex_sphere_two_openings", "polyhedron_truncated_cuboct", "pq_lifted_small", "pq_static_roof", "pq_vase_small"]
NEARER = 0.01  # of the pull
ALLOWED = 0.05  # of the edits
SOFT_TRIES, MOST_TRIES = 6, 30  # of an edit that is to end infeasible: soft handles seldom do


def meshes_in(planish, folder, scratch):
    meshes = {}
    for name, size in SAMPLES:
        meshes[f"{name} {size}"] = scratch / f"{name}.obj"
        survey.run(planish, ["sample", name, "--size", size, "-o", scratch / f"{name}.obj"])
    for name in SHARED:
        if (folder / f"{name}.obj").exists():
            survey.run(planish, ["project", folder / f"{name}.obj", "-o", scratch / f"{name}.obj"])
            meshes[name] = scratch / f"{name}.obj"
    return meshes


def draw(meshes, kind, number, options, scratch):
    """An edit that ends infeasible, of a seed of its own; with hard handles where soft ones do not."""
    random = np.random.default_rng([options.seed, list(STATED).index(kind), number])
    for attempt in range(MOST_TRIES):
        name = list(meshes)[random.integers(len(meshes))]
        edit = Edit(name, meshes[name], random)
        edit.hard = attempt >= SOFT_TRIES
        if len(edit.moving()) > options.points or (kind in NEEDS_BOUNDARY and not edit.topology.boundary):
            continue
        if kind in NEEDS_SMOOTH and edit.topology.sharpest_fold(edit.base) >= 30:
            continue
        STATED[kind](edit, random)  # which may choose another handle
        if len(edit.moving()) <= options.points and edit.run(options.planish, scratch) == "infeasible_handles":
            return edit
    return None


def measured(edit, kind, options):
    ours, theirs, held = compare(edit)
    row = {"kind": kind, "mesh": edit.name, "hard": edit.hard, "points": len(edit.moving()), "ours": round(ours, 5),
           "found": round(theirs, 5) if np.isfinite(theirs) else None, "held": held,
           "nearer": bool(ours - theirs > NEARER), "arrives": bool(theirs < NEARER < ours)}
    print(json.dumps(row), flush=True)
    if row["nearer"] or not held:
        print("  ", edit.command(options.planish), flush=True)
    return row


def not_as_near(row):
    """It says nothing of such an edit."""
    return row["found"] is None or row["found"] > row["ours"] + NEARER


def told(found):
    print("| kind | edits | of them soft | nearer | by, median and worst, of the pull | arrives | not as near | not held |")
    print("|" + " --- |" * 8)
    for kind in [*dict.fromkeys(row["kind"] for row in found), "all"]:
        some = [row for row in found if kind in (row["kind"], "all")]
        by = [row["ours"] - row["found"] for row in some if row["nearer"]]
        said = f"{np.median(by):.3f}, {max(by):.3f}" if by else ""
        print(f"| {kind} | {len(some)} | {sum(not row['hard'] for row in some)} | {len(by)} | {said} "
              f"| {sum(row['arrives'] for row in some)} | {sum(not_as_near(row) for row in some)} "
              f"| {sum(not row['held'] for row in some)} |")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--edits", type=int, default=60)
    parser.add_argument("--kinds", default=",".join(STATED))
    parser.add_argument("--points", type=int, default=50, help="that an edit may move, at most")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--folder", type=Path, default=ROOT.parent / "shared" / "meshes")
    parser.add_argument("--planish", type=Path, default=ROOT / "build" / "native" / "planish")
    parser.add_argument("--scratch", type=Path, help="where the meshes stay, so that printed commands run")
    options = parser.parse_args()
    kinds, found = options.kinds.split(","), []
    with np.errstate(all="ignore"), tempfile.TemporaryDirectory() as folder:
        scratch = options.scratch or Path(folder)
        scratch.mkdir(exist_ok=True)
        meshes = meshes_in(options.planish, options.folder, scratch)
        for number in range(options.edits):
            kind = kinds[number % len(kinds)]
            edit = draw(meshes, kind, number // len(kinds), options, scratch)
            if edit:
                found.append(measured(edit, kind, options))
            else:
                print(f"{kind}: none of {MOST_TRIES} edits ends infeasible", flush=True)
    told(found)
    if sum(row["nearer"] for row in found) > ALLOWED * len(found) or any(not row["held"] for row in found):
        sys.exit(1)


if __name__ == "__main__":
    main()
