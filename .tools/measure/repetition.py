#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Fewer types on the shared meshes, checked from the files alone: each is made flat, then
`project --within 0.5% --move 20%` makes more of its panels alike. With numpy and nothing of the product:
every panel is laid on the template that the report gives it (every first corner, singular values), every
panel is flat in the file, no point is farther than asked, no panel turned over or newly concave, no fold
more than five degrees sharper, the types told before are no more than a greedy cover of the panels by panels finds, and a second run writes
the same bytes. One line a mesh, then how many have half as many types.

Usage: /usr/bin/python3 .tools/measure/repetition.py [WITHIN% [MOVE% [NAME...]]]"""

import json
import pathlib
import subprocess
import sys
import tempfile
import time

import numpy as np

TREE = pathlib.Path(__file__).resolve().parents[2]
PLANISH = TREE / "build/native/planish"
MESHES = TREE.parent / "shared/meshes"
FLAT = 1e-6
SHARPER = 5.1  # degrees: the limit where none is stated, and a tenth for what is beyond it already
ROUNDING = 1e-9


def said(*words, folder):
    return subprocess.run([PLANISH, *map(str, words)], cwd=folder, capture_output=True, text=True, check=False)


def mesh_in(path):
    rows = [line.split() for line in path.read_text().splitlines()]
    points = np.array([row[1:4] for row in rows if row and row[0] == "v"], float)
    return points, [[int(word.split("/")[0]) - 1 for word in row[1:]] for row in rows if row and row[0] == "f"]


def area_vector(corners):
    return 0.5 * np.cross(corners, np.roll(corners, -1, axis=0)).sum(axis=0)


def outline(corners):
    """Corners in their best-fit plane, seen from outside, and mm per m that they are out of it."""
    off = corners - corners.mean(axis=0)
    axes = np.linalg.svd(off)[2]
    normal = axes[2] if axes[2] @ area_vector(off) >= 0 else -axes[2]
    heights = off @ normal
    sides = np.linalg.norm(np.roll(corners, -1, axis=0) - corners, axis=1)
    flat = np.column_stack([off @ axes[0], off @ np.cross(normal, axes[0])])
    return flat, 1000 * (heights.max() - heights.min()) / sides.max() if len(corners) > 3 else 0.0


def apart(panel, template):
    """The largest distance of corners after the best motion, of all first corners the least."""
    best = np.inf
    to = panel - panel.mean(axis=0)
    for first in range(len(template)):
        start = np.roll(template, -first, axis=0)
        start = start - start.mean(axis=0)
        u, _, vt = np.linalg.svd(start.T @ to)
        turn = u @ np.diag([1.0, np.sign(np.linalg.det(u @ vt))]) @ vt
        best = min(best, np.linalg.norm(start @ turn - to, axis=1).max())
    return best


def told_apart(outlines):
    """One of those that are the same to 1e-7 of their longest side, wherever they begin."""
    def turns(panel):
        sides = np.linalg.norm(np.roll(panel, -1, axis=0) - panel, axis=1)
        marks = np.column_stack([np.linalg.norm(panel - panel.mean(axis=0), axis=1), sides]) / sides.max()
        return min(tuple(np.round(np.roll(marks, -first, axis=0), 7).ravel()) + (round(sides.max(), 7),)
                   for first in range(len(panel)))

    return list({turns(panel): panel for panel in outlines}.values())


def greedy(outlines, within):
    """How many panels it takes to cover all, the one that covers most first."""
    def marks(panel):
        return np.sort(np.linalg.norm(panel - panel.mean(axis=0), axis=1))

    keys = [marks(panel) for panel in outlines]
    covers = [{k for k, key in enumerate(keys) if len(key) == len(mine) and np.abs(key - mine).max() <= within
               and apart(outlines[k], outlines[at]) <= within} for at, mine in enumerate(keys)]
    left, count = set(range(len(outlines))), 0
    while left:
        left -= max(covers, key=lambda cover: len(cover & left))
        count += 1
    return count


def concave(panel):
    side = np.roll(panel, -1, axis=0) - panel
    return bool((np.cross(np.roll(side, 1, axis=0), side) < 0).any())


def folds(points, faces):
    """Degrees between the normals of each two panels that share a side."""
    normals = [area_vector(points[face]) for face in faces]
    normals = [normal / np.linalg.norm(normal) for normal in normals]
    beside = {}
    for k, face in enumerate(faces):
        for side in zip(face, face[1:] + face[:1], strict=True):
            beside.setdefault(tuple(sorted(side)), []).append(k)
    pairs = [pair for pair in beside.values() if len(pair) == 2]
    return np.degrees([np.arctan2(np.linalg.norm(np.cross(normals[a], normals[b])), normals[a] @ normals[b])
                       for a, b in pairs])


def problems(before, after, faces, types, edge, within, move):
    """What the files do not keep of what was asked for."""
    panels = [outline(after[face]) for face in faces]
    given = [outline(before[face])[0] for face in faces]
    templates = [np.array(t["outline"]).reshape(-1, 2) for t in types["templates"]]
    members = [f for t in types["templates"] for f in t["panels"]]
    fit = max(apart(panels[f][0], template) for template, t in zip(templates, types["templates"], strict=True)
              for f in t["panels"])
    checks = {
        "not every panel has one type": sorted(members) != list(range(len(faces))),
        "types are counted wrongly": len(templates) != types["after"],
        f"a corner is {fit / edge:.5f} edges off": fit > within * edge * (1 + ROUNDING),
        "a panel is not flat": max(out for _, out in panels) > FLAT,
        "a point is too far": np.linalg.norm(after - before, axis=1).max() > move * edge * (1 + ROUNDING),
        "a fold is too sharp": (folds(after, faces) - folds(before, faces)).max(initial=0.0) > SHARPER,
        "a panel is turned over": any(area_vector(after[face]) @ area_vector(before[face]) <= 0 for face in faces),
        "a panel became concave": any(concave(panel) and not concave(was)
                                      for (panel, _), was in zip(panels, given, strict=True)),
        "there were fewer before": types["before"] > greedy(told_apart(given), within * edge),
    }
    return [name for name, broken in checks.items() if broken]


def measured(name, within, move, folder):
    """The line of a mesh, and whether it has half as many types and no problem."""
    if said("project", MESHES / name, "-o", "flat.obj", folder=folder).returncode:
        return f"{name:34} no flat mesh near", None
    words = ["project", "flat.obj", f"--within={100 * within}%", f"--move={100 * move}%"]
    begun = time.monotonic()
    if said(*words, "-o", "few.obj", "--report", "few.json", folder=folder).returncode:
        return f"{name:34} refused", False
    seconds = time.monotonic() - begun
    said(*words, "-o", "again.obj", folder=folder)
    (before, faces), (after, others) = mesh_in(folder / "flat.obj"), mesh_in(folder / "few.obj")
    types = json.loads((folder / "few.json").read_text())["types"]
    sides = {tuple(sorted(side)) for face in faces for side in zip(face, face[1:] + face[:1], strict=True)}
    edge = np.mean([np.linalg.norm(before[a] - before[b]) for a, b in sides])
    found = problems(before, after, faces, types, edge, within, move)
    if faces != others:
        found.append("other panels")
    if (folder / "few.obj").read_bytes() != (folder / "again.obj").read_bytes():
        found.append("another result the second time")
    moved = np.linalg.norm(after - before, axis=1).max() / edge
    line = (f"{name:34} {len(faces):5} panels {types['before']:5} -> {types['after']:5} types, moved {moved:.3f} "
            f"edges, folds {folds(before, faces).max():.1f} -> {folds(after, faces).max():.1f}, {seconds:.1f} s  {'; '.join(found) or 'holds'}")
    return line, not found and 2 * types["after"] <= types["before"]


def main(words):
    within, move = (0.01 * float(words[k]) if len(words) > k else value for k, value in ((0, 0.005), (1, 0.2)))
    half = []
    for name in words[2:] or sorted(path.name for path in MESHES.glob("*.obj")):
        with tempfile.TemporaryDirectory() as folder:
            line, halved = measured(name, within, move, pathlib.Path(folder))
        print(line, flush=True)
        half += [name] if halved else []
    print(f"{len(half)} have half as many types or fewer, checked")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
