#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the benchmarks and writes what is committed of them.

    cmake --preset native && ninja -C build/native planish_bench
    python3 .tools/measure/bench.py [--binary build/native/tests/bench/planish_bench] [--from RESULT.json]

Writes docs/benchmarks/<cpu>.json, docs/benchmarks.md and docs/benchmarks.svg. All times are
processor time of one thread, so that a busy machine does not count; ratios are within one run.
"""

import argparse
import json
import math
import os
import re
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
KEPT_CONTEXT = ("date", "num_cpus", "mhz_per_cpu", "library_build_type")
VERTICES = {32: "1 K", 100: "10 K", 316: "100 K", 1000: "1 M"}


def cpu_model():
    """The processor's name, without trade marks; 'unknown' where the system does not say."""
    try:
        text = Path("/proc/cpuinfo").read_text(encoding="utf-8")
    except OSError:
        text = ""
    match = re.search(r"^model name\s*:\s*(.+)$", text, re.M)
    name = match.group(1) if match else "unknown cpu"
    name = re.sub(r"\((R|TM)\)|@.*|\b(CPU|Processor)\b", " ", name, flags=re.I)
    return " ".join(name.split()) or "unknown cpu"


def run(binary, *options):
    environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1"}
    text = subprocess.run(
        [binary, "--benchmark_format=json", *options], check=True, capture_output=True, text=True, env=environment
    ).stdout
    return json.loads(text)


def compact(raw, machine):
    """What is worth keeping of Google Benchmark's output."""
    skipped = {
        "name", "family_index", "per_family_instance_index", "run_name", "run_type", "repetitions",
        "repetition_index", "threads", "iterations", "real_time", "cpu_time", "time_unit",
    }
    rows = {}
    for item in raw["benchmarks"]:
        name = re.sub(r"/(iterations:\d+|real_time)", "", item["name"])
        counters = {k: v for k, v in item.items() if k not in skipped}
        if "iterations" in item and item.get("time_unit") == "ms":
            rows[name] = {"ms": item["cpu_time"], **counters}
    context = {k: raw["context"][k] for k in KEPT_CONTEXT if k in raw["context"]}
    return {"machine": machine, "context": context, "results": rows}


def number(value):
    """Three significant digits, no exponent where it is readable."""
    if value is None:
        return "–"
    if value == 0:
        return "0"
    digits = max(0, 2 - math.floor(math.log10(abs(value))))
    return f"{value:.{digits}f}" if abs(value) < 1e4 else f"{value:,.0f}"


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + " --- |" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def engines(results):
    """Both engines on the same edits; empty where that was not run."""
    pairs = {}
    for name, row in results.items():
        if name.startswith("Engine/"):
            _, mesh, engine = name.split("/")
            pairs.setdefault(mesh, {})[engine] = row
    if not pairs:
        return []
    # Nothing to decide where a vertex is free to follow its handle alone.
    pairs = {mesh: pair for mesh, pair in pairs.items() if pair["alm"]["objective"] > 1e-6}
    share = {mesh: pair["newton"]["objective"] / pair["alm"]["objective"] - 1 for mesh, pair in pairs.items()}
    lower = sum(value < -1e-9 for value in share.values())
    above = [mesh for mesh, value in share.items() if value > 1e-3]
    return [
        "## Against the reference engine\n",
        "The middle vertex of five samples and of every real mesh (planarised first), lifted by half an "
        f"edge. Of {len(pairs)} edits the Newton engine ends lower on {lower}, and more than 0.1 % higher on "
        f"{len(above)}{': ' + ', '.join(above) if above else ''}.\n",
        table(
            ["mesh", "objective, newton", "alm", "difference", "moved, newton", "alm", "ms, newton", "alm"],
            [
                [mesh, f"{pair['newton']['objective']:.4f}", f"{pair['alm']['objective']:.4f}",
                 f"{100 * share[mesh]:+.2f} %", f"{pair['newton']['moved']:.0f}",
                 f"{pair['alm']['moved']:.0f}", number(pair["newton"]["ms"]), number(pair["alm"]["ms"])]
                for mesh, pair in pairs.items()
            ],
        ),
    ]


def kept(name):
    """What another script measured, from docs/benchmarks; None where it has not."""
    path = ROOT / "docs" / "benchmarks" / f"{name}.json"
    return json.loads(path.read_text(encoding="utf-8")) if path.exists() else None


