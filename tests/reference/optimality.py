#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The independent check of "converged": first-order conditions of finished edits, on the whole mesh.

    /usr/bin/python3 tests/reference/optimality.py [--points N] [--lifts 0.3,0.8,1.5] [--only NAME,...]
                                                   [--publish] [-- OPTIONS OF planish edit]

Shares no code with the product: gradient of (3) with second differences, flatness rows and the barrier
of the corners are written anew, and the multipliers of all faces are sought here, by a Newton method on

    sum over moved points |pull + w/2 d/|d||^2  +  sum over points at rest max(0, |pull| - w/2)^2,

which is convex in them. Reports the largest of both in units of w/2, over edits that are called converged.
"""

import argparse
import json
import sys
import tempfile
from pathlib import Path

import numpy as np
import scipy.sparse as sp
from scipy.sparse.linalg import splu

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / ".tools/measure"))
import survey  # noqa: E402  meshes, edits and the file reader

ATTRACTION, LOCALITY, SMOOTHNESS = 1000.0, 1.0, 1.0
COUNTED = 1e-6  # of the pull: who moves less counts as at rest
BARRIER, KEEP, CLAMP = 1e-2, 0.05, 0.5
MET = 1e-4


def around_vertices(faces, count):
    """Neighbours of each vertex in order, and whether it is on the boundary; None where not one fan."""
    corners = [[] for _ in range(count)]
    for face in faces:
        for k, v in enumerate(face):
            corners[v].append((face[k - 1], face[(k + 1) % len(face)]))
    rings = []
    for links in corners:
        near = {}
        for a, b in links:
            near.setdefault(a, []).append(b)
            near.setdefault(b, []).append(a)
        ends = [v for v, others in near.items() if len(others) == 1]
        if not near or any(len(others) > 2 for others in near.values()) or len(ends) not in (0, 2):
            rings.append((None, True))
            continue
        at = ends[0] if ends else next(iter(near))
        ring, before = [at], None
        while len(ring) < len(near):
            step = next((v for v in near[ring[-1]] if v != before), None)
            if step is None or step in ring:
                break
            before = ring[-1]
            ring.append(step)
        rings.append((ring if len(ring) == len(near) else None, bool(ends)))
    return rings


def fairness(faces, count):
    rows, columns, values = [], [], []
    row = 0

    def add(entries):
        nonlocal row
        for v, x in entries:
            rows.append(row)
            columns.append(v)
            values.append(x)
        row += 1

    degree = [0] * count
    lone = {}
    for face in faces:
        for v in face:
            degree[v] += 1
            lone[v] = face
    for v, (ring, boundary) in enumerate(around_vertices(faces, count)):
        if ring is None or not ring:
            continue
        if boundary:
            if len(ring) < 2 or (degree[v] == 1 and len(lone[v]) < 5):
                continue
            add([(ring[0], 1.0), (v, -2.0), (ring[-1], 1.0)])
        elif len(ring) % 2:
            add([(v, -2.0)] + [(w, 2.0 / len(ring)) for w in ring])
        else:
            half = len(ring) // 2
            for k in range(half):
                add([(ring[k], 1.0), (v, -2.0), (ring[k + half], 1.0)])
    return sp.csr_matrix((values, (rows, columns)), shape=(row, count))


def jacobian(points, faces):
    """Rows of flatness: the corners of a face against the plane of three of them that are well apart."""
    rows, columns, values = [], [], []
    row = 0
    for face in faces:
        if len(face) < 4:
            continue
        corners = points[face]
        middle = corners.mean(axis=0)
        a = int(np.argmax(np.linalg.norm(corners - middle, axis=1)))
        b = int(np.argmax(np.linalg.norm(corners - corners[a], axis=1)))
        spans = np.linalg.norm(np.cross(corners[b] - corners[a], corners - corners[a]), axis=1)
        c = int(np.argmax(spans))
        for k in set(range(len(face))) - {a, b, c}:
            u, v, w = corners[b] - corners[a], corners[c] - corners[a], corners[k] - corners[a]
            scale = 1.0 / max(spans[c], 1e-12)
            gradients = {b: scale * np.cross(v, w), c: scale * np.cross(w, u), k: scale * np.cross(u, v)}
            gradients[a] = -sum(gradients.values())
            for corner, g in gradients.items():
                for axis in range(3):
                    rows.append(row)
                    columns.append(3 * face[corner] + axis)
                    values.append(g[axis])
            row += 1
    return sp.csr_matrix((values, (rows, columns)), shape=(row, 3 * len(points)))


def barrier_gradient(before, after, faces, moved):
    out = np.zeros_like(after)
    for face in faces:
        if not moved[face].any():
            continue
        normal = survey.area_vector(before[face])
        length = np.linalg.norm(normal)
        perimeter = sum(np.linalg.norm(before[face[k]] - before[face[k - 1]]) for k in range(len(face)))
        if not length > 1e-6 * perimeter**2:
            continue
        normal = normal / length
        for k in range(1 if len(face) == 3 else len(face)):
            a, b, c = face[k - 1], face[k], face[(k + 1) % len(face)]
            into, out_of = before[b] - before[a], before[c] - before[b]
            size = normal @ np.cross(into, out_of)
            if not abs(size) > 1e-3 * np.linalg.norm(into) * np.linalg.norm(out_of):
                continue
            share = (normal @ np.cross(after[b] - after[a], after[c] - after[b]) / size - KEEP) / (1 - KEEP)
            if share >= CLAMP:
                continue
            below = share - CLAMP
            slope = BARRIER * (-2 * below * np.log(share / CLAMP) - below**2 / share) / (size * (1 - KEEP))
            out[a] += slope * np.cross(after[b] - after[c], normal)
            out[b] += slope * np.cross(after[c] - after[a], normal)
            out[c] += slope * np.cross(after[a] - after[b], normal)
    return out


def conditions(pull, displacement, counted, free):
    """Residuals of the moved and of those at rest, in units of w/2, and d residual / d pull."""
    residual = np.zeros_like(pull)
    slopes = np.zeros((len(pull), 3, 3))
    length = np.linalg.norm(pull, axis=1)
    for v in range(len(pull)):
        if free[v]:  # a handle: no norm
            residual[v], slopes[v] = pull[v], np.eye(3)
        elif counted[v]:
            residual[v] = pull[v] + 0.5 * LOCALITY * displacement[v] / np.linalg.norm(displacement[v])
            slopes[v] = np.eye(3)
        elif length[v] > 0.5 * LOCALITY:
            unit = pull[v] / length[v]
            residual[v] = (length[v] - 0.5 * LOCALITY) * unit
            across = 1.0 - 0.5 * LOCALITY / length[v]
            slopes[v] = across * np.eye(3) + (1.0 - across) * np.outer(unit, unit)
    return residual / (0.5 * LOCALITY), slopes / (0.5 * LOCALITY)


def check(base, after, faces, handle, target, bounded):
    edge = survey.mean_edge(base, faces)
    before, now, target = base / edge, after / edge, target / edge
    displacement = now - before
    free = np.zeros(len(base), bool)
    free[handle] = True
    counted = np.linalg.norm(displacement, axis=1) > COUNTED * np.linalg.norm(target)
    operator = fairness(faces, len(base))
    force = SMOOTHNESS * (operator.T @ (operator @ displacement))
    force[handle] += ATTRACTION * (displacement[handle] - target)
    if bounded:
        force += barrier_gradient(before, now, faces, np.linalg.norm(displacement, axis=1) > 0)
    rows = jacobian(now, faces)
    multipliers = np.zeros(rows.shape[0])
    best = (np.inf, np.inf)
    foreseen = 1e-2
    for _ in range(300):
        pull = force + (rows.T @ multipliers).reshape(-1, 3)
        residual, slopes = conditions(pull, displacement, counted, free)
        size = np.linalg.norm(residual, axis=1)
        here = (size[counted | free].max(), size[~(counted | free)].max(initial=0.0))
        if max(here) < max(best):
            best = here
        if max(here) < 0.1 * MET:
            break
        # A little of every point at rest: one that comes near its bound is foreseen.
        blocks = sp.block_diag([s @ s.T + foreseen * np.eye(3) for s in slopes], format="csr")
        system = (rows @ blocks @ rows.T + 1e-12 * sp.eye(rows.shape[0])).tocsc()
        change = -splu(system).solve(rows @ (residual.ravel() / (0.5 * LOCALITY)))
        energy = (residual**2).sum()
        share = 1.0
        while share > 1e-4:
            trial = force + (rows.T @ (multipliers + share * change)).reshape(-1, 3)
            if (conditions(trial, displacement, counted, free)[0] ** 2).sum() < energy:
                break
            share *= 0.5
        foreseen = max(1e-9, 0.3 * foreseen) if share == 1.0 else min(1.0, 10.0 * foreseen)
        if share > 1e-4:
            multipliers += share * change
        elif foreseen == 1.0:
            break
    return best


def run(options, edit_options):
    bounded = "shape=off" not in edit_options
    lifts = [float(x) for x in options.lifts.split(",")]
    found = []
    with tempfile.TemporaryDirectory() as folder:
        scratch = Path(folder)
        only = set(filter(None, options.only.split(",")))
        meshes = survey.prepare(options.planish, options.folder, scratch, only)
        for job in survey.edits(meshes, options.points, lifts):
            if job["way"] != "normal":
                continue
            path = meshes[job["mesh"]]
            move = ",".join(repr(x) for x in job["move"])
            words = ["edit", path, "--handle", f"{job['vertex']}+={move}", *edit_options]
            survey.run(options.planish, [*words, "-o", scratch / "out.obj", "--report", scratch / "r.json"])
            report = json.loads((scratch / "r.json").read_text())
            row = {"mesh": job["mesh"], "vertex": job["vertex"], "lift": job["lift"], "status": report["status"]}
            if report["status"] == "converged":
                base, faces = survey.read_obj(path)
                after, _ = survey.read_obj(scratch / "out.obj")
                row["stationarity"], row["outside"] = check(
                    base, after, faces, job["vertex"], np.array(job["move"]), bounded)
                row["met"] = bool(max(row["stationarity"], row["outside"]) <= MET)
            found.append(row)
            print(json.dumps(row), flush=True)
    return found


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--points", type=int, default=1)
    parser.add_argument("--lifts", default="0.3,0.8,1.5")
    parser.add_argument("--only", default="")
    parser.add_argument("--folder", type=Path, default=ROOT.parent / "shared" / "meshes")
    parser.add_argument("--planish", type=Path, default=ROOT / "build" / "native" / "planish")
    parser.add_argument("--publish", action="store_true")
    words = sys.argv[1:]
    mark = words.index("--") if "--" in words else len(words)
    options = parser.parse_args(words[:mark])
    found = run(options, words[mark + 1:])
    converged = [row for row in found if row["status"] == "converged"]
    summary = {"options": " ".join(words[mark + 1:]), "edits": len(found), "converged": len(converged),
               "met": sum(row["met"] for row in converged),
               "not_met": [row for row in converged if not row["met"]]}
    text = json.dumps(summary, indent=1)
    if options.publish:
        (ROOT / "docs" / "benchmarks" / "optimality.json").write_text(text + "\n")
    print(text)


if __name__ == "__main__":
    main()
