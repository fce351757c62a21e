#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""How few panels are made again, and whether the certificate holds: the middle of every sample and shared
mesh moved by half an edge, folds at most 15 degrees sharper. Compares --fewest panels with the edit as it
is and with the paper's sparsity alone, whose handle is asked for as far as the one with few panels came, and confirms of every point that moves, by an edit of its own, that
the handle does not arrive with that point held as well. Writes a line a mesh and the percentiles.

Usage: python3 .tools/measure/fewest.py [NAME...]"""

import concurrent.futures
import json
import os
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

TREE = pathlib.Path(__file__).resolve().parents[2]
PLANISH = TREE / "build/native/planish"
MESHES = TREE.parent / "shared/meshes"
SAMPLES = ["vault:32", "dome:24", "freeform:24", "hex:24", "trihex:24", "roof:24"]
FOLD = ["--bound=fold=+15"]
SOFT = ["--softness=5", "--reach=6"]
WITHIN = 0.05


def said(*words, folder, check=True):
    run = subprocess.run([PLANISH, *map(str, words)], cwd=folder, capture_output=True, text=True, check=False)
    if check and run.returncode not in (0, 4):
        raise RuntimeError(run.stderr)
    return run


def flat_mesh(name, folder):
    """A file that needs no planarising; None where there is no flat mesh near."""
    if name in SAMPLES:
        said("sample", name.split(":")[0], "--size", name.split(":")[1], "-o", "m.obj", folder=folder)
    elif said("project", MESHES / name, "-o", "m.obj", folder=folder, check=False).returncode:
        return None
    return folder / "m.obj"


def points_of(path):
    rows = [line.split()[1:4] for line in path.read_text().splitlines() if line.startswith("v ")]
    return np.array(rows, float)


def edited(words, folder, name):
    run = said("edit", "m.obj", *words, "--keep-boundary", "--report", name + ".json", "-o", name + ".obj",
               "--design", name + ".design.json", folder=folder, check=False)
    file = folder / (name + ".json")
    return json.loads(file.read_text()) if file.exists() else {"refused": run.stderr}


def confirm(handle, folder, report, longest):
    """Of the points that move: with how many of them held, too, the handle arrives all the same."""
    design = json.loads((folder / "few.design.json").read_text())
    pins = design.get("pins", [])
    before, after = points_of(folder / "m.obj"), points_of(folder / "few.obj")
    moved = [v for v in np.flatnonzero((before != after).any(axis=1)).tolist() if v != handle[0]]
    wrong = 0
    for v in moved:
        words = [f"--handle={handle[0]}+={handle[1]}", "--attraction=1e5", *FOLD, *SOFT,
                 "--pin=" + ",".join(map(str, [*pins, v]))]
        again = edited(words, folder, f"with{v}")
        usable = again["status"] in ("converged", "iteration_limit", "infeasible_handles", "nearest_confined")
        wrong += usable and again["handle_error"] <= WITHIN * longest
    return len(moved), wrong


def measure(name):
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        if flat_mesh(name, folder) is None:
            return name, None
        info = json.loads(said("info", "m.obj", folder=folder).stdout)
        points = points_of(folder / "m.obj")
        middle = int(np.linalg.norm(points - points.mean(axis=0), axis=1).argmin())
        longest = 0.5 * info["mesh"]["mean_edge"]
        handle = (middle, f"0,0,{longest!r}")
        pull = [f"--handle={middle}+={handle[1]}", *FOLD]
        soft = edited([*pull, *SOFT, "--attraction=1e5"], folder, "soft")
        few = edited([*pull, *SOFT, "--fewest=panels"], folder, "few")
        if "fewest" not in few:
            return name, None
        as_far = f"--handle={middle}+=0,0,{longest - few['handle_error']!r}"
        sparse = edited([as_far, *FOLD, "--reach=6", "--attraction=1e5"], folder, "sparse")
        row = {"reached": few["fewest"]["reached"], "minimal": few["fewest"]["minimal"],
               "soft": soft["remake"]["outline"], "sparse": sparse["remake"]["outline"],
               "sparse_error": (sparse["handle_error"] + few["handle_error"]) / longest, "few": few["remake"]["outline"],
               "error": few["handle_error"] / longest, "solves": few["fewest"]["solves"],
               "seconds": few["seconds"]["solve"] if "seconds" in few else 0.0, "fold": few["sharpest_fold"]["growth"]}
        if row["reached"]:
            row["points"], row["wrong"] = confirm(handle, folder, few, longest)
        return name, row


def main():
    shared = sorted(path.name for path in MESHES.glob("*.obj")) if MESHES.exists() else []
    names = sys.argv[1:] or [*SAMPLES, *shared]
    rows = []
    with concurrent.futures.ThreadPoolExecutor(int(os.environ.get("PLANISH_JOBS", os.cpu_count()))) as pool:
        for name, row in pool.map(measure, names):
            print(f"{name:36}", json.dumps(row) if row else "no flat mesh near, or refused", flush=True)
            if row and row["reached"] and row["soft"] > 0:
                rows.append(row)
    if not rows:
        sys.exit("fewest: no handle arrives")
    for word in ("sparse", "soft"):
        fewer = np.array([1 - row["few"] / max(row[word], 1) for row in rows])
        print(f"fewer panels than {word}: median {np.median(fewer):.0%}, least {fewer.min():.0%}")
    print(f"{len(rows)} edits, {sum(row['minimal'] for row in rows)} minimal, "
          f"{sum(row['points'] for row in rows)} points tested, {sum(row['wrong'] for row in rows)} not confirmed; "
          f"solves median {np.median([row['solves'] for row in rows]):.0f}, most {max(row['solves'] for row in rows)}")


main()
