#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Reference answers from an implementation that shares no code with the core.

Run with Debian's python3-numpy and python3-scipy:
    /usr/bin/python3 tests/reference/generate.py
Writes tests/reference/data/*.json. Everything is dense and written straight from the paper's
equations; positions are already in solver units (centred, mean edge 1), so nothing is rescaled.
"""

import json
from pathlib import Path

import numpy as np
from scipy.optimize import minimize

DATA = Path(__file__).resolve().parent / "data"


# --- meshes -----------------------------------------------------------------------------------


def quad_grid(n, height):
    points = np.array([[i, j, height(i / (n - 1), j / (n - 1))] for j in range(n) for i in range(n)], float)
    faces = [
        [j * n + i, j * n + i + 1, (j + 1) * n + i + 1, (j + 1) * n + i]
        for j in range(n - 1)
        for i in range(n - 1)
    ]
    return points, faces


def translational(n):
    """f(x) + g(y): all quads are parallelograms, hence flat."""
    return quad_grid(n, lambda u, v: (n - 1) * (0.12 * np.sin(np.pi * u) + 0.1 * np.sin(np.pi * v)))


def hexagon_patch():
    """Seven hexagons on a plane: one in the middle and a ring around it."""
    index, points, faces = {}, [], []
    directions = [np.array([np.cos(a), np.sin(a)]) for a in np.pi / 3 * np.arange(6) + np.pi / 6]
    centres = [np.zeros(2)] + [np.sqrt(3) * np.array([np.cos(a), np.sin(a)]) for a in np.pi / 3 * np.arange(6)]
    for centre in centres:
        face = []
        for direction in directions:
            corner = centre + direction
            key = tuple(np.round(corner, 6))
            if key not in index:
                index[key] = len(points)
                points.append([corner[0], corner[1], 0.0])
            face.append(index[key])
        faces.append(face)
    return np.array(points), faces


def edges(faces):
    return sorted({tuple(sorted((f[k], f[(k + 1) % len(f)]))) for f in faces for k in range(len(f))})


def normalised(points, faces):
    """Centred, mean edge 1."""
    points = points - points.mean(axis=0)
    lengths = [np.linalg.norm(points[a] - points[b]) for a, b in edges(faces)]
    return points / np.mean(lengths)


# --- the terms of (3) ---------------------------------------------------------------------------


def boundary_edges(faces):
    count = {}
    for f in faces:
        for k in range(len(f)):
            e = tuple(sorted((f[k], f[(k + 1) % len(f)])))
            count[e] = count.get(e, 0) + 1
    return [e for e, c in count.items() if c == 1]


def grid_second_differences(n):
    rows = []
    for j in range(n):
        for i in range(n):
            for step, at in ((1, i), (n, j)):
                if 0 < at < n - 1:
                    row = np.zeros(n * n)
                    v = j * n + i
                    row[[v - step, v, v + step]] = 1, -2, 1
                    rows.append(row)
    return np.array(rows)


def averaged_differences(vertex_count, faces):
    """For a mesh whose interior vertices all have odd valence: 2 (mean − vertex); along the boundary
    second differences."""
    near = {v: set() for v in range(vertex_count)}
    for a, b in edges(faces):
        near[a].add(b)
        near[b].add(a)
    rim = {}
    for a, b in boundary_edges(faces):
        rim.setdefault(a, []).append(b)
        rim.setdefault(b, []).append(a)
    rows = []
    for v in range(vertex_count):
        row = np.zeros(vertex_count)
        if v in rim:
            row[v] = -2
            row[rim[v]] = 1
        else:
            row[v] = -2
            row[list(near[v])] = 2 / len(near[v])
        rows.append(row)
    return np.array(rows)


def laplacian(vertex_count, faces):
    near = {v: set() for v in range(vertex_count)}
    for a, b in edges(faces):
        near[a].add(b)
        near[b].add(a)
    rim = {}
    for a, b in boundary_edges(faces):
        rim.setdefault(a, []).append(b)
        rim.setdefault(b, []).append(a)
    uses = {v: sum(v in f for f in faces) for v in range(vertex_count)}
    rows = []
    for v in range(vertex_count):
        around = rim.get(v, near[v])
        if v in rim and uses[v] == 1 and all(len(f) < 5 for f in faces if v in f):
            continue  # a corner
        row = np.zeros(vertex_count)
        row[v] = -1
        row[list(around)] += 1 / len(around)
        rows.append(row)
    return np.array(rows)


def flatness(points, faces):
    """Signed volumes of the first corner's tetrahedra: zero exactly where a face is flat."""
    values = []
    for f in faces:
        a, b, c = (points[v] for v in f[:3])
        values += [np.dot(np.cross(b - a, c - a), points[v] - a) for v in f[3:]]
    return np.array(values)


def flatness_jacobian(points, faces):
    rows = []
    for f in faces:
        for v in f[3:]:
            a, b, c, d = points[f[0]], points[f[1]], points[f[2]], points[v]
            row = np.zeros(points.shape)
            gb, gc, gd = np.cross(c - a, d - a), np.cross(d - a, b - a), np.cross(b - a, c - a)
            row[f[1]] += gb
            row[f[2]] += gc
            row[v] += gd
            row[f[0]] -= gb + gc + gd
            rows.append(row.ravel())
    return np.array(rows)


def objective(d, e, handles, weights, smoothing=0.0):
    w_h, w_s, w_f = weights
    value = 0.5 * w_f * np.sum((e @ d) ** 2)
    for v, target in handles.items():
        value += 0.5 * w_h * np.sum((d[v] - target) ** 2)
    free = [v for v in range(len(d)) if v not in handles]
    return value + 0.5 * w_s * np.sum(np.sqrt(np.sum(d[free] ** 2, axis=1) + smoothing**2))


def gradient(d, e, handles, weights, smoothing):
    w_h, w_s, w_f = weights
    out = w_f * e.T @ (e @ d)
    norms = np.sqrt(np.sum(d**2, axis=1) + smoothing**2)
    for v in range(len(d)):
        if v in handles:
            out[v] += w_h * (d[v] - handles[v])
        else:
            out[v] += 0.5 * w_s * d[v] / norms[v]
    return out


def solve_edit(points, faces, e, handles, weights):
    """(3) by scipy's SLSQP on a norm that is smoothed less and less, from several starts. The best
    of them; `objective` is that of (3) itself, of a point that is flat to the solver's tolerance."""
    n = len(points)
    best = None
    rng = np.random.default_rng(1)
    starts = [np.zeros((n, 3))] + [0.1 * rng.standard_normal((n, 3)) for _ in range(3)]
    for start in starts:
        d = start.copy()
        for smoothing in (0.1, 0.03, 0.01, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5):
            result = minimize(
                lambda x: objective(x.reshape(n, 3), e, handles, weights, smoothing),
                d.ravel(),
                jac=lambda x: gradient(x.reshape(n, 3), e, handles, weights, smoothing).ravel(),
                constraints={
                    "type": "eq",
                    "fun": lambda x: flatness(points + x.reshape(n, 3), faces),
                    "jac": lambda x: flatness_jacobian(points + x.reshape(n, 3), faces),
                },
                method="SLSQP",
                options={"maxiter": 400, "ftol": 1e-12},
            )
            d = result.x.reshape(n, 3)
        violation = np.max(np.abs(flatness(points + d, faces)))
        value = objective(d, e, handles, weights)
        if violation < 1e-7 and (best is None or value < best[0]):
            best = (value, d)
    return best


# --- plain ADMM of (11) to (17) -------------------------------------------------------------------


def admm_iterates(points, faces, e, handles, weights, penalty, inner, outer):
    """d after every update of d, with the multipliers updated after each `inner` of them."""
    n = len(points)
    w_h, w_s, w_f = weights
    blocks = []
    for f in faces:  # centred corners, see docs/decisions/0001
        block = np.zeros((len(f), n))
        for k, v in enumerate(f):
            block[k, v] += 1
            block[k, f] -= 1 / len(f)
        blocks.append(block)
    m = np.vstack(blocks)
    sizes = [len(f) for f in faces]
    system = np.linalg.inv(penalty * (np.eye(n) + m.T @ m) + w_f * e.T @ e)
    d = np.zeros((n, 3))
    y_multiplier, z_multiplier = np.zeros((n, 3)), np.zeros((len(m), 3))
    iterates = []
    for _ in range(outer):
        for _ in range(inner):
            a = d - y_multiplier / penalty
            y = np.zeros((n, 3))
            for v in range(n):
                if v in handles:
                    y[v] = (w_h * handles[v] + penalty * a[v]) / (w_h + penalty)  # (13)
                else:
                    length = np.linalg.norm(a[v])
                    if length > w_s / (2 * penalty):
                        y[v] = (1 - w_s / (2 * penalty * length)) * a[v]  # (14)
            c = m @ (points + d) - z_multiplier / penalty
            z = c.copy()
            row = 0
            for size in sizes:  # (16)
                normal = np.linalg.svd(c[row : row + size])[2][2]
                z[row : row + size] -= np.outer(c[row : row + size] @ normal, normal)
                row += size
            right = penalty * y + y_multiplier + m.T @ (penalty * (z - m @ points) + z_multiplier)
            d = system @ right  # (17)
            iterates.append(d.copy())
        y_multiplier = y_multiplier + penalty * (y - d)
        z_multiplier = z_multiplier + penalty * (z - m @ (points + d))
    return iterates


# --- the files ------------------------------------------------------------------------------------


def as_lists(array):
    return [[float(f"{x:.17g}") for x in row] for row in np.atleast_2d(array)]


def write(name, content):
    DATA.mkdir(exist_ok=True)
    (DATA / f"{name}.json").write_text(json.dumps(content, separators=(",", ":")) + "\n")


def scenes():
    hexagons = hexagon_patch()
    yield "grid5", *translational(5), grid_second_differences(5), {12: [0, 0, 0.4]}
    yield "grid6", *translational(6), grid_second_differences(6), {14: [0.1, -0.1, 0.5]}
    yield "grid7", *translational(7), grid_second_differences(7), {24: [0, 0, 0.5]}
    yield "hexagons", *hexagons, averaged_differences(len(hexagons[0]), hexagons[1]), {0: [0, 0, 0.3]}


def main():
    edits, iterates, operators = [], [], []
    weights = (1000.0, 1.0, 1.0)
    for name, points, faces, e, handles in scenes():
        points = normalised(points, faces)
        handles = {v: np.array(t, float) for v, t in handles.items()}
        mesh = {"name": name, "points": as_lists(points), "faces": faces}
        handle, target = next(iter(handles.items()))
        edit = {"handle": handle, "target": list(map(float, target))}
        value, d = solve_edit(points, faces, e, handles, weights)
        print(f"{name}: objective {value:.6f}")
        edits.append({**mesh, **edit, "objective": value, "displacement": as_lists(d)})
        steps = admm_iterates(points, faces, e, handles, weights, penalty=10.0, inner=5, outer=8)
        iterates.append({**mesh, **edit, "penalty": 10.0, "inner": 5, "displacements": [as_lists(s) for s in steps[::4]], "every": 4})
        operators.append({**mesh, "second": as_lists(e.T @ e), "laplacian": as_lists((lambda l: l.T @ l)(laplacian(len(points), faces)))})
    write("edits", edits)
    write("admm", iterates)
    write("operators", operators)

    rng = np.random.default_rng(7)
    polygons, corrections = [], []
    for size in (4, 5, 6, 8, 12):
        for spread in (1e-9, 1e-3, 0.3):
            angle = 2 * np.pi * np.arange(size) / size
            polygon = np.c_[np.cos(angle), np.sin(angle), spread * rng.standard_normal(size)]
            polygon = polygon @ np.linalg.qr(rng.standard_normal((3, 3)))[0].T + rng.standard_normal(3)
            centred = polygon - polygon.mean(axis=0)
            normal = np.linalg.svd(centred)[2][2]
            heights = centred @ normal
            longest = max(np.linalg.norm(polygon[k] - polygon[k - 1]) for k in range(size))
            polygons.append({
                "points": as_lists(polygon),
                "projected": as_lists(centred - np.outer(heights, normal)),
                "mm_per_m": 1000 * (heights.max() - heights.min()) / longest,
            })
    write("polygons", polygons)

    # Nearest flat mesh: min ‖t‖² s.t. flat, by SLSQP to its limit.
    for n in (4, 5):
        points, faces = translational(n)
        points = normalised(points + 0.05 * rng.standard_normal(points.shape), faces)
        result = minimize(
            lambda x: 0.5 * x @ x,
            np.zeros(points.size),
            jac=lambda x: x,
            constraints={
                "type": "eq",
                "fun": lambda x: flatness(points + x.reshape(points.shape), faces),
                "jac": lambda x: flatness_jacobian(points + x.reshape(points.shape), faces),
            },
            method="SLSQP",
            options={"maxiter": 500, "ftol": 1e-15},
        )
        corrections.append({
            "points": as_lists(points), "faces": faces,
            "distance": float(np.linalg.norm(result.x)),
            "displacement": as_lists(result.x.reshape(points.shape)),
        })
        print(f"projection {n}: distance {np.linalg.norm(result.x):.6f}")
    write("nearest", corrections)


if __name__ == "__main__":
    main()
