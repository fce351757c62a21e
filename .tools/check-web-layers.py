#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks the page's layers: imports only go down, in no circle, no module keeps state, one says what
went wrong.

Run from anywhere: python3 .tools/check-web-layers.py
One line per violation on standard output; exit code 1 if there is any.
"""

import re
import sys
from pathlib import Path

from circles import find_circles

SOURCE = Path(__file__).resolve().parent.parent / "web/src"

# A layer may import itself and those before it. `scene` and `export` know nothing of each other.
LAYERS = ["result", "quantity", "bytes", "mesh", "rhino", "solver", "design", "state", "scene", "export", "ui", "embed", "app"]
STRANGERS = {("export", "scene"), ("scene", "export")}
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
        text = path.read_text(encoding="utf-8")
        named = ["".join(found).split("?")[0] for found in IMPORT.findall(text)]
        targets = [(path.parent / name).resolve() for name in named if not name.endswith(".css")]
        name = path.relative_to(SOURCE).as_posix()
        graph[name] = [t.relative_to(SOURCE).as_posix() for t in targets if t.is_relative_to(SOURCE)]
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
            if not is_allowed(layer_of(name), layer_of(target)):
                yield f"web/src/{name}: {layer_of(name)} must not import {target}"


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
    violations = []
    for check in (check_layers, check_circles, check_telling, check_state):
        violations += check(graph)
    for violation in violations:
        print(violation)
    return 1 if violations else 0


if __name__ == "__main__":
    sys.exit(main())
