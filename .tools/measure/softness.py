#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What the softness scale does: the figures of docs/decisions/0009-reach-and-softness.md.

    python3 .tools/measure/softness.py scale              every step of the scale, on the five samples
    python3 .tools/measure/softness.py page FOLDER ...    the page's defaults on meshes of a folder

Lifts inner points along their normals with build/native/planish and measures the written mesh by its
own code: points outside the reach or on the boundary that moved, folds edge by edge.
"""

import json
import math
import random
import statistics
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PLANISH = ROOT / "build/native/planish"
SAMPLES = ("vault", "dome", "freeform", "hex", "trihex")
SCALE = range(1, 11)
PAGE = {"reach": 6, "softness": 5, "attraction": 10_000}
FLAT = (
    "pq_conical_saddle pq_six_planarized pq_gitter pq_botanic_bubble pq_lifted_small "
    "pq_wein99_diag pq_enneper_quads pq_static_roof"
).split()


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def length(a):
    return math.sqrt(sum(x * x for x in a))


def read_obj(path):
    points, faces = [], []
    for line in Path(path).read_text().splitlines():
        words = line.split()
        if words[:1] == ["v"]:
            points.append(tuple(map(float, words[1:4])))
        elif words[:1] == ["f"]:
            faces.append([int(word.split("/")[0]) - 1 for word in words[1:]])
    return points, faces


class Mesh:
    def __init__(self, path):
        self.path = path
        self.name = Path(path).stem
        self.points, self.faces = read_obj(path)
        self.sides = {}
        for f, face in enumerate(self.faces):
            for a, b in zip(face, face[1:] + face[:1]):
                self.sides.setdefault((min(a, b), max(a, b)), []).append((f, a < b))
        lengths = [length(minus(self.points[a], self.points[b])) for a, b in self.sides]
        self.edge = sum(lengths) / len(lengths)
        self.around = [[] for _ in self.points]
        for f, face in enumerate(self.faces):
            for v in face:
                self.around[v].append(f)
        self.boundary = {v for edge, uses in self.sides.items() if len(uses) == 1 for v in edge}

    def rings(self, seeds, most):
        found, front = set(seeds), list(seeds)
        for _ in range(most):
            front = [w for v in front for f in self.around[v] for w in self.faces[f]]
            front = list(set(front) - found)
            found.update(front)
        return found

    def normal(self, face, points):
        total = (0.0, 0.0, 0.0)
        for a, b in zip(face[1:], face[2:]):
            n = cross(minus(points[a], points[face[0]]), minus(points[b], points[face[0]]))
            total = tuple(x + y for x, y in zip(total, n))
        return total

    def folds(self, points):
        normals = [self.normal(face, points) for face in self.faces]
        folds = {}
        for edge, uses in self.sides.items():
            if len(uses) != 2:
                continue
            (f, forward), (g, also) = uses
            a, b = normals[f], normals[g]
            if forward == also:
                b = tuple(-x for x in b)
            dot = sum(x * y for x, y in zip(a, b))
            folds[edge] = math.degrees(math.atan2(length(cross(a, b)), dot))
        return folds

    def lift(self, vertex, edges):
        total = (0.0, 0.0, 0.0)
        for f in self.around[vertex]:
            n = self.normal(self.faces[f], self.points)
            total = tuple(x + y / length(n) for x, y in zip(total, n))
        return [x / length(total) * edges * self.edge for x in total]


def edit(mesh, vertex, edges, reach, softness, folder, attraction=1000):
    """Figures of one edit, measured on the file that was written."""
    out = Path(folder) / f"{mesh.name}-{vertex}-{edges}-{reach}-{softness}.obj"
    move = ",".join(map(repr, mesh.lift(vertex, edges)))
    words = [PLANISH, "edit", mesh.path, "--handle", f"{vertex}+={move}", "--keep-boundary"]
    words += ["--attraction", str(attraction)]
    words += ["--reach", str(reach), "--softness", str(softness), "-o", out, "--report", "-"]
    words[-1] = f"{out}.json"
    subprocess.run(words, capture_output=True)
    report = json.loads(Path(f"{out}.json").read_text())
    points = read_obj(out)[0]
    out.unlink()
    moved = {v for v, (p, q) in enumerate(zip(mesh.points, points)) if p != q}
    before, after = mesh.folds(mesh.points), mesh.folds(points)
    return {
        "strayed": len(moved - mesh.rings([vertex], reach)) + len(moved & mesh.boundary),
        "moved": len(moved),
        "kink": max(after[edge] - before[edge] for edge in after),
        "sharpest": max(max(after.values()), max(before.values())),
        "short": 100 * report["handle_error"] / (edges * mesh.edge),
        "spoilt": sum(map(len, report["spoilt_faces"].values())),
        "ms": 1000 * report["seconds"]["solve"],
    }


def cases(meshes, points, lifts, reaches, seed):
    picked = random.Random(seed)
    for mesh in meshes:
        inner = sorted(set(range(len(mesh.points))) - mesh.rings(mesh.boundary, 2))
        inner = [v for v in inner if mesh.around[v]]
        for vertex in picked.sample(inner, points):
            for edges in lifts:
                for reach in reaches:
                    yield mesh, vertex, edges, reach


def middle(runs, key, share=0.5):
    values = sorted(run[key] for run in runs)
    return statistics.median(values) if share == 0.5 else values[int(share * (len(values) - 1))]


def show(name, cells):
    print(f"| {name} | " + " | ".join(cells) + " |")


def scale(folder):
    meshes = []
    for name in SAMPLES:
        path = Path(folder) / f"{name}.obj"
        subprocess.run([PLANISH, "sample", name, "--size", "21", "-o", path], check=True)
        meshes.append(Mesh(path))
    work = list(cases(meshes, 6, (0.25, 0.5, 1.0), (4, 6), 1))
    with ThreadPoolExecutor(2) as pool:
        runs = list(pool.map(lambda c: [edit(*c, s, folder) for s in SCALE], work))
    for edges in (0.25, 0.5, 1.0):
        rows = [row for case, row in zip(work, runs) if case[2] == edges]
        print(f"\n{len(rows)} points lifted by {edges} mean edges\n")
        show("softness", map(str, SCALE))
        show("---", ["---"] * len(SCALE))
        for key in ("kink", "moved", "short", "ms"):
            show(f"{key}, median", (f"{middle([r[k] for r in rows], key):.3g}" for k in range(10)))
        show("kink, p90", (f"{middle([r[k] for r in rows], 'kink', 0.9):.3g}" for k in range(10)))
        show("spoilt", (str(sum(r[k]["spoilt"] > 0 for r in rows)) for k in range(10)))
        sharper = [sum(r[k]["sharpest"] > r[k - 1]["sharpest"] + 0.1 for r in rows) for k in range(1, 10)]
        show("sharper than one step harder", ["", *map(str, sharper)])
        print(f"strayed: {sum(run['strayed'] for row in rows for run in row)}")


def page(folder, meshes_from):
    meshes = []
    for name in FLAT:
        path = Path(folder) / f"{name}.obj"
        subprocess.run([PLANISH, "project", Path(meshes_from) / f"{name}.obj", "-o", path], check=True)
        meshes.append(Mesh(path))
    work = list(cases(meshes, 2, (0.25, 0.5), (PAGE["reach"],), 1))
    with ThreadPoolExecutor(2) as pool:
        runs = list(pool.map(lambda c: edit(*c, PAGE["softness"], folder, PAGE["attraction"]), work))
    for edges in (0.25, 0.5):
        some = [run for case, run in zip(work, runs) if case[2] == edges]
        figures = ", ".join(f"{key} {middle(some, key):.3g}" for key in ("kink", "short", "moved", "ms"))
        print(f"{len(some)} edits at {edges}: median {figures}; kink p90 {middle(some, 'kink', 0.9):.3g}; "
              f"spoilt {sum(run['spoilt'] > 0 for run in some)}; strayed {sum(run['strayed'] for run in some)}")
    print(f"all {len(runs)}: median kink {middle(runs, 'kink'):.3g}")


def main():
    with tempfile.TemporaryDirectory() as folder:
        if sys.argv[1:2] == ["scale"]:
            scale(folder)
        elif sys.argv[1:2] == ["page"] and len(sys.argv) == 3:
            page(folder, sys.argv[2])
        else:
            sys.exit(__doc__)


if __name__ == "__main__":
    main()
