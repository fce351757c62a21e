#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What every feature of an edit costs: factorizations and certificates, feature by feature, with the page's settings.

    /usr/bin/python3 .tools/measure/features.py [--planish FILE] [--meshes DIR] [--folder DIR] [--processes N] [--points N]
                                                [--only "FEATURE;..."] [--keep RUN.json]

N seeded points a mesh of each feature, pulled by half an edge and by one in turn, mostly along the normal (on a surface
across it, with symmetry along it alone). Flat meshes as counts.py makes them; circular, conical and bent ones are made
beside them. Lists every edit without a certificate and every one above the target; "short" as in counts.py. Exits with 1
where a panel is newly spoilt or a result is not flat.
"""

import argparse
import json
import sys
import tempfile
import zlib
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import counts
import numpy as np
import survey
from counts import FREE, PAGE, written

COMMON = ("vault", "freeform", "trihex", "hex_dual_tridome", "pq_gitter", "pq_octtorus", "pq_static_roof",
          "hex_sphere_two_openings")
SYMMETRIC = ("vault", "dome", "pq_octtorus", "hex_dual_tridome", "hex_sphere_two_openings", "quad_chebyshev_sphere",
             "quad_polycastle_voxel", "pq_enneper_quads")
KINDS = ("dome", "vault", "pq_octtorus", "pq_vase_small", "pq_conical_saddle", "pq_six_planarized")
BENT = ("pq_static_roof", "pq_botanic_bubble", "pq_wein99_diag", "quad_chebyshev_sphere", "pq_octtorus")
BOX_PANELS = ((1, 3, 4, 2), (5, 6, 8, 7), (1, 2, 6, 5), (3, 7, 8, 4), (1, 5, 7, 3), (2, 4, 8, 6))
WORST = 600  # factorizations that an edit is listed from

# Options, with what `words` and counts.words name; meshes where they are not the common ones.
FEATURES = {
    "page": PAGE, "default weights, reach": "--reach 6", "reach 4 edges": "--reach {reach} --softness 5 --keep-boundary",
    "softness 1": "--reach 6 --softness 1", "softness 10": "--reach 10 --softness 10",
    "shape off": f"{PAGE} --bound shape=off", "fairness third": f"{PAGE} --fairness third",
    "fairness laplacian": f"{PAGE} --fairness laplacian", "sparsity l2": f"{PAGE} --sparsity l2",
    "hard": f"{PAGE} --hard", "three handles": f"{PAGE} {{handles}}", "pins": f"{PAGE} --pin {{two}}",
    "continuation": f"{PAGE} --continuation 4",
    "limit fold": f"{PAGE} --bound fold=+5", "limit angle": f"{PAGE} --bound angle=60:120",
    "limit edge": f"{PAGE} --bound edge={{low}}:{{high}}", "limit area": f"{PAGE} --bound area={{area}}",
    "limit sheet": f"{PAGE} --bound sheet={{sheet}}x{{sheet}}", "limit slide": f"{PAGE} --bound slide={{slide}}",
    "limits": f"{PAGE} --bound fold=+8 --bound edge={{low}}:{{high}} --bound angle=60:120",
    "bends kept": (f"{PAGE} --bound flat=60", BENT, "bent"),
    "support level": f"{PAGE} --support level:{{two}}",
    "support plane": f"{PAGE} --support plane={{plane}}:{{near}} --support plane={{plane_b}}:{{near_b}}",
    "support line": f"{PAGE} --support line={{line}}:{{near}} --support line={{line_b}}:{{near_b}}",
    "support outline": f"{FREE} --support outline:boundary", "support polyline": f"{PAGE} --support polyline:{{path}}",
    "support surface": (f"{FREE} --support surface:all", COMMON, ""),
    "support surface of a file": (f"{PAGE} --support surface={{file}}:all", COMMON, ""),
    "support spring": f"{PAGE} --support spring=10:{{two}}",
    "keep-out level": f"{PAGE} --keep-out {{level}}", "keep-out plane ahead": f"{PAGE} --keep-out plane={{ahead}}",
    "keep-out plane through the handle": f"{PAGE} --keep-out plane={{through}}",
    "keep-out plane behind": f"{PAGE} --keep-out plane={{behind}}",
    "keep-out box": f"{PAGE} --keep-out box={{box}} --clearance {{clearance}}",
    "keep-out mesh": f"{PAGE} --keep-out mesh={{wall}} --clearance {{clearance}}",
    "keep-out self": f"{PAGE} --keep-out self --clearance {{clearance}}",
    "symmetry": (f"{PAGE} --symmetry auto", SYMMETRIC, ""),
    "circular": (f"{PAGE} --constraint circular", KINDS, "circular"),
    "conical": (f"{PAGE} --constraint conical", KINDS, "conical"),
    "outline, fold": f"{FREE} --support outline:boundary --bound fold=+8",
    "outline, box": f"{FREE} --support outline:boundary --keep-out box={{box}} --clearance {{clearance}}",
    "plane ahead, fold": f"{PAGE} --keep-out plane={{ahead}} --bound fold=+8",
    "box, edge": f"{PAGE} --keep-out box={{box}} --clearance {{clearance}} --bound edge={{low}}:{{high}}",
    "level, slide": f"{PAGE} --support level:{{two}} --bound slide={{slide}}",
    "hard, fold": f"{PAGE} --hard --bound fold=+8",
    "symmetry, plane ahead": (f"{PAGE} --symmetry auto --keep-out plane={{ahead}}", SYMMETRIC, ""),
    "symmetry, outline, edge": (f"{FREE} --symmetry auto --support outline:boundary --bound edge={{low}}:{{high}}",
                                SYMMETRIC, ""),
    "circular, fold": (f"{PAGE} --constraint circular --bound fold=+8", KINDS, "circular"),
    "conical, outline": (f"{FREE} --constraint conical --support outline:boundary", KINDS, "conical"),
}


class Surroundings:
    """What lies around a handle, chosen by a seed of its own."""

    def __init__(self, points, faces, vertex, seed):
        self.points, self.random = points, np.random.default_rng(seed)
        self.neighbours = {}
        for face in faces:
            for k, v in enumerate(face):
                self.neighbours.setdefault(v, set()).add(face[k - 1])
                self.neighbours.setdefault(face[k - 1], set()).add(v)
        rings = [{vertex}]
        for _ in range(3):
            rings.append({w for v in rings[-1] for w in self.neighbours[v]} - set().union(*rings))
        self.near = self.random.permutation(sorted(rings[2] | rings[3]))

    def path(self, count=5):
        """Along edges, each time the one that goes on most nearly straight."""
        path = [int(self.near[0])]
        way = self.random.normal(size=3)
        while len(path) < count:
            ahead = [w for w in self.neighbours[path[-1]] if w not in path]
            if not ahead:
                break
            ways = {w: self.points[w] - self.points[path[-1]] for w in ahead}
            path.append(max(ahead, key=lambda w: ways[w] @ way / np.linalg.norm(ways[w])))
            way = ways[path[-1]]
        return ",".join(map(str, path))

    def line(self, v):
        return written([*self.points[v], *self.random.normal(size=3)])

    def plane(self, v):
        normal = self.random.normal(size=3)
        return written([*normal, normal @ self.points[v]])


def plane_at(start, move, share, random):
    """Across the way, tilted, at a share of it; what is beyond is kept out."""
    normal = move / np.linalg.norm(move) + 0.6 * random.uniform(-0.5, 0.5, size=3)
    return written([*normal, normal @ (start + share * move)])


def wall(job, start, scratch):
    """The box of counts.py as a model of six panels."""
    box = counts.box_ahead(job, start)
    path = scratch / f"wall-{job['mesh']}-{job['vertex']}-{job['lift']}.obj"
    if not path.exists():
        corners = [[box[c + (3 if k >> c & 1 else 0)] for c in range(3)] for k in range(8)]
        lines = ["v " + " ".join(repr(float(x)) for x in corner) for corner in corners]
        path.write_text("\n".join(lines + ["f " + " ".join(map(str, panel)) for panel in BOX_PANELS]) + "\n")
    return path


def words(job, points, faces, path, scratch):
    """What the options of a feature may name beside counts.words."""
    start, move, edge = points[job["vertex"]], np.array(job["move"]), job["edge"]
    seed = zlib.crc32(f"{job['mesh']} {job['vertex']}".encode())
    around = Surroundings(points, faces, job["vertex"], seed)
    a, b = (int(v) for v in around.near[:2])
    other = [written(around.random.uniform(0.3, 1.0) * move) for _ in range(2)]
    level = start[2] + 0.5 * move[2]
    return {**counts.words(job, start), "file": path, "reach": f"{4 * edge!r}m", "two": f"{a},{b}", "near": a, "near_b": b,
            "handles": f"--handle {a}+={other[0]} --handle {b}+={other[1]}", "path": around.path(),
            "plane": around.plane(a), "plane_b": around.plane(b), "line": around.line(a), "line_b": around.line(b),
            "sheet": 1.3 * edge, "slide": 0.2 * edge, "wall": wall(job, start, scratch),
            "level": f"above={level!r}" if move[2] > 0 else f"below={level!r}",
            "ahead": plane_at(start, move, 0.5, around.random), "through": plane_at(start, move, 0.0, around.random),
            "behind": plane_at(start, move, -0.3, around.random)}


def prepare(planish, folder, meshes, kind, name, scratch):
    """The mesh that a feature begins with, or None where there is none."""
    if kind == "bent":
        return folder / f"{name}.obj"
    if not kind:
        return meshes[name]
    made = scratch / f"{kind}-{name}.obj"
    if not made.exists():
        survey.run(planish, ["project", meshes[name], "--constraint", kind, "-o", made])
    return made


def pulls(name, path, count, feature):
    """Half an edge and one in turn; a point of a mirror plane stays in it."""
    aside = 0.0 if "symmetry" in feature else 0.4
    points, faces = survey.read_obj(path)
    random = np.random.default_rng(zlib.crc32(name.encode()))
    edge = survey.mean_edge(points, faces)
    used = sorted({v for face in faces for v in face})
    for k, v in enumerate(random.choice(used, size=count, replace=False)):
        normal = np.sum([survey.area_vector(points[f]) for f in faces if v in f], axis=0)
        normal /= np.linalg.norm(normal)
        side = np.cross(normal, random.normal(size=3))
        way = side if "surface" in feature else normal + aside * side
        lift = counts.LIFTS[k % len(counts.LIFTS)]
        yield {"vertex": int(v), "lift": lift, "move": (lift * edge * way / np.linalg.norm(way)).tolist(), "edge": edge}


def edits(options, meshes, feature, scratch):
    template, names, kind = (FEATURES[feature], COMMON, "") if isinstance(FEATURES[feature], str) else FEATURES[feature]
    for name in names:
        path = prepare(options.planish, options.folder, meshes, kind, name, scratch)
        points, faces = survey.read_obj(path)
        for job in pulls(name, path, options.points, feature):
            job["mesh"] = f"{kind} {name}".strip().replace(" ", "-")
            yield path, job, template.format(**words(job, points, faces, path, scratch))


def listed(row, kind):
    return not counts.certified(row) or row["factorizations"] > WORST or row["spoilt"] or is_bent(row, kind)


def is_bent(row, kind):
    return kind != "bends kept" and row["planarity"] > counts.FLAT


def tell(feature, rows):
    costs = [row["factorizations"] for row in rows]
    made = sum(counts.certified(row) for row in rows)
    short = sum(row["short"] > counts.SHORT and not counts.certified(row) for row in rows)
    p50, p90 = (survey.percentile(costs, p) for p in (50, 90))
    print(f"{feature:34s} {len(rows):4d} edits {made:4d} certified {p50:6.0f} / {p90:5.0f} / {max(costs):5d}  {short} short",
          flush=True)


def name_the_rest(feature, rows):
    for row in rows:
        if listed(row, feature):
            print(f"    {counts.key(row):40s} {row['factorizations']:5d} {row['objective']:.6g} {row['status']}, "
                  f"{row['short']:.3f} short, at its bound {row['bound'] or 'nothing'}, spoilt {row['spoilt']}, "
                  f"{row['planarity']:.1e} mm/m")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--planish", type=Path, default=survey.ROOT / "build" / "native" / "planish")
    parser.add_argument("--folder", type=Path, default=survey.ROOT.parent / "shared" / "meshes")
    parser.add_argument("--meshes", type=Path)
    parser.add_argument("--points", type=int, default=2, help="seeded, a mesh")
    parser.add_argument("--only", default="")
    parser.add_argument("--keep", type=Path)
    parser.add_argument("--processes", type=int, default=1)
    options = parser.parse_args()
    runs = {}
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(options.processes) as pool:
        scratch = Path(folder)
        if options.meshes:
            options.meshes.mkdir(parents=True, exist_ok=True)
        meshes, _ = counts.flat_meshes(options.planish, options.folder, options.meshes or scratch, ())
        for feature in filter(None, options.only.split(";")) if options.only else FEATURES:
            todo = list(edits(options, meshes, feature, scratch))
            topologies = {}
            runs[feature] = list(pool.map(lambda one: counts.edit(options.planish, {one[1]["mesh"]: one[0]}, one[1], one[2],
                                                                  scratch, topologies), todo))
            tell(feature, runs[feature])
            name_the_rest(feature, runs[feature])
    tell("all", [row for rows in runs.values() for row in rows])
    if options.keep:
        options.keep.write_text(json.dumps(runs))
    if any(row["spoilt"] and feature != "shape off" or is_bent(row, feature) for feature, rows in runs.items() for row in rows):
        sys.exit(1)


if __name__ == "__main__":
    main()
