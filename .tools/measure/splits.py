#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Whether handles that stop short arrive once a few panels are split: random points of samples and shared
meshes pulled one to two edges along the normal, softness 3, folds at most 8 degrees sharper. Of the edits
that stop more than 5 % short there, `--split-where-needed 4` is measured with folds up to 30 degrees sharper
(and with 8 for the first SHARP of a mesh): the curve falls strictly, and every tenth design replays to the bit.
Writes a line an edit, then the shares. A NAME is a sample:size, a shared mesh, or the path of one made flat
already; what is drawn depends on the name and SEED alone, so meshes may be measured in pieces. An edit that
takes more than LIMIT seconds of processor time is ended there and counts by what it found.

Usage: /usr/bin/python3 .tools/measure/splits.py [--edits N] [--sharp N] [--seed N] [--limit SECONDS] [--planish FILE] [NAME...]"""

import argparse
import collections
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import zlib

import numpy as np

TREE = pathlib.Path(__file__).resolve().parents[2]
PLANISH = TREE / "build/native/planish"
MESHES = TREE.parent / "shared/meshes"
BENT = ["quad_heart", "quad_helical_minimal", "quad_pillow", "quad_wein99"]  # no flat mesh near
SAMPLES = ["freeform:32", "vault:24", "dome:24", "hex:20", "trihex:20", "roof:24"]
PAGE = ["--softness=3", "--reach=6", "--keep-boundary", "--attraction=10000"]
WITHIN = 0.05
REPLAYED = 10


def said(*words, folder):
    return subprocess.run([said.planish, *map(str, words)], cwd=folder, capture_output=True, text=True, check=False)


said.planish = PLANISH
said.limit = float("inf")


def flat_mesh(name, folder):
    """Points and panels of m.obj; None where there is no flat mesh near."""
    if ":" in name:
        kind, size = name.split(":")
        run = said("sample", kind, "--size", size, "-o", "m.obj", folder=folder)
    else:
        run = said("project", MESHES / name, "-o", "m.obj", folder=folder)
    if run.returncode:
        return None
    rows = [line.split() for line in (folder / "m.obj").read_text().splitlines()]
    points = np.array([row[1:4] for row in rows if row and row[0] == "v"], float)
    panels = [[int(word.split("/")[0]) - 1 for word in row[1:]] for row in rows if row and row[0] == "f"]
    return points, panels


def inner_points(panels):
    sides = collections.Counter(
        frozenset(side) for panel in panels for side in zip(panel, panel[1:] + panel[:1], strict=True))
    rim = {v for side, count in sides.items() if count == 1 for v in side}
    return sorted({v for panel in panels for v in panel} - rim)


def normal_at(v, points, panels):
    total = np.zeros(3)
    for panel in panels:
        if v in panel:
            corners = points[panel]
            total += np.cross(corners, np.roll(corners, -1, axis=0)).sum(axis=0)
    return total / np.linalg.norm(total)


def processor_time(pid):
    fields = pathlib.Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def edited(folder, handle, fold, *more):
    """The report, and whether the edit was ended early, as by Ctrl-C, which keeps what it found."""
    words = ["edit", "m.obj", f"--handle={handle}", *PAGE, f"--bound=fold=+{fold}", *more, "--report", "e.json",
             "-o", "e.obj", "--design", "e.design.json"]
    (folder / "e.json").unlink(missing_ok=True)
    ended = False
    with (folder / "said.txt").open("w") as spoken, subprocess.Popen(
            [said.planish, *words], cwd=folder, stdout=spoken, stderr=spoken) as run:
        while run.poll() is None:
            if not ended and processor_time(run.pid) > said.limit:
                run.send_signal(signal.SIGINT)
                ended = True
            time.sleep(0.02)
    if not (folder / "e.json").exists():
        raise RuntimeError((folder / "said.txt").read_text())
    return json.loads((folder / "e.json").read_text()), ended


def replays(folder):
    said("replay", "e.design.json", "-o", "again.obj", folder=folder)
    return (folder / "e.obj").read_bytes() == (folder / "again.obj").read_bytes()


def measure_split(folder, handle, fold, way):
    begin = time.monotonic()
    report, ended = edited(folder, handle, fold, "--split-where-needed=4")
    curve = report["splits"]["curve"]
    errors = [standing["handle_error"] / way for standing in curve]
    falls = all(after < before for before, after in zip(errors, errors[1:], strict=False))
    steps = " ".join(f"{s['cuts']}:{100 * e:.0f}%({s['remade_panels']},{s['sharpest_fold']:.0f})"
                     for s, e in zip(curve, errors, strict=True))
    print(f"   fold=+{fold} {time.monotonic() - begin:.1f} s, {report['splits']['tried']} tried, "
          f"{report['splits']['factorizations']} factorizations: {steps}{' ended' * ended}", flush=True)
    agrees = abs(report["handle_error"] / way - errors[-1]) < 1e-12
    return errors[-1] <= WITHIN, curve[-1]["cuts"], falls and agrees, ended


def asked():
    shared = sorted(path.name for path in MESHES.glob("*.obj") if path.stem not in BENT)
    parser = argparse.ArgumentParser()
    parser.add_argument("--edits", type=int, default=200, help="over all meshes")
    parser.add_argument("--sharp", type=int, default=0, help="of a mesh, at +8 as well")
    parser.add_argument("--seed", type=int, default=38)
    parser.add_argument("--limit", type=float, default=float("inf"), metavar="SECONDS")
    parser.add_argument("--planish", type=pathlib.Path, default=PLANISH)
    parser.add_argument("names", nargs="*", default=[*SAMPLES, *shared], metavar="NAME")
    return parser.parse_args()


def main():
    given = asked()
    names, edits = given.names, given.edits
    said.planish, said.limit = given.planish.resolve(), given.limit
    found = []
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        for place, name in enumerate(names):
            rng = np.random.default_rng([given.seed, zlib.crc32(pathlib.Path(name).name.encode())])
            sharp = given.sharp
            mesh = flat_mesh(name, folder)
            if mesh is None:
                print(name, "has no flat mesh near")
                continue
            points, panels = mesh
            edge = json.loads(said("info", "m.obj", folder=folder).stdout)["mesh"]["mean_edge"]
            share = (edits * (place + 1)) // len(names) - (edits * place) // len(names)
            for v in rng.permutation(inner_points(panels))[: 6 * share].tolist():
                if share == 0:
                    break
                way = edge * rng.uniform(1.0, 2.0)
                move = normal_at(v, points, panels) * way * rng.choice([-1.0, 1.0])
                handle = f"{v}+=" + ",".join(map(repr, move.tolist()))
                if edited(folder, handle, 8)[0]["handle_error"] <= WITHIN * way:
                    continue
                share -= 1
                print(f"{name} {handle}", flush=True)
                at_30 = measure_split(folder, handle, 30, way)
                same = len(found) % REPLAYED or replays(folder)
                at_8 = measure_split(folder, handle, 8, way) if sharp > 0 else None
                sharp -= 1
                found.append((at_30, bool(same), at_8))
    print(f"{len(found)} edits stop short at +8")
    for cuts in range(5):
        print(f"  at +30 with at most {cuts} cuts {sum(f[0][0] and f[0][1] <= cuts for f in found)} arrive")
    print(f"  {sum(f[0][3] for f in found)} are ended")
    at_8 = [f[2] for f in found if f[2]]
    print(f"  at +8 with at most 4 cuts {sum(f[0] for f in at_8)} of {len(at_8)}")
    bad = sum(not f[0][2] or not f[1] or bool(f[2] and not f[2][2]) for f in found)
    print(f"  {bad} curves that do not fall or replays with other bits")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