def survey_part():
    """What .tools/measure/survey.py --publish left."""
    survey = kept("survey")
    if survey is None:
        return []
    share = lambda count, row: f"{100 * count / row['edits']:.0f} %"
    rows = []
    for row in survey["rows"]:
        a, b = row["a"], row["b"]
        ratio = row["objective_ratio"]
        rows.append([f"{row['lift']:g}", str(row["edits"]),
                     f"{share(a['spoil'], row)} ({share(b['spoil'], row)}, {share(b['seriously'], row)} seriously)",
                     f"{number(a['kink_median'])}° ({number(b['kink_median'])}°)",
                     share(row["handles_within_5_percent"], row),
                     f"{ratio['median']:.3f} / {ratio['p90']:.3f}",
                     f"{share(a['converged'], row)} ({share(b['converged'], row)})",
                     f"{a['infeasible']} ({b['infeasible']})"])
    times = survey["milliseconds"]
    points = ["p50", "p90", "p95", "p99", "p100"]
    return ["## Survey", f"{survey['edits']} edits on {survey['meshes']} meshes (samples, and real meshes made flat), "
            "default weights, measured by `.tools/measure/survey.py` with its own code; in brackets with `--bound shape=off`.",
            table(["move, mean edges", "edits", "spoil panels", "kink, median", "handle within 5 % of the move",
                   "objective against shape=off, median / p90", "certified", "infeasible"], rows),
            "Time of the solves, by percentile, in milliseconds of a wall clock:",
            table(["bound", *points], [["shape=on", *(number(times["a"][p]) for p in points)],
                                       ["shape=off", *(number(times["b"][p]) for p in points)]])]


def certificates_part():
    """What tests/reference/optimality.py --publish left."""
    check = kept("optimality")
    if check is None:
        return []
    missed = ", ".join(f"{r['mesh']} {r['vertex']} × {r['lift']:g}" for r in check["not_met"]) or "none"
    return ["## Certificates",
            f"`tests/reference/optimality.py` shares no code with the product and looks at the whole mesh. Of "
            f"{check['edits']} edits (lifts of 0.3, 0.8 and 1.5 mean edges) {check['converged']} are called converged; "
            f"stationarity and the bound outside hold to 1e-4 in {check['met']} of those. Not in: {missed}."]


def drags_part(results):
    """Every mesh of the survey that is flat or becomes so, and whose handle can move."""
    rows = {name.split("/")[1].removesuffix(".obj"): row for name, row in results.items()
            if name.startswith("DragSurvey/") and row["worst_mm_per_m"] <= 1e-6 and row["moved"] > 1}
    if not rows:
        return []
    spoilt = sum(row["spoilt"] for row in rows.values())
    return ["## Drags over the survey",
            "60 frames, the middle point lifted by a mean edge, default weights, no reach. Of the frames "
            f"{spoilt:.0f} have a spoilt panel; the worst panel of any frame is "
            f"{max(row['worst_mm_per_m'] for row in rows.values()):.0e} mm/m.",
            table(["mesh", "points moved", "frame, median ms", "p95 ms"],
                  [[name, f"{row['moved']:.0f}", number(row["median_ms"]), number(row["p95_ms"])]
                   for name, row in rows.items()])]


SOLVERS = {"planish": "block Cholesky", "simplicial": "Eigen SimplicialLLT",
           "cholmod_simplicial": "CHOLMOD simplicial", "cholmod_supernodal": "CHOLMOD supernodal"}


def cholesky(raw, machine):
    """Medians in ms of the benchmarks Cholesky/<sample>/<rings>/<solver>/<step>."""
    patches = {}
    for item in raw["benchmarks"]:
        if item.get("error_occurred"):
            raise SystemExit(f"{item['name']}: {item['error_message']}")
        if item.get("aggregate_name") != "median":
            continue
        _, sample, rings, solver, step = item["run_name"].split("/")
        patch = patches.setdefault(f"{sample}, {rings} rings", {"vertices": int(item["vertices"]), "ms": {}})
        patch["ms"].setdefault(solver, {})[step] = item["cpu_time"]
    return {"processor": machine, "date": raw["context"]["date"][:10], "patches": patches}


