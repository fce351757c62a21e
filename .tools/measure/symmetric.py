#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What a symmetric edit costs beside the edit of its one handle: ratios of factorizations and of processor time.

    /usr/bin/python3 .tools/measure/symmetric.py [--planish FILE] [--meshes DIR] [--folder DIR] [--points N] [--runs N]
                                                 [--only NAME,...] [--keep RUN.json]

The symmetric meshes of features.py, each symmetry that `planish info` finds in one and all of them at once; N seeded
points off every plane and axis, pulled along their normals by half a mean edge and by one, with the page's settings and
with the default ones. The time is that of the command's process, the least of the runs. "both" are pairs of which each is
certified. Lists the pairs that are dearer than the target. Exits with 1 where an end is not symmetric or not flat.
"""

import argparse
import json
import os
import subprocess
import sys
import tempfile
import zlib
from pathlib import Path

import counts
import features
import numpy as np
import survey

MODES = {"page": counts.PAGE, "default": ""}
TARGET = 1.3
OFF = 0.25  # mean edges from planes and axes
EVEN = 1e-9  # mean edges
REFUSED = 2  # exit code


def timed(command):
    """Exit code and processor seconds of the process, its start included."""
    process = subprocess.Popen([*map(str, command)], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    return os.waitstatus_to_exitcode(status), usage.ru_utime + usage.ru_stime


def measured(options, path, words, scratch):
    """The report and the time; None where the point is on a plane between two images, whose normal is not exactly in it."""
    report = scratch / "edit.json"
    command = [options.planish, "edit", path, *words, "-o", scratch / "edit.obj", "--report", report]
    runs = [timed(command) for _ in range(options.runs)]
    if runs[0][0] == REFUSED and "--symmetry" in words:
        return None
    if runs[0][0] not in (0, 4):
        sys.exit(f"symmetric: {' '.join(map(str, command))}: exit {runs[0][0]}")
    return json.loads(report.read_text()), min(seconds for _, seconds in runs)


def symmetries(options, path):
    said = subprocess.run([options.planish, "info", path], capture_output=True, text=True, check=True)
    elements = json.loads(said.stdout)["symmetry"]["elements"]
    return elements + (["auto"] if len(elements) > 1 else [])


def pulls(name, path, count):
    points, faces = survey.read_obj(path)
    edge = survey.mean_edge(points, faces)
    used = sorted({v for face in faces for v in face})
    middle = (points[used].min(axis=0) + points[used].max(axis=0)) / 2
    clear = [v for v in used if np.abs(points[v] - middle).min() > OFF * edge]
    random = np.random.default_rng(zlib.crc32(name.encode()))
    for v in random.choice(clear, size=min(count, len(clear)), replace=False):
        normal = np.sum([survey.area_vector(points[f]) for f in faces if v in f], axis=0)
        for lift in counts.LIFTS:
            yield f"{v}+={counts.written(lift * edge * normal / np.linalg.norm(normal))}", f"{name} {v} {lift}"


def pairs(options, name, path, scratch):
    for handle, label in pulls(name, path, options.points):
        for mode, text in MODES.items():
            words = ["--handle", handle, *text.split()]
            alone, time_alone = measured(options, path, words, scratch)
            for symmetry in symmetries(options, path):
                found = measured(options, path, [*words, "--symmetry", symmetry], scratch)
                if not found:
                    continue
                made, time = found
                yield {"pair": label, "mode": mode, "symmetry": symmetry, "images": made["symmetry"]["images"],
                       "factorizations": [alone["factorizations"], made["factorizations"]],
                       "seconds": [time_alone, time], "status": [alone["status"], made["status"]],
                       "asymmetry": made["symmetry"]["asymmetry_mean_edges"],
                       "planarity": made["planarity_mm_per_m"]["after_max"]}


def ratio(row, what):
    alone, made = row[what]
    return made / max(alone, 1) if what == "factorizations" else made / alone


def tell(label, rows):
    both = sum(row["status"] == ["converged", "converged"] for row in rows)
    within = {what: 100 * np.mean([ratio(row, what) <= TARGET for row in rows]) for what in ("factorizations", "seconds")}
    print(f"{label:22s} {len(rows):4d} pairs, {both:4d} both, p50 / p90 / worst and share within {TARGET}: " + "; ".join(
        f"{what} " + " / ".join(f"{survey.percentile([ratio(row, what) for row in rows], p):.2f}" for p in (50, 90, 100))
        + f", {within[what]:.0f} %" for what in within), flush=True)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--planish", type=Path, default=survey.ROOT / "build" / "native" / "planish")
    parser.add_argument("--folder", type=Path, default=survey.ROOT.parent / "shared" / "meshes")
    parser.add_argument("--meshes", type=Path)
    parser.add_argument("--points", type=int, default=3, help="seeded, a mesh")
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--only", default="")
    parser.add_argument("--keep", type=Path)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        scratch = Path(folder)
        if options.meshes:
            options.meshes.mkdir(parents=True, exist_ok=True)
        meshes, _ = counts.flat_meshes(options.planish, options.folder, options.meshes or scratch, ())
        names = options.only.split(",") if options.only else features.SYMMETRIC
        rows = [row for name in names for row in pairs(options, name, meshes[name], scratch)]
    if options.keep:
        options.keep.write_text(json.dumps(rows))
    for mode in MODES:
        of_mode = [row for row in rows if row["mode"] == mode]
        tell(mode, of_mode)
        for images in sorted({row["images"] for row in of_mode}):
            tell(f"  {images} images", [row for row in of_mode if row["images"] == images])
    for row in rows:
        if ratio(row, "factorizations") > TARGET:
            print(f"  {row['pair']:32s} {row['mode']:8s} {row['symmetry']:9s} {row['factorizations']} "
                  f"{row['seconds'][0]:.3f} {row['seconds'][1]:.3f} {row['status']}")
    if any(row["asymmetry"] > EVEN or row["planarity"] > counts.FLAT for row in rows):
        sys.exit(1)


if __name__ == "__main__":
    main()
