#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Offsets of the samples and the shared meshes, as the table of docs/offsets.md.

Run after `npm run build`, from anywhere: python3 .tools/measure/offsets.py
Every mesh is made flat (or circular, or conical) by `planish project` first; the distance is a
tenth of its mean edge. Lengths in the table are shares of the distance.
"""

import json
import subprocess
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PLANISH = ROOT / "build/native/planish"
SHARED = ROOT / "../shared/meshes"

# Mesh, what it is made first, kind asked for.
CASES = [
    ("sample:dome:32", None, None),
    ("sample:dome:32", None, "vertex"),
    ("sample:hex:32", None, None),
    ("sample:hex:300", None, None),
    ("sample:vault:32", None, None),
    ("sample:vault:32", "circular", None),
    ("sample:vault:300", None, None),
    ("sample:trihex:32", None, None),
    ("pq_conical_saddle", "flat", None),
    ("pq_conical_saddle", "conical", None),
    ("pq_conical_saddle", "circular", None),
    ("hex_enneper_concave", "flat", None),
    ("hex_sphere_two_openings", "flat", None),
    ("polyhedron_truncated_cuboct", "flat", None),
    ("kagome_from_tri_mesh", "flat", None),
    ("mixed345_airport", "flat", None),
    ("pq_botanic_bubble", "flat", None),
    ("pq_octtorus", "flat", None),
    ("pq_six_planarized", "flat", None),
    ("pq_static_roof", "flat", None),
    ("quad_eight_genus2", "flat", None),
]


def planish(*words):
    """The report, and the exit code."""
    with tempfile.NamedTemporaryFile(suffix=".json") as report:
        done = subprocess.run([PLANISH, *words, "--report", report.name], capture_output=True)
        text = Path(report.name).read_text(encoding="utf-8")
        return (json.loads(text) if text else {}), done.returncode


def spread(values, distance):
    return " … ".join(f"{values[key] / distance:.3f}" for key in ("min", "mean", "max"))


def row(name, first, asked, folder):
    mesh = name if name.startswith("sample:") else str(SHARED / f"{name}.obj")
    if first:
        made = str(Path(folder) / "made.obj")
        constraint = [] if first == "flat" else ["--constraint", first]
        planish("project", mesh, *constraint, "-o", made)
        mesh = made
    distance = 0.1 * planish("info", mesh)[0]["mesh"]["mean_edge"]
    kind = ["--kind", asked] if asked else []
    out = str(Path(folder) / "offset.obj")
    report, code = planish("offset", mesh, "--distance", repr(distance), *kind, "-o", out)
    deviation = report["deviation"]
    cells = [
        name.removeprefix("sample:").replace(":", " "),
        first or "",
        report["kind"],
        "" if deviation is None else f"{deviation / distance:.0e}",
        f"{report['edge_residual']:.0e}",
        f"{report['planarity_mm_per_m']['after_max']:.0e}",
        spread(report["panels"], distance),
        spread(report["heights"], distance),
        f"{report['largest_lean']:.1f}",
        str(code),
    ]
    return "| " + " | ".join(cells) + " |"


def main():
    print("| mesh | made first | kind | deviation | edges | flat, mm/m | panels | heights | lean, ° | exit |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |")
    with tempfile.TemporaryDirectory() as folder:
        for name, first, asked in CASES:
            if name.startswith("sample:") or (SHARED / f"{name}.obj").exists():
                print(row(name, first, asked, folder), flush=True)


if __name__ == "__main__":
    main()