def cholesky_part():
    """What --cholesky left."""
    measured = kept("cholesky")
    if measured is None:
        return []
    others = [name for name in SOLVERS if name != "planish"]
    rows = []
    for name, patch in measured["patches"].items():
        ours = patch["ms"]["planish"]
        cells = [name, str(patch["vertices"])]
        for step in ("analyze", "factorize", "solve"):
            ratios = (f"{patch['ms'][o][step] / ours[step]:.1f}" if o in patch["ms"] else "–" for o in others)
            cells += [number(ours[step]), " / ".join(ratios)]
        rows.append(cells)
    return ["## Factoring a patch",
            f"The matrix of a Newton step on patches of {len(rows)} sizes, {measured['processor']}, {measured['date']}: "
            f"our block Cholesky, in ms, and how many times as long {', '.join(SOLVERS[o] for o in others)} take "
            "(with one thread of OpenBLAS). Factoring includes writing the values; every solver's backward error is "
            "checked. [Decision 19](decisions/0019-block-cholesky.md) says what follows.",
            table(["patch", "vertices", "analyse", "others", "factor", "others", "solve", "others"], rows)]


def threads_part(results):
    """The parallel steps of Sec. 3.5; the benchmark fails where the bits differ."""
    row = results.get("AlmOnThreads/100")
    if row is None:
        return []
    ratio = row["one_ms"] / row["two_ms"]
    return [f"ALM, 10 K points, one and two threads: the same {row['steps']:.0f} steps with their factors take "
            f"{number(row['one_ms'])} and {number(row['two_ms'])} ms of a wall clock, {ratio:.2f} × as fast, to the "
            "same bits. These two are the quickest of five runs each, in turn: here a busy machine does count.\n"]


def markdown(data):
    results = data["results"]

    def get(name, field="ms"):
        return results.get(name, {}).get(field)

    def projection(name, n, e):
        """A time, or how far it came; where only a finer goal was measured, that one's."""
        row = results.get(f"{name}/{n}/{e}")
        if row is None and e == 9:
            return "–"
        row = row or results.get(f"{name}/{n}/9")
        if row is None:
            return "–"
        return f"{row['ms']:,.0f} ms" if row["reached"] else f"not reached ({row['planarity']:.1e})"

    def ratio(a, b):
        return f"{a / b:.2f}" if a and b else "–"

    def objective(name):
        value = get(name, "objective")
        return "–" if value is None else f"{value:.2f}"

    parts = [
        "# Benchmarks\n",
        f"Measured on {data['machine']}, {data['context'].get('date', '')[:10]}, by `.tools/measure/bench.py`. "
        "Times are processor time of one thread; ratios are within this run. Every edit and every drag "
        "frame is exact (planarity below 1e-6 mm/m).\n",
        "## The public scenes\n",
        "1,024 vertices, one handle lifted by 1.5; see [math.md](math.md).\n",
        table(
            ["scene", "cold edit, ms", "objective", "vertices moved", "drag frame, median ms", "p95 ms",
             "worst panel of a drag, mm/m"],
            [
                [s, number(get(f"EditCold{s}")), objective(f"EditCold{s}"),
                 number(get(f"EditCold{s}", "moved")).split(".")[0], number(get(f"Drag{s}", "median_ms")),
                 number(get(f"Drag{s}", "p95_ms")), f"{get(f'Drag{s}', 'worst_mm_per_m') or 0:.1e}"]
                for s in ("Vault", "Dome")
            ],
        ),
        "## The same edit on larger meshes\n",
        "The vault continued periodically, so that the handle's surroundings are the same.\n",
        table(
            ["vertices", "cold edit, ms", "against 1 K", "drag frame, median ms", "p95 ms",
             "set-up once, ms", "objective"],
            [
                [VERTICES[n], number(get(f"EditCold/{n}")), ratio(get(f"EditCold/{n}"), get("EditCold/32")),
                 number(get(f"Drag/{n}", "median_ms")), number(get(f"Drag/{n}", "p95_ms")),
                 number(get(f"EditCold/{n}", "setup_ms")), objective(f"EditCold/{n}")]
                for n in VERTICES
            ],
        ),
        "## By size of the edit\n",
        "Dome with 10 K vertices, lift 1.5, smoothness weight raised.\n",
        table(
            ["smoothness", "vertices moved", "cold edit, ms"],
            [
                [f"{w / 100:g}", str(int(get(f"EditBySize/{w}", "moved") or 0)), number(get(f"EditBySize/{w}"))]
                for w in (1, 10, 100, 1000, 5000)
            ],
        ),
        "## The reference engine\n",
        "One step of alternating minimisation on the whole mesh against one factor solve.\n",
        table(
            ["vertices", "step, ms", "factor solve, ms", "ratio"],
            [
                [VERTICES[n], number(get(f"AlmStep/{n}")), number(get(f"FactorSolve/{n}")),
                 ratio(get(f"AlmStep/{n}"), get(f"FactorSolve/{n}"))]
                for n in (32, 100, 316)
            ],
        ),
        *threads_part(results),
        f"A whole edit of the vault (1 K) by this engine: {number(get('EditAlm/32'))} ms, "
        f"objective {objective('EditAlm/32')}.\n",
        *engines(results),
        "## Planarising a perturbed PQ grid\n",
        "Noise of 0.05 mean edges; in the last two rows a swell with a bump in every tile of 33 × 33 points and noise "
        "of 0.005, the state after many local edits (`tests/bench/projection_bench.cpp` has the formula). Time to a worst panel of 1e-4 (gap / longest edge; 0.1 mm/m) and on "
        "to 1e-9 (1e-6 mm/m). Baselines: local/global iteration with weak closeness, plain (the iterates "
        "of ShapeOp and igl::shapeup) and with Anderson acceleration, m = 5 (as AASolver), stopped after "
        "15 s. The baselines are our own versions of these methods: none of the three libraries is in Debian or npm.\n",
        table(
            ["solver", "1 K: 1e-4", "10 K: 1e-4", "100 K: 1e-4", "1 K: 1e-6", "1 K: 1e-9", "10 K: 1e-9", "100 K: 1e-9"],
            [
                [label] + [
                    projection(name, n, e)
                    for e, n in ((4, 32), (4, 100), (4, 316), (6, 32), (9, 32), (9, 100), (9, 316))
                ]
                for label, name in (
                    ("nearest flat mesh (α_f = 0)", "ProjectNearest"),
                    ("fair and sound (α_f = 10)", "ProjectFair"),
                    ("local/global, Anderson", "LocalGlobalAnderson"),
                    ("local/global, plain", "LocalGlobalPlain"),
                    ("bumps: nearest flat mesh", "BumpsNearest"),
                    ("bumps: local/global, Anderson", "BumpsAnderson"),
                )
            ],
        ),
        "## Subspace\n",
        table(
            ["six vectors at 1 K, ms", "slider tick at 100 K, ms"],
            [[number(get("SubspaceOfSix/32")), number(get("SliderTick/316"))]],
        ),
        "![Cost against mesh size and against edit size](benchmarks.svg)\n",
        *(part.rstrip("\n") + "\n" for part in cholesky_part() + survey_part() + drags_part(results) + certificates_part()),
    ]
    return "\n".join(parts)


