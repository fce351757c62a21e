#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Where the page's default colour is darkest after a first drag: the figures in docs/benchmarks.md.

    /usr/bin/python3 .tools/measure/motion.py [--points N] [--lift EDGES] [--reach RINGS] [--only NAME,...] [FOLDER]

N seeded inner points of each sample and of each mesh of ../shared/meshes (or FOLDER) that can be made flat
are pulled along their normals by so many mean edges (a quarter) with the page's first settings, whose reach grows
as far as it has to (--reach states one). Distances
from the old surface and ways along it are measured by this script's own code, from all panels as triangles,
and compared with the report's. Beside them stand the panels to make again and by how many degrees the
fold that sharpens most does.
"""

import argparse
import json
import re
import tempfile
from pathlib import Path

import numpy as np
from survey import ROOT, SAMPLES, Topology, area_vector, mean_edge, read_obj, run

PLANISH = ROOT / "build" / "native" / "planish"
PAGE = "--keep-boundary --attraction 10000 --softness 5".split()
LARGEST = 20  # panels a side
REACHES = json.loads(re.search(r"REACHES.*= (\[.*\]);", (ROOT / "web/src/solver/reach-steps.ts").read_text())[1])
MOST_SHARPER, MOST_SHORT = 10, 0.15  # what suffices() says there of a drag


def nearest_on_triangles(p, triangles):
    """The place of any of the triangles (m x 3 x 3) that is nearest to p."""
    a, b, c = triangles[:, 0], triangles[:, 1], triangles[:, 2]
    normals = np.cross(b - a, c - a)
    squares = np.einsum("ij,ij->i", normals, normals)
    flat = p - (np.einsum("ij,ij->i", p - a, normals) / np.maximum(squares, 1e-300))[:, None] * normals
    inside = squares > 0
    places = []
    for s, t in ((a, b), (b, c), (c, a)):
        edge = t - s
        inside &= np.einsum("ij,ij->i", np.cross(edge, flat - s), normals) >= 0
        share = np.einsum("ij,ij->i", p - s, edge) / np.maximum(np.einsum("ij,ij->i", edge, edge), 1e-300)
        places.append(s + np.clip(share, 0, 1)[:, None] * edge)
    candidates = np.concatenate([flat[inside], *places])
    return candidates[np.argmin(np.linalg.norm(candidates - p, axis=1))]


def inner_points(faces, topology, rings=2):
    """Used points that are so many rings of panels from the boundary."""
    near = {int(v) for v in topology.boundary}
    for _ in range(rings):
        near |= {v for face in faces if near & set(face) for v in face}
    return sorted({v for face in faces for v in face} - near)


def beside_one(faces, vertex):
    """The corners of the panels around it."""
    return {v for face in faces if vertex in face for v in face}


def pull(path, vertex, lift, reach, scratch):
    out, report = scratch / "after.obj", scratch / "report.json"
    before, faces = read_obj(path)
    normal = sum(area_vector(before[face]) for face in faces if vertex in face)
    move = lift * mean_edge(before, faces) * normal / np.linalg.norm(normal)
    by = ",".join(repr(float(x)) for x in move)
    run(PLANISH, ["edit", path, "--handle", f"{vertex}+={by}", *PAGE, "--reach", reach, "-o", out, "--report", report])
    after, _ = read_obj(out)
    triangles = np.array([before[[face[0], s, t]] for face in faces for s, t in zip(face[1:], face[2:])])
    moved = np.flatnonzero(np.any(before != after, axis=1))
    feet = np.array([nearest_on_triangles(after[v], triangles) for v in moved])
    shape = np.linalg.norm(after[moved] - feet, axis=1)
    normals = np.array([sum(area_vector(before[face]) for face in faces if v in face) for v in moved])
    slide = np.linalg.norm(np.cross(after[moved] - before[moved], normals), axis=1) / np.linalg.norm(normals, axis=1)
    total = np.linalg.norm(after[moved] - before[moved], axis=1)
    told = json.loads(report.read_text())
    said = told["motion"]
    slide_differs = abs(said["slide_max"] - slide.max()) / slide.max()
    return {"solved": told["status"] == "converged", "again": told["remake"]["outline"], "sharper": told["sharpest_fold"]["growth"],
            "short": told["handle_error"] / np.linalg.norm(move), "points": len(moved),
            "shape": shape.max(), "slide": slide.max(), "total": total.max(),
            "shape_there": moved[shape.argmax()] == vertex, "total_there": moved[total.argmax()] == vertex,
            "beside": int(moved[shape.argmax()]) in beside_one(faces, vertex),
            "at_handle": float(shape[moved == vertex].max(initial=0.0) / shape.max()),
            "differs": max(slide_differs, abs(said["shape_max"] - shape.max()) / shape.max())}


def grown(path, vertex, lift, reaches, scratch):
    """The pull with the smallest of `reaches` that suffices, else with the last."""
    for reach in reaches:
        row = pull(path, vertex, lift, reach, scratch)
        if row["solved"] and row["sharper"] <= MOST_SHARPER and row["short"] <= MOST_SHORT:
            break
    return row


def meshes_of(folder, scratch, only):
    for name, size in {"roof": 20, **SAMPLES}.items():
        if not only or name in only:
            path = scratch / f"{name}.obj"
            run(PLANISH, ["sample", name, "--size", min(size, LARGEST), "-o", path])
            yield name, path
    for given in sorted(folder.glob("*.obj")):
        if only and given.stem not in only:
            continue
        path = scratch / given.name
        run(PLANISH, ["project", given, "-o", path, "--report", scratch / "flat.json"])
        if json.loads((scratch / "flat.json").read_text())["planarity_mm_per_m"]["after_max"] <= 1e-6:
            yield given.stem, path


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("folder", nargs="?", type=Path, default=ROOT.parent / "shared" / "meshes")
    parser.add_argument("--points", type=int, default=5)
    parser.add_argument("--lift", type=float, default=0.25)
    parser.add_argument("--reach", type=int)
    parser.add_argument("--only", default="")
    options = parser.parse_args()
    reaches = [options.reach] if options.reach else REACHES
    only = set(filter(None, options.only.split(",")))
    print("| mesh | pulls | shape largest at the handle | or one panel beside | move largest at the handle "
          "| slide over shape, median | panels again, median | folds sharper by, median, worst | short, median |")
    print("|" + " --- |" * 9)
    everything, medians = [], []
    with tempfile.TemporaryDirectory() as name:
        scratch = Path(name)
        for k, (mesh, path) in enumerate(meshes_of(options.folder, scratch, only)):
            points, faces = read_obj(path)
            inner = inner_points(faces, Topology(faces))
            picked = np.random.default_rng(1000 + k).permutation(inner)[:options.points]
            rows = [grown(path, int(v), options.lift, reaches, scratch) for v in picked]
            everything += rows
            if rows:
                medians.append(np.median([r["again"] for r in rows]))
                there, beside, moved = (sum(r[key] for r in rows) for key in ("shape_there", "beside", "total_there"))
                print(f"| {mesh} | {len(rows)} | {there} | {beside} | {moved} "
                      f"| {np.median([r['slide'] / r['shape'] for r in rows]):.2g} "
                      f"| {np.median([r['again'] for r in rows]):.0f} | {np.median([r['sharper'] for r in rows]):.1f}°, "
                      f"{max(r['sharper'] for r in rows):.1f}° | {100 * np.median([r['short'] for r in rows]):.1f} % |",
                      flush=True)
    count = max(1, len(everything))
    shape, beside, total = (100 * sum(r[key] for r in everything) / count
                            for key in ("shape_there", "beside", "total_there"))
    print(f"\n{np.median(medians):.0f} panels again in the median of {len(medians)} meshes "
          f"({min(medians):.0f} to {max(medians):.0f}), {np.median([r['again'] for r in everything]):.0f} in that of all pulls")
    print(f"{len(everything)} pulls: shape largest at the handle {shape:.0f} %, "
          f"there or one panel beside {beside:.0f} %, move {total:.0f} %; report differs by at most "
          f"{100 * max(r['differs'] for r in everything):.2g} % of the largest shape or slide; least share of it "
          f"at the handle {min(r['at_handle'] for r in everything):.2f}")


if __name__ == "__main__":
    main()
