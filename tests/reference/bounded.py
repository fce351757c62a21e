#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Edits whose panels are at their bound, against a general solver: SLSQP of scipy on the same problem.

    /usr/bin/python3 tests/reference/bounded.py

(3) with the barrier on the corners, written anew, over the points that the product's edit moves; from the
product's answer with each coordinate off by a hundredth of an edge, several times. Prints both minima.
"""

import json
import sys
import tempfile
from pathlib import Path

import numpy as np
from optimality import ATTRACTION, BARRIER, CLAMP, KEEP, LOCALITY, SMOOTHNESS, barrier_gradient, fairness, survey
from scipy.optimize import minimize

PLANISH = survey.ROOT / "build" / "native" / "planish"
PATCHES = [("dome", 7, 24, 1.5), ("freeform", 7, 24, 2.0), ("hex", 4, None, 2.5), ("trihex", 4, None, 2.5)]
STARTS = 5


def shares(before, after, faces):
    """Of every corner with a size, [SHP-1]."""
    for face in faces:
        normal = survey.area_vector(before[face])
        normal = normal / np.linalg.norm(normal)
        for k in range(1 if len(face) == 3 else len(face)):
            a, b, c = face[k - 1], face[k], face[(k + 1) % len(face)]
            size = normal @ np.cross(before[b] - before[a], before[c] - before[b])
            into, out_of = np.linalg.norm(before[b] - before[a]), np.linalg.norm(before[c] - before[b])
            if abs(size) > 1e-3 * into * out_of:
                yield (normal @ np.cross(after[b] - after[a], after[c] - after[b]) / size - KEEP) / (1 - KEEP)


def barrier(before, after, faces):
    value = 0.0
    for share in shares(before, after, faces):
        if share <= 0:
            return np.inf
        if share < CLAMP:
            value -= BARRIER * (share - CLAMP) ** 2 * np.log(share / CLAMP)
    return value


class Patch:
    """The problem over `free` points, in mean edges."""

    def __init__(self, base, faces, free, handle, target):
        self.base, self.free, self.handle, self.target = base, free, handle, target
        self.fairness = fairness(faces, len(base))
        moves = np.zeros(len(base), bool)
        moves[free] = True
        self.faces = [face for face in faces if moves[face].any()]
        self.moves = moves

    def displacement(self, x):
        d = np.zeros_like(self.base)
        d[self.free] = x.reshape(-1, 3)
        return d

    def value(self, x):
        d = self.displacement(x)
        others = np.delete(d, self.handle, axis=0)
        return (0.5 * ATTRACTION * np.sum((d[self.handle] - self.target) ** 2)
                + 0.5 * LOCALITY * np.linalg.norm(others, axis=1).sum()
                + 0.5 * SMOOTHNESS * np.sum((self.fairness @ d) ** 2)
                + barrier(self.base, self.base + d, self.faces))

    def gradient(self, x):
        d = self.displacement(x)
        out = SMOOTHNESS * (self.fairness.T @ (self.fairness @ d))
        lengths = np.maximum(np.linalg.norm(d, axis=1), 1e-12)
        pull = 0.5 * LOCALITY * d / lengths[:, None]
        pull[self.handle] = ATTRACTION * (d[self.handle] - self.target)
        out += pull + barrier_gradient(self.base, self.base + d, self.faces, self.moves)
        return out[self.free].ravel()

    def flatness(self, x):
        p = self.base + self.displacement(x)
        return np.array([np.linalg.det([p[f[1]] - p[f[0]], p[f[2]] - p[f[0]], p[v] - p[f[0]]])
                         for f in self.faces for v in f[3:]])

    def flatness_jacobian(self, x):
        p = self.base + self.displacement(x)
        rows = []
        for f in self.faces:
            for v in f[3:]:
                row = np.zeros_like(p)
                b, c, d = p[f[1]] - p[f[0]], p[f[2]] - p[f[0]], p[v] - p[f[0]]
                row[f[1]], row[f[2]], row[v] = np.cross(c, d), np.cross(d, b), np.cross(b, c)
                row[f[0]] = -row[f[1]] - row[f[2]] - row[v]
                rows.append(row[self.free].ravel())
        return np.array(rows)

    def solve(self, start):
        rows = {"type": "eq", "fun": self.flatness, "jac": self.flatness_jacobian}
        return minimize(self.value, start, jac=self.gradient, constraints=rows, method="SLSQP",
                        options={"maxiter": 1000, "ftol": 1e-14})


def edit(name, size, handle, lift, scratch):
    """Base, faces, edited points, handle, target; in mean edges."""
    base_file, out, report = scratch / "base.obj", scratch / "out.obj", scratch / "report.json"
    survey.run(PLANISH, ["sample", name, "--size", size, "-o", base_file])
    base, faces = survey.read_obj(base_file)
    edge = survey.mean_edge(base, faces)
    if handle is None:
        handle = int(np.argmin(np.linalg.norm(base - base.mean(axis=0), axis=1)))
    survey.run(PLANISH, ["edit", base_file, "--handle", f"{handle}+=0,0,{lift * edge!r}", "-o", out, "--report", report])
    after, _ = survey.read_obj(out)
    status = json.loads(report.read_text())["status"]
    return base / edge, faces, after / edge, handle, np.array([0, 0, lift]), status


def main():
    random = np.random.default_rng(1)
    print("| patch | points moved | smallest share of a corner | ours | SLSQP | apart |\n|" + " --- |" * 6)
    # SLSQP also tries steps beyond the bound, where the barrier has no value.
    with np.errstate(invalid="ignore"), tempfile.TemporaryDirectory() as folder:
        for name, size, handle, lift in PATCHES:
            base, faces, after, handle, target, status = edit(name, size, handle, lift, Path(folder))
            free = np.flatnonzero(np.any(base != after, axis=1))
            patch = Patch(base, faces, free, handle, target)
            ours = (after - base)[free].ravel()
            best = np.inf
            for _ in range(STARTS):
                found = patch.solve(ours + 0.01 * random.standard_normal(ours.size))
                if np.abs(patch.flatness(found.x)).max() < 1e-9:
                    best = min(best, found.fun)
            least = min(shares(base, after, patch.faces))
            value = patch.value(ours)
            print(f"| {name} {size}, {lift} edges, {status} | {len(free)} | {least:.3f} | {value:.8f} | {best:.8f} "
                  f"| {(value - best) / best:.1e} |")


if __name__ == "__main__":
    main()