# --- the plot ---------------------------------------------------------------------------------------

STYLE = """<style>
text{font:12px system-ui,sans-serif;fill:#333}.title{font-weight:600;font-size:13px}
.axis{stroke:#999;fill:none}.grid{stroke:#e5e5e5}
.a{stroke:#c2410c;fill:#c2410c}.b{stroke:#1d4ed8;fill:#1d4ed8}.c{stroke:#6b7280;fill:#6b7280}
polyline{fill:none!important;stroke-width:2}
</style>"""


class Panel:
    """One log-log plot in an SVG."""

    width, height = 300, 220

    def __init__(self, x, title, x_label, x_range, y_range):
        self.x, self.title, self.x_label = x, title, x_label
        self.x_range, self.y_range = x_range, y_range
        self.parts = []

    def place(self, x, y):
        def share(value, bounds):
            low, high = (math.log10(b) for b in bounds)
            return (math.log10(value) - low) / (high - low)

        return (
            self.x + self.width * share(x, self.x_range),
            40 + self.height * (1 - share(y, self.y_range)),
        )

    def series(self, style, label, points):
        places = [self.place(x, y) for x, y in points if y]
        if not places:
            return
        line = " ".join(f"{x:.1f},{y:.1f}" for x, y in places)
        self.parts.append(f'<polyline class="{style}" points="{line}"/>')
        self.parts += [f'<circle class="{style}" cx="{x:.1f}" cy="{y:.1f}" r="3"/>' for x, y in places]
        x, y = places[-1]
        self.parts.append(f'<text x="{x - 4:.1f}" y="{y - 8:.1f}" text-anchor="end">{label}</text>')

    def svg(self):
        bottom = 40 + self.height
        out = [f'<text class="title" x="{self.x}" y="24">{self.title}</text>']
        for power in range(round(math.log10(self.y_range[0])), round(math.log10(self.y_range[1])) + 1):
            y = self.place(self.x_range[0], 10.0**power)[1]
            out.append(f'<line class="grid" x1="{self.x}" x2="{self.x + self.width}" y1="{y:.1f}" y2="{y:.1f}"/>')
            out.append(f'<text x="{self.x - 6}" y="{y + 4:.1f}" text-anchor="end">{10.0**power:,.9g}</text>')
        for power in range(math.ceil(math.log10(self.x_range[0])), math.floor(math.log10(self.x_range[1])) + 1):
            x = self.place(10.0**power, self.y_range[0])[0]
            label = {3: "1 K", 4: "10 K", 5: "100 K", 6: "1 M"}.get(power, str(10**power))
            out.append(f'<text x="{x:.1f}" y="{bottom + 18}" text-anchor="middle">{label}</text>')
        out.append(f'<path class="axis" d="M{self.x} 40V{bottom}H{self.x + self.width}"/>')
        out.append(f'<text x="{self.x + self.width / 2}" y="{bottom + 36}" text-anchor="middle">{self.x_label}</text>')
        return "\n".join(out + self.parts)


