#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks the page's layers: imports only go down, in no circle, no feature imports another, no flat
folder gets long, no module keeps state, one says what went wrong.

Run from anywhere: python3 .tools/ci/check-web-layers.py
One line per violation on standard output; exit code 1 if there is any.
"""

import re
import sys
from pathlib import Path

from circles import find_circles

SOURCE = Path(__file__).resolve().parents[2] / "web/src"

# A layer may import itself and those before it. `scene` and `export` know nothing of each other.
LAYERS = ["result", "quantity", "bytes", "mesh", "rhino", "solver", "design", "state", "scene", "export", "ui", "features", "embed", "app"]
STRANGERS = {("export", "scene"), ("scene", "export")}

# A feature is a folder of `features`: no layer below knows any. This lists them, and it alone has them register.
FEATURE_TABLE = "features/all-features.ts"
# A feature that offers another where it is of use.
OFFERS = {
    ("advanced", "constraints"),
    ("constraints", "stopping"),
    ("context", "keep-outs"),
    ("import-report", "planarising"),
    ("second-layer", "shop"),
}
MOST_FILES = 60
# A page of its own, which takes its look from this one.
APART = {"catalogue": {"ui"}}

# The entries of pages and workers put things together: what they keep lives as long as they do.
COMPOSITION_ROOTS = {"app/main.tsx", "catalogue/main.tsx", "solver/worker.ts", "solver/mobility-worker.ts"}

IMPORT = re.compile(
    r'(?:^|\n)(?:import|export)\b[^;"]*?from "(\.[^"]+)"|import\("(\.[^"]+)"\)|\nimport "(\.[^"]+)"'
)
STATE = re.compile(
    r"(?:export )?(?:let\b|const \w+[^=\n]*= *(?:signal|computed|effect)\b|const \w+[^=\n]*= *new (?:Map|WeakMap)\b)"
)


def imports():
    """By file, the files of the page that it imports, types and later parts too."""
    graph = {}
    for path in sorted(SOURCE.rglob("*.ts*")):
        name = path.relative_to(SOURCE).as_posix()
        graph[name] = []
        for at_once, fetched, bare in IMPORT.findall(path.read_text(encoding="utf-8")):
            target = (path.parent / (at_once or fetched or bare).split("?")[0]).resolve()
            if target.suffix == ".css" or not target.is_relative_to(SOURCE):
                continue
            graph[name].append(target.relative_to(SOURCE).as_posix())
    return graph


def layer_of(name):
    return name.split("/")[0]


def is_allowed(layer, below):
    if layer == below:
        return True
    if layer in APART:
        return below in APART[layer]
    if layer not in LAYERS or below not in LAYERS or (layer, below) in STRANGERS:
        return False
    return LAYERS.index(below) < LAYERS.index(layer)


def check_layers(graph):
    for name, targets in graph.items():
        if "/" in name and layer_of(name) not in LAYERS + list(APART):
            yield f"web/src/{name}: {layer_of(name)} is no layer of {Path(__file__).name}"
        for target in targets:
            if not may_use(name, target):
                yield f"web/src/{name}: {feature_of(name) or layer_of(name)} must not import {target}"


def feature_of(name):
    """The folder of features that a file is in; None for what is no feature, as their table."""
    layer, *path = name.split("/")
    return path[0] if layer == "features" and len(path) > 1 else None


def may_use(name, target):
    if not is_allowed(layer_of(name), layer_of(target)):
        return False
    if target.endswith("/register.ts"):
        return name == FEATURE_TABLE
    feature, other = feature_of(name), feature_of(target)
    return None in (feature, other) or feature == other or (feature, other) in OFFERS


def check_lists(graph):
    """What is listed above and no longer there; features that nothing registers."""
    offered = {(feature_of(name), feature_of(target)) for name, targets in graph.items() for target in targets}
    for one, other in sorted(OFFERS - offered):
        yield f"web/src/features/{one}: offers nothing of {other}"
    for name in sorted(graph):
        if name.endswith("/register.ts") and name not in graph[FEATURE_TABLE]:
            yield f"web/src/{name}: not in {FEATURE_TABLE}"


def check_folders():
    for folder in sorted(path for path in SOURCE.rglob("*") if path.is_dir()):
        files = sum(path.is_file() for path in folder.iterdir())
        if files > MOST_FILES:
            yield f"web/src/{folder.relative_to(SOURCE).as_posix()}: {files} files, {MOST_FILES} at most"


def check_circles(graph):
    for circle in find_circles(graph):
        yield f"web/src/{circle[-2]}: import circle {' -> '.join(circle)}"


def check_telling(graph):
    """What went wrong is reported in one place; operations return it."""
    for name in sorted(set(graph) - {"state/telling.ts"}):
        text = (SOURCE / name).read_text(encoding="utf-8")
        for number, line in enumerate(text.splitlines(), 1):
            if re.search(r"\bproblem\.value\s*=[^=]", line):
                yield f"web/src/{name}:{number}: only state/telling.ts writes page.problem: {line.strip()}"


def check_state(graph):
    for name in sorted(set(graph) - COMPOSITION_ROOTS):
        text = (SOURCE / name).read_text(encoding="utf-8")
        for number, line in enumerate(text.splitlines(), 1):
            if STATE.match(line):
                yield f"web/src/{name}:{number}: state of a module: {line.strip()}"


def main():
    graph = imports()
    violations = [*check_folders()]
    for check in (check_layers, check_lists, check_circles, check_telling, check_state):
        violations += check(graph)
    for violation in violations:
        print(violation)
    return 1 if violations else 0


if __name__ == "__main__":
    sys.exit(main())
