#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What docs/fabrication.md says of whole meshes: cutting packages held against what OBJ files alone say.

Usage: bash .tools/start/build.sh native && python3 .tools/measure/shop-audit.py [--drawings] MESH.obj...

Each mesh is made flat by `planish project`, cut with sheets four times its widest panel, pulled up at its
middle vertex and cut again against what it was. A line for each, and one for all that come out flat. With
--drawings every DXF is also read by ezdxf and shapely (tests/reference/check_package.py), which takes minutes.
"""

import collections
import csv
import io
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import zipfile

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("PLANISH", ROOT / "build/native/planish")
SAME_ANGLE = 1e-8  # rad; by less, nothing is made again


def planish(*words):
    run = subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True)
    assert run.returncode in (0, 4), run.stderr
    return run.returncode == 0


class ObjMesh:
    def __init__(self, path):
        rows = [line.split() for line in path.read_text().splitlines()]
        self.points = np.array([[float(x) for x in r[1:4]] for r in rows if r[:1] == ["v"]])
        self.faces = [[int(c.split("/")[0]) - 1 for c in r[1:]] for r in rows if r[:1] == ["f"]]

    def corners(self, face):
        return self.points[self.faces[face]]

    def normals(self):
        """By Newell's sum, about the first corner."""
        sums = []
        for face in range(len(self.faces)):
            p = self.corners(face) - self.corners(face)[0]
            sums.append(np.cross(p, np.roll(p, -1, axis=0)).sum(axis=0))
        return np.array([s / np.linalg.norm(s) for s in sums])

    def sides(self):
        """(lower, higher vertex) -> [(face, side)]."""
        found = collections.defaultdict(list)
        for face, ring in enumerate(self.faces):
            for side, start in enumerate(ring):
                end = ring[(side + 1) % len(ring)]
                found[min(start, end), max(start, end)].append((face, side))
        return found

    def dihedrals(self):
        """(face, side) -> angle on the inside in rad, of every side with a neighbour."""
        normals, angles = self.normals(), {}
        for users in self.sides().values():
            if len(users) != 2:
                continue
            (a, side), (b, _) = users
            ring = self.faces[a]
            along = self.points[ring[(side + 1) % len(ring)]] - self.points[ring[side]]
            along /= np.linalg.norm(along)
            same_way = len({(self.faces[f][s]) for f, s in users}) == 1
            other = -normals[b] if same_way else normals[b]
            turn = np.arctan2(np.cross(normals[a], other) @ along, normals[a] @ other)
            for user in users:
                angles[user] = np.pi - turn
        return angles


def tables(path):
    archive = zipfile.ZipFile(path)
    read = lambda name: list(csv.DictReader(io.StringIO(archive.read(name).decode(), newline="")))
    names = archive.namelist()
    header = json.loads(archive.read("package.json"))
    return read("panels.csv"), read("edges.csv"), read("nodes.csv"), names, header


def length_deviation(mesh, panels):
    """Of the sides of the outlines, relative to those in space."""
    worst = 0.0
    for face, row in enumerate(panels):
        flat = 1e-3 * np.array(row["outline"].split(), float).reshape(-1, 2)
        sides = [np.linalg.norm(np.roll(p, -1, axis=0) - p, axis=1) for p in (flat, mesh.corners(face))]
        worst = max(worst, np.abs(sides[0] / sides[1] - 1).max())
    return worst


def check_edges(mesh, panels, edges):
    """How many are inside; the largest relative difference of a length on its panels, of an angle in rad."""
    rows = {(int(row["panel"][2:]) - 1, int(row["side"])): row for row in edges}
    angles, inside, lengths, turned = mesh.dihedrals(), 0, 0.0, 0.0
    for users in mesh.sides().values():
        if len(users) != 2:
            continue
        inside += 1
        (a, side), (b, other) = users
        row = rows.get((a, side)) or rows[b, other]
        assert {row["panel"], row["neighbour"]} == {panels[a]["panel"], panels[b]["panel"]}
        for (face, k), beyond in ((users[0], b), (users[1], a)):
            assert panels[face]["neighbours"].split()[k] == panels[beyond]["panel"], (face, k)
            assert panels[face]["edges"].split()[k] == row["edge"], (face, k)
            on_panel = float(panels[face]["edge_lengths"].split()[k])
            lengths = max(lengths, abs(on_panel / float(row["length"]) - 1))
        turned = max(turned, abs(np.radians(float(row["dihedral"])) - angles[users[0]]))
    assert inside == sum(row["neighbour"] != "-" for row in edges)
    return inside, lengths, turned


