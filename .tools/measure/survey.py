#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The survey: edits on samples and real meshes, measured by this script's own code.

    /usr/bin/python3 .tools/measure/survey.py [--a OPTIONS] [--b OPTIONS] [--points N] [--lifts 0.5,1,2]
                                      [--only NAME,...] [--folder DIR] [--processes N] [--publish]

Samples of about 400 points and every mesh of ../shared/meshes (or DIR), made flat first; N seeded points
a mesh, each moved along its normal and sideways by so many mean edges, once with the options A (default:
none) and once with B (default: --bound shape=off). Counts panels that became concave, crossing, turned
over or collapsed, and how much the sharpest fold grew; --publish writes docs/benchmarks/survey.json.
"""

import argparse
import json
import math
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
SAMPLES = {"vault": 20, "dome": 20, "freeform": 20, "hex": 14, "trihex": 12}
DAMAGES = ("crossing", "turned over", "collapsed", "concave")
STRAIGHT = 1e-9  # radians
WAS_STRAIGHT, MAY_TURN = 1e-3, math.radians(1)  # a corner that was straight may turn by a degree
THIN = 1e-3  # of the longest edge


def read_obj(path):
    points, faces = [], []
    for line in Path(path).read_text().splitlines():
        words = line.split()
        if words[:1] == ["v"]:
            points.append([float(w) for w in words[1:4]])
        elif words[:1] == ["f"]:
            faces.append([int(w.split("/")[0]) - 1 for w in words[1:]])
    return np.array(points), faces


def area_vector(corners):
    arms = corners - corners[0]
    return np.cross(arms, np.roll(arms, -1, axis=0)).sum(axis=0)


def mean_edge(points, faces):
    """Every edge counts once."""
    edges = {(min(f[k], f[k - 1]), max(f[k], f[k - 1])) for f in faces for k in range(len(f))}
    ends = np.array(sorted(edges))
    return float(np.linalg.norm(points[ends[:, 0]] - points[ends[:, 1]], axis=1).mean())


def outline(corners):
    normal = area_vector(corners)
    if np.linalg.norm(normal) == 0:
        normal = np.array([0.0, 0.0, 1.0])
    normal = normal / np.linalg.norm(normal)
    u = np.cross(normal, np.eye(3)[np.argmin(np.abs(normal))])
    u /= np.linalg.norm(u)
    return np.stack([(corners - corners[0]) @ u, (corners - corners[0]) @ np.cross(normal, u)], axis=1)


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def crosses(flat):
    n = len(flat)
    for i in range(n):
        a, b = flat[i], flat[(i + 1) % n]
        for j in range(i + 2, n):
            p, q = flat[j], flat[(j + 1) % n]
            if cross(b - a, p - a) * cross(b - a, q - a) < 0 and cross(q - p, a - p) * cross(q - p, b - p) < 0:
                return True
    return False


def turns_of(flat):
    """Of the corners, positive the way that the outline turns; and whether it goes round once."""
    edges = np.roll(flat, -1, axis=0) - flat
    turns = [math.atan2(cross(e, f), e @ f) for e, f in zip(np.roll(edges, 1, axis=0), edges)]
    way = -1.0 if sum(turns) < 0 else 1.0
    return [way * t for t in turns], abs(abs(sum(turns)) - 2 * math.pi) < 0.1


def is_convex(flat, base=None):
    """With a base: except for corners that were straight there and turned by no more than a degree."""
    turns, once = turns_of(flat)
    was = turns_of(base)[0] if base is not None else [1.0] * len(turns)
    return once and all(t > (-MAY_TURN if abs(w) <= WAS_STRAIGHT else -STRAIGHT) for t, w in zip(turns, was))


def is_collapsed(corners):
    edges = np.linalg.norm(np.roll(corners, -1, axis=0) - corners, axis=1)
    longest = edges.max()
    width = 0.5 * np.linalg.norm(area_vector(corners)) / longest if longest > 0 else 0
    return not (edges.min() > THIN * longest and width > THIN * longest)


def damage(before, after):
    """The worst that became of a panel, or None."""
    was, now = outline(before), outline(after)
    convex = is_convex(was)
    now_convex = is_convex(now, was) if convex else is_convex(now)
    was_crossing = not convex and crosses(was)
    if not now_convex and crosses(now):
        return None if was_crossing else "crossing"
    if not was_crossing and area_vector(before) @ area_vector(after) < 0:
        return "turned over"
    if is_collapsed(after) and not is_collapsed(before):
        return "collapsed"
    return "concave" if convex and not now_convex else None


class Topology:
    def __init__(self, faces):
        self.faces = faces
        sides = {}
        for f, face in enumerate(faces):
            for k, v in enumerate(face):
                w = face[(k + 1) % len(face)]
                sides.setdefault((min(v, w), max(v, w)), []).append((f, v < w))
        self.inner = [(a, b) for a, b in (s for s in sides.values() if len(s) == 2)]
        self.outer = [edge for edge, s in sides.items() if len(s) == 1]
        self.boundary = sorted({v for edge in self.outer for v in edge})

    def folds(self, points):
        """Degrees between the normals of neighbouring panels, both of which have one."""
        normals = np.array([area_vector(points[face]) for face in self.faces])
        lengths = np.linalg.norm(normals, axis=1)
        normals /= np.maximum(lengths, 1e-300)[:, None]
        cosines = [(-1.0 if way_f == way_g else 1.0) * normals[f] @ normals[g]
                   for (f, way_f), (g, way_g) in self.inner if lengths[f] > 0 and lengths[g] > 0]
        return np.degrees(np.arccos(np.clip(cosines, -1.0, 1.0)))

    def sharpest_fold(self, points):
        return float(self.folds(points).max(initial=0.0))


def run(planish, arguments):
    done = subprocess.run([str(planish), *map(str, arguments)], capture_output=True, text=True)
    if done.returncode not in (0, 4):
        sys.exit(f"survey: planish {' '.join(map(str, arguments))}: {done.stderr.strip()}")


def prepare(planish, folder, scratch, only):
    meshes = {}
    for name, size in SAMPLES.items():
        meshes[name] = scratch / f"{name}.obj"
        run(planish, ["sample", name, "--size", size, "-o", meshes[name]])
    for path in sorted(folder.glob("*.obj")) if folder.is_dir() else []:
        flat = scratch / path.name
        run(planish, ["project", path, "-o", flat, "--report", scratch / "project.json"])
        if json.loads((scratch / "project.json").read_text())["planarity_mm_per_m"]["after_max"] <= 1e-6:
            meshes[path.stem] = flat
        else:
            print(f"survey: {path.name} cannot be made flat: left out", file=sys.stderr)
    return {name: path for name, path in meshes.items() if not only or name in only}


def edits(meshes, count, lifts):
    jobs = []
    for index, (name, path) in enumerate(meshes.items()):
        points, faces = read_obj(path)
        random = np.random.default_rng(1000 + index)
        used = sorted({v for face in faces for v in face})
        edge = mean_edge(points, faces)
        for v in random.choice(used, size=min(count, len(used)), replace=False):
            around = [area_vector(points[f]) for f in faces if v in f]
            normal = np.sum(around, axis=0)
            normal /= max(np.linalg.norm(normal), 1e-300)
            side = np.cross(normal, random.normal(size=3))
            side /= max(np.linalg.norm(side), 1e-300)
            for lift in lifts:
                for way, direction in (("normal", normal), ("sideways", side)):
                    jobs.append({"mesh": name, "vertex": int(v), "lift": lift, "way": way,
                                 "move": (lift * edge * direction).tolist(), "edge": edge})
    return jobs


def measure(planish, path, job, options, scratch, topologies):
    stem = f"{job['mesh']}-{job['vertex']}-{job['lift']}-{job['way']}-{abs(hash(tuple(options))) % 9973}"
    out, report = scratch / f"{stem}.obj", scratch / f"{stem}.json"
    move = ",".join(repr(x) for x in job["move"])
    run(planish, ["edit", path, "--handle", f"{job['vertex']}+={move}", *options, "-o", out, "--report", report])
    before, faces = read_obj(path)
    after, _ = read_obj(out)
    moved = np.any(before != after, axis=1)
    spoilt = [damage(before[f], after[f]) for f in faces if moved[f].any()]
    topology = topologies.setdefault(job["mesh"], Topology(faces))
    result = json.loads(report.read_text())
    out.unlink()
    report.unlink()
    target = before[job["vertex"]] + np.array(job["move"])
    return {"status": result["status"], "objective": result["objective"]["total"], "moved": int(moved.sum()),
            "spoilt": {d: spoilt.count(d) for d in DAMAGES if d in spoilt},
            "kink": topology.sharpest_fold(after) - topology.sharpest_fold(before),
            "short": float(np.linalg.norm(after[job["vertex"]] - target) / np.linalg.norm(job["move"])),
            "boundary_moved": int(moved[topology.boundary].sum()),
            "optimality": result.get("optimality"), "milliseconds": 1e3 * result["seconds"]["solve"]}


def percentile(values, share):
    return float(np.percentile(values, share)) if len(values) else float("nan")


def summarise(results, lifts):
    rows = []
    for lift in lifts:
        pairs = [(r["a"], r["b"]) for r in results if r["job"]["lift"] == lift]
        row = {"lift": lift, "edits": len(pairs)}
        for side, index in (("a", 0), ("b", 1)):
            runs = [p[index] for p in pairs]
            row[side] = {"spoil": sum(bool(r["spoilt"]) for r in runs),
                         "seriously": sum(any(d != "concave" for d in r["spoilt"]) for r in runs),
                         "kink_median": percentile([r["kink"] for r in runs], 50),
                         "converged": sum(r["status"] == "converged" for r in runs),
                         "infeasible": sum(r["status"] == "infeasible_handles" for r in runs),
                         "boundary_moved": sum(r["boundary_moved"] > 0 for r in runs)}
        row["handles_within_5_percent"] = sum(a["short"] <= b["short"] + 0.05 for a, b in pairs)
        ratios = [a["objective"] / b["objective"] for a, b in pairs if b["objective"] > 0]
        row["objective_ratio"] = {"median": percentile(ratios, 50), "p90": percentile(ratios, 90)}
        rows.append(row)
    times = {side: {f"p{p}": percentile([r[side]["milliseconds"] for r in results], p) for p in (50, 90, 95, 99, 100)}
             for side in ("a", "b")}
    return {"edits": len(results), "rows": rows, "milliseconds": times}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--a", default="")
    parser.add_argument("--b", default="--bound shape=off")
    parser.add_argument("--points", type=int, default=2)
    parser.add_argument("--lifts", default="0.5,1,2")
    parser.add_argument("--only", default="")
    parser.add_argument("--folder", type=Path, default=ROOT.parent / "shared" / "meshes")
    parser.add_argument("--planish", type=Path, default=ROOT / "build" / "native" / "planish")
    parser.add_argument("--processes", type=int, default=1)
    parser.add_argument("--all", type=Path, help="every edit's figures as JSON")
    parser.add_argument("--publish", action="store_true")
    options = parser.parse_args()
    lifts = [float(x) for x in options.lifts.split(",")]
    with tempfile.TemporaryDirectory() as folder:
        scratch = Path(folder)
        meshes = prepare(options.planish, options.folder, scratch, set(filter(None, options.only.split(","))))
        jobs = edits(meshes, options.points, lifts)
        topologies = {}

        def both(job):
            path = meshes[job["mesh"]]
            return {"job": job, **{side: measure(options.planish, path, job, text.split(), scratch, topologies)
                                   for side, text in (("a", options.a), ("b", options.b))}}

        with ThreadPoolExecutor(options.processes) as pool:
            results = list(pool.map(both, jobs))
    summary = {"a": options.a, "b": options.b, "meshes": len(meshes), "points_a_mesh": options.points,
               **summarise(results, lifts)}
    text = json.dumps(summary, indent=1)
    if options.all:
        options.all.write_text(json.dumps(results))
    if options.publish:
        (ROOT / "docs" / "benchmarks" / "survey.json").write_text(text + "\n")
    print(text)


if __name__ == "__main__":
    main()
