#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What answers cost: factorizations, certificates and objectives of the survey's edits, mode by mode.

    /usr/bin/python3 .tools/measure/counts.py [--planish FILE] [--modes page,fold,edge,weights] [--keep RUN.json]
                                      [--against RUN.json] [--only NAME,...] [--meshes DIR] [--processes N]

The meshes of survey.py with larger quad samples, four seeded points each and a few known to be hard, moved
by half an edge and by one along the normal. --keep stores a run; --against compares with one that was stored: an objective
counts as lower or higher from 0.1 % on. "short" are the edits without a certificate whose handle stops more than 5 % of its
way short; every edit without a certificate is listed, with what the report says is at its bound. --meshes names the folder
that the flat meshes are kept in, so that two binaries edit the same ones. Exits with 1 where a panel is newly spoilt, the
boundary moves that is kept, a point leaves its outline or enters its box, or a result is not flat.
"""

import argparse
import json
import sys
import tempfile
import zlib
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import survey

FREE = "--reach 6 --softness 5"
PAGE = f"{FREE} --keep-boundary"
MODES = {"weights": "", "page": PAGE, "fold": f"{PAGE} --bound fold=+8", "edge": f"{PAGE} --bound edge={{low}}:{{high}}",
         "area": f"{PAGE} --bound area={{area}}", "angle": f"{PAGE} --bound angle=60:120", "hard": f"{PAGE} --hard",
         "box": f"{PAGE} --keep-out box={{box}} --clearance {{clearance}}", "outline": f"{FREE} --support outline:boundary",
         "wide": "--reach 12 --softness 8", "weighted": "--reach 6"}
COUNTED = ("weights", "page", "fold", "edge")
SAMPLES = {"vault": 32, "dome": 32, "freeform": 32, "hex": 14, "trihex": 12}
HARD = {"pq_gitter": (765,), "vault": (653,), "hex_sphere_two_openings": (5,), "freeform": (222,), "pq_octtorus": (159,)}
LIFTS = (0.5, 1.0)
SAME = 1e-3  # of the objective
FLAT = 1e-6  # mm/m
SHORT = 0.05  # of its way
CLEARANCE, OFF = 0.05, 1e-9  # mean edges


def flat_meshes(planish, folder, scratch, only):
    """Made once where `scratch` is kept."""
    listed = scratch / "meshes.json"
    if not listed.exists():
        survey.SAMPLES = SAMPLES
        meshes = survey.prepare(planish, folder, scratch, set())
        listed.write_text(json.dumps({name: path.name for name, path in meshes.items()}))
    meshes = {name: scratch / path for name, path in json.loads(listed.read_text()).items()}
    return meshes, [name for name in meshes if not only or name in only]


def jobs_of(meshes, points):
    jobs = [job for job in survey.edits(meshes, points, LIFTS) if job["way"] == "normal"]
    for name, vertices in HARD.items():
        points, faces = survey.read_obj(meshes[name])
        edge = survey.mean_edge(points, faces)
        for v in vertices:
            normal = np.sum([survey.area_vector(points[f]) for f in faces if v in f], axis=0)
            normal *= edge / np.linalg.norm(normal)
            jobs += [{"mesh": name, "vertex": v, "lift": lift, "move": (lift * normal).tolist(), "edge": edge}
                     for lift in LIFTS]
    return jobs


def box_ahead(job, start):
    """As those of tests/support/obstacles.cpp: sides of 0.2 to 1 mean edge, a little ahead of the target."""
    random = np.random.default_rng(zlib.crc32(f"{job['mesh']} {job['vertex']} {job['lift']}".encode()))
    half = 0.5 * job["edge"] * random.uniform(0.2, 1.0, size=3)
    move = np.array(job["move"])
    middle = start + move * (1 + 0.6 * np.linalg.norm(half) / np.linalg.norm(move))
    return [*(middle - half), *(middle + half)]


def written(numbers):
    return ",".join(repr(float(x)) for x in numbers)


def words(job, start):
    """What the options of a mode may name."""
    edge = job["edge"]
    return {"low": 0.8 * edge, "high": 1.2 * edge, "area": 1.2 * edge * edge, "clearance": CLEARANCE * edge,
            "box": written(box_ahead(job, start))}


def off_lines(points, starts, ends):
    """How far each point is from the nearest of the lines."""
    along = ends - starts
    share = np.einsum("plc,lc->pl", points[:, None] - starts, along) / np.einsum("lc,lc->l", along, along)
    feet = starts + np.clip(share, 0, 1)[..., None] * along
    return np.linalg.norm(points[:, None] - feet, axis=2).min(axis=1)


def outside(options, box, topology, before, after, edge):
    """Points that went where the options let none go."""
    count = 0
    if "box=" in options:
        low, high = np.array(box[:3]), np.array(box[3:])
        inside = [np.all((low < p) & (p < high), axis=1) for p in (before, after)]
        count += int((inside[1] & ~inside[0]).sum())
    if "outline:boundary" in options and topology.boundary:
        sides = np.array(topology.outer)
        off = off_lines(after[topology.boundary], before[sides[:, 0]], before[sides[:, 1]])
        count += int((off > OFF * edge).sum())
    return count


def edit(planish, meshes, job, options, scratch, topologies):
    path = meshes[job["mesh"]]
    before, faces = survey.read_obj(path)
    options = options.format(**words(job, before[job["vertex"]]))
    stem = f"{job['mesh']}-{job['vertex']}-{job['lift']}-{abs(hash(options)) % 9973}"
    out, report = scratch / f"{stem}.out.obj", scratch / f"{stem}.json"
    survey.run(planish, ["edit", path, "--handle", f"{job['vertex']}+={written(job['move'])}", *options.split(),
                         "-o", out, "--report", report])
    after, _ = survey.read_obj(out)
    result = json.loads(report.read_text())
    out.unlink()
    report.unlink()
    moved = np.any(before != after, axis=1)
    topology = topologies.setdefault(job["mesh"], survey.Topology(faces))
    kept = [v for v in topology.boundary if v != job["vertex"]] if "--keep-boundary" in options else []
    target = before[job["vertex"]] + np.array(job["move"])
    return {"mesh": job["mesh"], "vertex": job["vertex"], "lift": job["lift"], "status": result["status"],
            "factorizations": result["factorizations"], "objective": result["objective"]["total"],
            "spoilt": sum(survey.damage(before[f], after[f]) is not None for f in faces if moved[f].any()),
            "boundary": int(moved[kept].sum()),
            "outside": outside(options, box_ahead(job, before[job["vertex"]]), topology, before, after, job["edge"]),
            "bound": {b["name"]: len(b["binding"]) for b in result.get("bounds", []) if b["binding"]},
            "planarity": result["planarity_mm_per_m"]["after_max"], "seconds": result["seconds"]["solve"],
            "short": float(np.linalg.norm(after[job["vertex"]] - target) / np.linalg.norm(job["move"]))}


def certified(row):
    return row["status"] == "converged"


def key(row):
    return f"{row['mesh']} {row['vertex']} {row['lift']}"


def summarise(rows, stored):
    counts = [row["factorizations"] for row in rows]
    summary = {"edits": len(rows), "sum": sum(counts),
               **{f"p{p}": round(survey.percentile(counts, p), 1) for p in (50, 90, 95, 100)},
               "converged": round(100 * np.mean([certified(row) for row in rows]), 1),
               "short": sum(row["short"] > SHORT and not certified(row) for row in rows),
               "spoilt": sum(row["spoilt"] for row in rows), "boundary": sum(row["boundary"] for row in rows),
               "outside": sum(row["outside"] for row in rows),
               "not flat": sum(row["planarity"] > FLAT for row in rows),
               "seconds": round(sum(row["seconds"] for row in rows), 2)}
    pairs = [(row["objective"], stored[key(row)]["objective"]) for row in rows if key(row) in stored]
    if pairs:
        higher = [now > (1 + SAME) * then for now, then in pairs]
        lower = [now < (1 - SAME) * then for now, then in pairs]
        summary["lower/same/higher"] = f"{sum(lower)}/{len(pairs) - sum(lower) - sum(higher)}/{sum(higher)}"
    return summary


def tell(mode, rows, stored, listed):
    print(mode, json.dumps(summarise(rows, stored)), flush=True)
    worst = sorted(rows, key=lambda row: -row["factorizations"])[:listed]
    other = [row for row in rows if row not in worst and listed > 0 and key(row) in stored
             and abs(row["objective"] / max(stored[key(row)]["objective"], 1e-300) - 1) > SAME]
    open_ones = [row for row in rows if not certified(row) and row not in worst + other]
    for row in worst + other + open_ones:
        then = stored.get(key(row))
        was = f"   was {then['factorizations']:5d} {then['objective']:.6g} {then['status']}" if then else ""
        left = "" if certified(row) else f", {row['short']:.3f} short, at its bound {row['bound'] or 'nothing'}"
        print(f"  {key(row):44s} {row['factorizations']:5d} {row['objective']:.6g} {row['status']}{left}{was}")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--planish", type=Path, default=survey.ROOT / "build" / "native" / "planish")
    parser.add_argument("--folder", type=Path, default=survey.ROOT.parent / "shared" / "meshes")
    parser.add_argument("--meshes", type=Path)
    parser.add_argument("--modes", default=",".join(COUNTED))
    parser.add_argument("--points", type=int, default=4, help="seeded, a mesh")
    parser.add_argument("--only", default="")
    parser.add_argument("--keep", type=Path)
    parser.add_argument("--against", type=Path)
    parser.add_argument("--listed", type=int, default=0, help="list so many of the dearest edits, and what differs")
    parser.add_argument("--processes", type=int, default=1)
    options = parser.parse_args()
    stored = json.loads(options.against.read_text()) if options.against else {}
    runs = {}
    with tempfile.TemporaryDirectory() as folder:
        scratch = Path(folder)
        if options.meshes:
            options.meshes.mkdir(parents=True, exist_ok=True)
        only = set(filter(None, options.only.split(",")))
        meshes, chosen = flat_meshes(options.planish, options.folder, options.meshes or scratch, only)
        jobs = [job for job in jobs_of(meshes, options.points) if job["mesh"] in chosen]
        topologies = {}
        for mode in options.modes.split(","):
            with ThreadPoolExecutor(options.processes) as pool:
                rows = list(pool.map(lambda job, text=MODES[mode]: edit(options.planish, meshes, job, text, scratch,
                                                                        topologies), jobs))
            runs[mode] = {key(row): row for row in rows}
            tell(mode, rows, stored.get(mode, {}), options.listed)
    if options.keep:
        options.keep.write_text(json.dumps(runs))
    if any(row["spoilt"] or row["boundary"] or row["outside"] or row["planarity"] > FLAT
           for run in runs.values() for row in run.values()):
        sys.exit(1)


if __name__ == "__main__":
    main()