def has_turned(before, after, start, end):
    """Whether an arm between two nodes points elsewhere."""
    a, b = before[end] - before[start], after[end] - after[start]
    return np.linalg.norm(np.cross(a, b)) > SAME_ANGLE * (a @ b)


def check_remake(before, after, panels, nodes):
    """Panels and nodes by `change`, each held against the two OBJ files."""
    moved = (before.points != after.points).any(axis=1)
    was, now = before.dihedrals(), after.dihedrals()
    wrong, counts, arms = 0, collections.Counter(), set()
    for face, ring in enumerate(before.faces):
        turned = any(
            abs(now[face, k] - was[face, k]) > SAME_ANGLE for k in range(len(ring)) if (face, k) in was
        )
        expected = "outline" if moved[ring].any() else "bevel" if turned else "unchanged"
        wrong += panels[face]["change"] != expected
        counts[expected] += 1
        for k, start in enumerate(ring):
            end = ring[(k + 1) % len(ring)]
            if not has_turned(before.points, after.points, start, end):
                continue
            arms.update(v for v in (start, end) if not moved[v])
    said = {int(row["vertex"]): row["change"] for row in nodes}
    missed = [v for v in said if moved[v] and said[v] != "moved" or not moved[v] and said[v] == "moved"]
    missed += [v for v in arms if said[v] == "unchanged"]
    more = sum(change == "arms" and v not in arms for v, change in said.items())
    return counts, wrong, len(missed), more


def audit(path, folder, with_drawings):
    flat_path, base_zip = folder / "flat.obj", folder / "base.zip"
    flat = planish("project", path, "-o", flat_path)
    mesh = ObjMesh(flat_path)
    widths = [np.ptp(mesh.corners(f), axis=0) for f in range(len(mesh.faces))]
    sheet = 4000 * max(np.linalg.norm(w) for w in widths)
    planish("panels", flat_path, "-o", base_zip, "--sheet", f"{sheet:.0f}x{sheet:.0f}")
    panels, edges, _, names, header = tables(base_zip)
    result = collections.Counter(
        meshes=1, panels=len(panels), dxf=sum(name.endswith(".dxf") for name in names)
    )
    deviation = length_deviation(mesh, panels)
    result["edges"], lengths, turned = check_edges(mesh, panels, edges)
    used = header["sheets"]["used_fraction"]
    said = f"2D against 3D {deviation:.1e}, lengths {lengths:.1e}, angles {turned:.1e} rad, used {used:.2f}"
    if flat:
        longest = max(float(row["length"]) for row in edges) / 1000
        pull = f"{len(mesh.points) // 2}+=0,0,{0.2 * longest}"
        edited, edited_zip = folder / "edited.obj", folder / "edited.zip"
        planish("edit", flat_path, "--handle", pull, "-o", edited)
        planish("panels", edited, "--against", flat_path, "-o", edited_zip)
        again, _, nodes, _, _ = tables(edited_zip)
        counts, wrong, missed, more = check_remake(mesh, ObjMesh(edited), again, nodes)
        said += f", {counts['outline']} outline, {counts['bevel']} bevel, {wrong} panels differ"
        said += f", {missed} nodes missed, {more} more"
        result.update(outline=counts["outline"], bevel=counts["bevel"], differ=wrong, missed=missed, more=more)
    if with_drawings:
        check = ROOT / "tests/reference/check_package.py"
        faults = subprocess.run(["/usr/bin/python3", check, base_zip], capture_output=True, text=True)
        said += ", drawings sound" if faults.returncode == 0 else f", DRAWINGS: {faults.stderr.strip()}"
    print(f"{path.stem}{'' if flat else ' (not flat)'}: {dict(result)}, {said}", flush=True)
    return result if flat else collections.Counter(), *(x if flat else 0.0 for x in (deviation, lengths, turned))


def main(words):
    total, worst = collections.Counter(), np.zeros(3)
    with_drawings = "--drawings" in words
    with tempfile.TemporaryDirectory() as folder:
        for word in words:
            if word == "--drawings":
                continue
            result, *figures = audit(pathlib.Path(word), pathlib.Path(folder), with_drawings)
            total.update(result)
            worst = np.maximum(worst, figures)
    print(f"flat: {dict(total)}; at most 2D {worst[0]:.1e}, lengths {worst[1]:.1e}, angles {worst[2]:.1e} rad")


main(sys.argv[1:])
