#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What stated limits cost an edit more than they must: SLSQP of scipy on the same problem, limits as they are stated.

    /usr/bin/python3 tests/reference/limits.py [--edits N]

(3) with the barrier on the corners, flat panels, and edges between a shortest and a longest, written anew (see bounded.py),
over the points that the product's edit moves; from the product's certified answer, off by a thousandth of an edge, several
times. Prints by how much of the objective the product stays above the lowest minimum that keeps all rows.
"""

import argparse
import json
import tempfile
from pathlib import Path

import numpy as np
from bounded import PLANISH, Patch
from optimality import survey
from scipy.optimize import minimize

SAMPLES = [("vault", 10), ("dome", 8), ("freeform", 10), ("hex", 6), ("trihex", 5)]
EDGES = (0.85, 1.15)  # of what the base has
ALLOWED = 2e-3  # of a squared length, by which one that is beyond the limit may grow
STARTS = 2


class LimitedPatch(Patch):
    """And squared lengths of edges within [least, most]."""

    def __init__(self, *args, least, most):
        super().__init__(*args)
        sides = {tuple(sorted((f[k - 1], f[k]))) for f in self.faces for k in range(len(f))}
        self.sides = np.array(sorted(s for s in sides if self.moves[list(s)].any()))
        now = np.sum((self.base[self.sides[:, 1]] - self.base[self.sides[:, 0]]) ** 2, axis=1)
        self.least = np.minimum(least ** 2, now * (1 - ALLOWED))
        self.most = np.maximum(most ** 2, now * (1 + ALLOWED))

    def room(self, x):
        p = self.base + self.displacement(x)
        square = np.sum((p[self.sides[:, 1]] - p[self.sides[:, 0]]) ** 2, axis=1)
        return np.concatenate([square - self.least, self.most - square])

    def room_jacobian(self, x):
        p = self.base + self.displacement(x)
        twice = 2 * (p[self.sides[:, 1]] - p[self.sides[:, 0]])
        rows = np.zeros((len(self.sides), *p.shape))
        index = np.arange(len(self.sides))
        rows[index, self.sides[:, 1]] = twice
        rows[index, self.sides[:, 0]] -= twice
        rows = rows[:, self.free].reshape(len(self.sides), -1)
        return np.concatenate([rows, -rows])

    def solve(self, start):
        rows = [{"type": "eq", "fun": self.flatness, "jac": self.flatness_jacobian},
                {"type": "ineq", "fun": self.room, "jac": self.room_jacobian}]
        return minimize(self.value, start, jac=self.gradient, constraints=rows, method="SLSQP",
                        options={"maxiter": 500, "ftol": 1e-13})


def edit(name, size, vertex, move, scratch):
    base_file, out, report = scratch / "base.obj", scratch / "out.obj", scratch / "report.json"
    survey.run(PLANISH, ["sample", name, "--size", size, "-o", base_file])
    base, faces = survey.read_obj(base_file)
    edge = survey.mean_edge(base, faces)
    lengths = [np.linalg.norm(base[f[k]] - base[f[k - 1]]) for f in faces for k in range(len(f))]
    least, most = EDGES[0] * min(lengths), EDGES[1] * max(lengths)
    if vertex is None:
        return base
    asked = ",".join(repr(float(x * edge)) for x in move)
    survey.run(PLANISH, ["edit", base_file, "--handle", f"{vertex}+={asked}", "--bound", f"edge={least!r}:{most!r}",
                         "-o", out, "--report", report])
    after, _ = survey.read_obj(out)
    status = json.loads(report.read_text())["status"]
    return base / edge, faces, after / edge, least / edge, most / edge, status


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--edits", type=int, default=20)
    options = parser.parse_args()
    random = np.random.default_rng(3)
    above, skipped, unheld = [], 0, 0
    with np.errstate(invalid="ignore"), tempfile.TemporaryDirectory() as folder:
        for number in range(options.edits):
            name, size = SAMPLES[number % len(SAMPLES)]
            count = len(edit(name, size, None, None, Path(folder)))
            vertex, move = int(random.integers(count)), random.normal(size=3)
            move *= random.uniform(0.5, 1.5) / np.linalg.norm(move)
            base, faces, after, least, most, status = edit(name, size, vertex, move, Path(folder))
            free = np.flatnonzero(np.any(base != after, axis=1))
            if status != "converged" or len(free) > 60:
                skipped += 1
                continue
            patch = LimitedPatch(base, faces, free, vertex, move, least=least, most=most)
            ours = (after - base)[free].ravel()
            unheld += patch.room(ours).min() > 1e-4
            value, best = patch.value(ours), np.inf
            for _ in range(STARTS):
                found = patch.solve(ours + 1e-3 * random.standard_normal(ours.size))
                if np.abs(patch.flatness(found.x)).max() < 1e-9 and patch.room(found.x).min() > -1e-9:
                    best = min(best, found.fun)
            if not np.isfinite(best):
                skipped += 1
                continue
            above.append((value - best) / best)
            print(f"{name} {size} {vertex}: {len(free)} points, ours {value:.8f}, SLSQP {best:.8f}, above {above[-1]:.1e}",
                  flush=True)
    above = np.array(above)
    print(f"{len(above)} edits compared, {skipped} left out, {unheld} that no limit holds; above the optimum: "
          f"median {np.median(above):.1e}, p95 {np.percentile(above, 95):.1e}, worst {above.max():.1e}")


if __name__ == "__main__":
    main()