def plot(data):
    results = data["results"]
    ms = lambda name: results.get(name, {}).get("ms")
    sizes = [(n, n * n) for n in VERTICES]
    mesh = Panel(80, "One edit, ms", "vertices of the mesh", (500, 2e6), (0.1, 1e6))
    mesh.series("a", "cold edit", [(v, ms(f"EditCold/{n}")) for n, v in sizes])
    mesh.series("b", "drag frame", [(v, results.get(f"Drag/{n}", {}).get("median_ms")) for n, v in sizes])
    mesh.series("c", "1,000 alternating steps",
                [(v, (ms(f"AlmStep/{n}") or 0) * 1000) for n, v in sizes[:3]])
    edit = Panel(460, "Cold edit, ms", "vertices moved", (8, 2000), (1, 1000))
    by_size = sorted(
        (row["moved"], row["ms"]) for name, row in results.items() if name.startswith("EditBySize/")
    )
    edit.series("a", "dome, 10 K vertices", by_size)
    return (
        '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 790 310" role="img" '
        'aria-label="Cost against mesh size and against edit size">\n'
        f'{STYLE}\n<rect width="790" height="310" fill="#fff"/>\n{mesh.svg()}\n{edit.svg()}\n</svg>\n'
    )


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--binary", default=str(ROOT / "build/native/tests/bench/planish_bench"))
    parser.add_argument("--from", dest="source", help="raw Google Benchmark JSON instead of a run")
    parser.add_argument("--kept", action="store_true", help="the figures that are committed, without a run")
    parser.add_argument("--cholesky", action="store_true", help="measures the factorizations alone")
    arguments = parser.parse_args()
    machine = cpu_model()
    folder = ROOT / "docs/benchmarks"
    slug = re.sub(r"[^a-z0-9]+", "-", machine.lower()).strip("-")
    if arguments.cholesky:
        raw = run(arguments.binary, "--benchmark_filter=Cholesky", "--benchmark_repetitions=9",
                  "--benchmark_min_time=0.03", "--benchmark_report_aggregates_only=true")
        text = json.dumps(cholesky(raw, machine), indent=1) + "\n"
        (folder / "cholesky.json").write_text(text, encoding="utf-8")
    if arguments.kept or arguments.cholesky:
        runs = [json.loads(path.read_text(encoding="utf-8")) for path in folder.glob("*.json")]
        data = max((r for r in runs if "machine" in r), key=lambda r: r["context"]["date"])
        (ROOT / "docs/benchmarks.md").write_text(markdown(data), encoding="utf-8")
        return
    if arguments.source:
        raw = json.loads(Path(arguments.source).read_text(encoding="utf-8"))
    else:
        raw = run(arguments.binary, "--benchmark_filter=-Cholesky")
    data = compact(raw, machine)
    folder.mkdir(parents=True, exist_ok=True)
    (folder / f"{slug}.json").write_text(json.dumps(data, indent=1) + "\n", encoding="utf-8")
    (ROOT / "docs/benchmarks.md").write_text(markdown(data), encoding="utf-8")
    (ROOT / "docs/benchmarks.svg").write_text(plot(data), encoding="utf-8")


if __name__ == "__main__":
    main()
