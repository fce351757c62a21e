#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks what the compiler cannot: the direction of includes, and the equation ledger.

Run from anywhere: python3 .tools/check-architecture.py
One line per violation on standard output; exit code 1 if there is any.
"""

import re
import sys
from pathlib import Path

from circles import find_circles

ROOT = Path(__file__).resolve().parent.parent

# Which groups a group may include. Everything may include itself; transitive arrows are spelled
# out, so that a new edge is always a decision.
BASE = {"mesh", "report"}
GEOMETRY = BASE | {"adjacency", "constraints", "energies", "metrics"}
PROBLEM = GEOMETRY | {"problem", "point_support"}
ENGINES = PROBLEM | {"engines"}
ARROWS = {
    "mesh": set(),
    "report": set(),  # solve_report.hpp, engine.hpp: what every problem shares
    "trigonometry": set(),
    "symmetry": {"mesh", "adjacency", "trigonometry", "read_result"},
    "topology": {"mesh"},  # edge_table, disjoint_sets: what mesh_check needs
    "read_result": {"mesh"},  # io's result type and its sentences: mesh_check speaks the same
    "adjacency": {"mesh"},
    "keep_out": {"mesh", "read_result"},  # where nothing may go, as text and as half-spaces and boxes
    "constraints": {"mesh", "adjacency", "trigonometry", "keep_out"},
    "energies": {"mesh", "adjacency"},
    "metrics": {"mesh", "constraints", "trigonometry"},
    "stated_limit": {"mesh", "adjacency", "constraints", "read_result"},  # the limits as text
    "point_support": {"mesh", "adjacency", "read_result", "keep_out", "constraints", "topology"},
    "edit_freedom": {"mesh", "adjacency", "constraints"},
    "mesh_standing": BASE | {"adjacency", "constraints"},
    "folds": {"mesh", "adjacency", "metrics", "trigonometry"},
    "mesh_check": {"mesh", "topology", "read_result"},
    "checksum": {"mesh"},  # crc32, mesh_hash
    "plane_meeting": set(),
    "fabrication": GEOMETRY | {"plane_meeting", "topology", "trigonometry", "checksum", "io", "read_result"},
    "io": {"mesh", "mesh_check", "topology", "read_result", "checksum"},
    "shapes": {"mesh", "trigonometry"},
    "problem": GEOMETRY | {"point_support"},
    "engines": PROBLEM,
    "handle_edit": ENGINES | {"mesh_standing", "symmetry", "keep_out", "read_result"},
    "symmetric_edit": ENGINES | {"handle_edit", "planarising", "symmetry", "projection", "read_result"},
    "subspace": ENGINES | {"handle_edit", "symmetry"},
    "projection": ENGINES | {"mesh_standing"},
    "exact_variation": ENGINES | {"folds", "handle_edit", "mesh_standing", "projection", "symmetry"},
    "slider_stops": GEOMETRY | {"subspace"},
    "planarising": {"constraints", "mesh", "report", "adjacency", "projection"},
    "offset": ENGINES | {"plane_meeting", "topology", "trigonometry", "read_result"},
    "mobility": ENGINES | {"handle_edit", "stated_limit", "folds", "fabrication"},
    "design": ENGINES | {"symmetry", "symmetric_edit", "checksum", "handle_edit", "subspace", "projection", "exact_variation", "planarising", "shapes", "io", "read_result"},
    "design_text": ENGINES | {"symmetry", "handle_edit", "subspace", "projection", "planarising", "design", "io", "read_result"},
    "sweep": ENGINES | {"symmetry", "handle_edit", "subspace", "projection", "planarising", "design", "design_text", "io", "read_result"},
    "comparison": ENGINES | {"handle_edit", "subspace", "projection"},  # native only
    "cli": None,  # everything
    "library": None,
    "wasm": None,
    "python": None,
}

# Files whose group is not their directory or stem.
FILE_GROUPS = {
    "index": "mesh",
    "refusal": "mesh",
    "logarithm": "trigonometry",
    "stopwatch": "report",
    "solve_report": "report",
    "engine": "report",
    "edge_table": "topology",
    "disjoint_sets": "topology",
    "base_violations": "handle_edit",
    "edit_verdict": "handle_edit",
    "handle_edit_state": "handle_edit",
    "handle_edit_search": "handle_edit",
    "handle_edit_parts": "handle_edit",
    "handle_edit_drag": "handle_edit",
    "handle_edit_symmetric": "handle_edit",
    "symmetric_shape": "symmetry",
    "handle_edit_keep_outs": "handle_edit",
    "problem_keep_outs": "problem",
    "allowed_motions": "subspace",
    "shape_slides": "problem",  # its supports, seen from another shape
    "kept_by_variations": "handle_edit",
    "symmetry_text": "symmetry",
    "area_vector": "mesh",
    "panel_boxes": "mesh",
    "mesh_repair": "mesh_check",
    "separate_faces": "mesh",
    "triangle_pairs": "topology",
    "context_mesh": "keep_out",  # a model beside the mesh, as text
    "sound_projection": "projection",
    "nearly_flat": "projection",
    "projector": "projection",
    "panel_health": "metrics",
    "point_support_text": "point_support",
    "vertex_slides": "point_support",
    "resting_points": "point_support",
    "guide_lines": "point_support",
    "surface_feet": "point_support",
    "surface_heights": "point_support",
    "reference_surface": "point_support",
    "surface_sites": "point_support",
    "crc32": "checksum",
    "mesh_hash": "checksum",
    "handle_edit_rules": "handle_edit",
    "edit_constraints": "handle_edit",
    "edit_terms": "handle_edit",
    "edit_reach": "handle_edit",
    "softness": "handle_edit",
    "planarising_rules": "planarising",
    "subspace_rules": "subspace",
    "design_rules": "design",
    "design_text_read": "design_text",
    "design_text_write": "design_text",
    "design_words": "handle_edit",  # the words of its options
    "edit_option_table": "handle_edit",
    "io/read_result": "read_result",
    "io/sentence": "read_result",
    "io/number": "read_result",
    "held_boundary": "comparison",
    "tangent_space": "comparison",
}
DIRECTORY_GROUPS = ("comparison", "constraints", "engines", "fabrication", "io", "mobility", "offset", "shapes", "sweep", "cli", "library")

FORBIDDEN_NAMES = re.compile(r"(^|[_\-.])(utils?|helpers?|common|misc|manager)([_\-.]|$)", re.I)
FORBIDDEN_IN_CORE = {
    r"#\s*include\s*<iostream>": "<iostream>: the library never prints",
    r"\b(f?printf|f?puts|putchar)\s*\(": "printf: the library never prints",
    r"\b(s?rand|random_device)\s*\(": "rand: results must be reproducible",
    r"\bstd::random_device\b": "random_device: results must be reproducible",
    r"\busing\s+namespace\b": "using namespace",
}
KEY = re.compile(r"\[([A-Z]{2,3}-[0-9]+)\]")
SOURCE_SUFFIXES = (".cpp", ".hpp")


def strip_comments(text):
    """Comments and string contents blanked, line numbers kept."""
    pattern = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', re.S)
    return pattern.sub(lambda m: re.sub(r"[^\n]", " ", m.group()), text)


def sources(*folders):
    for folder in folders:
        base = ROOT / folder
        if base.is_dir():
            yield from sorted(p for p in base.rglob("*") if p.suffix in SOURCE_SUFFIXES)


def group_of(name):
    """Group of an include path such as 'engines/working_set.hpp'."""
    stem = name.rsplit(".", 1)[0]
    if stem in FILE_GROUPS:
        return FILE_GROUPS[stem]
    parts = stem.split("/")
    return parts[0] if parts[0] in DIRECTORY_GROUPS else parts[-1]


def group_of_file(path):
    relative = path.relative_to(ROOT).as_posix()
    for prefix in ("core/include/planish/", "core/src/"):
        if relative.startswith(prefix):
            return group_of(relative[len(prefix):])
    for folder in ("cli", "comparison", "library"):
        if relative.startswith(f"core/{folder}/"):
            return folder
    return "python" if relative.startswith("python/") else "wasm"


def check_includes():
    for path in sources("core", "wasm", "python"):
        group = group_of_file(path)
        where = path.relative_to(ROOT)
        if group not in ARROWS:
            yield f"{where}: '{group}' has no place in ARROWS of {Path(__file__).name}"
            continue
        allowed = ARROWS[group]
        if allowed is None:
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            match = re.match(r'\s*#\s*include\s*"([^"]+)"', line)
            if not match:
                continue
            target = group_of(re.sub(r"^planish/", "", match.group(1)))
            if target != group and target not in allowed:
                yield f"{where}:{number}: {group} must not include {target} ({match.group(1)})"


def check_cycles():
    """File by file, since groups may hide one."""
    graph = {}
    known = {}
    for path in sources("core"):
        relative = path.relative_to(ROOT).as_posix()
        known[re.sub(r"^core/(comparison/)?(include|src|cli|library)/", "", relative)] = relative
    for name, relative in known.items():
        text = (ROOT / relative).read_text(encoding="utf-8")
        graph[name] = [t for t in re.findall(r'#\s*include\s*"([^"]+)"', text) if t in known]
    for circle in find_circles(graph):
        yield f"{known[circle[-2]]}: include cycle {' -> '.join(circle)}"


def check_core_rules():
    for path in sources("core/include", "core/src", "core/comparison"):
        where = path.relative_to(ROOT)
        text = strip_comments(path.read_text(encoding="utf-8"))
        for number, line in enumerate(text.splitlines(), 1):
            for pattern, reason in FORBIDDEN_IN_CORE.items():
                if re.search(pattern, line):
                    yield f"{where}:{number}: {reason}"
            # A variable at namespace scope (column 0) that can change.
            if re.match(
                r"(?=\S)(static|inline|thread_local|extern)?\s*(static|inline|thread_local)?\s*"
                r"(?!const|using|return|class|struct|enum|template|namespace|typedef|public)"
                r"[A-Za-z_][\w:<>,\s*&]*\s[A-Za-z_]\w*\s*(=[^=].*|\{[^()]*\})?;\s*$",
                line,
            ) and "(" not in line.split("=")[0] and "const" not in line.split("=")[0]:
                yield f"{where}:{number}: a global variable: {line.strip()}"
            if re.match(r"\s+(static|thread_local)\s+(?!const|constexpr|assert)[^()]*(=|;)", line):
                if "constexpr" not in line and "(" not in line.split("=")[0]:
                    yield f"{where}:{number}: static state: {line.strip()}"


def check_names():
    for folder in ("core", "wasm", "web/src", "python", "tests", ".tools", "docs"):
        base = ROOT / folder
        for path in sorted(base.rglob("*")) if base.is_dir() else []:
            if path.is_file() and FORBIDDEN_NAMES.search(path.name):
                yield f"{path.relative_to(ROOT)}: a drawer name; say what is inside"


def ledger_rows():
    """Rows of docs/math.md: key, line number, functions, tests."""
    for number, line in enumerate((ROOT / "docs/math.md").read_text(encoding="utf-8").splitlines(), 1):
        cells = [cell.strip() for cell in re.split(r"(?<!\\)\|", line)]
        match = re.fullmatch(r"\[?([A-Z]{2,3}-[0-9]+)\]?", cells[1]) if len(cells) > 3 else None
        if match:
            yield match.group(1), number, re.findall(r"`([^`]+)`", cells[-3]), re.findall(
                r"`([^`]+)`", cells[-2]
            )


def check_ledger():
    if not (ROOT / "docs/math.md").exists():
        yield "docs/math.md: missing"
        return
    rows = {}
    for key, number, functions, tests in ledger_rows():
        if key in rows:
            yield f"docs/math.md:{number}: [{key}] has two rows"
        rows[key] = (number, functions, tests)
    used = set()
    code = []
    for path in sources("core", "wasm"):
        text = path.read_text(encoding="utf-8")
        code.append(strip_comments(text))
        for line_number, line in enumerate(text.splitlines(), 1):
            for key in KEY.findall(line):
                used.add(key)
                if key not in rows:
                    yield f"{path.relative_to(ROOT)}:{line_number}: [{key}] has no row in docs/math.md"
    for key in rows.keys() - used:
        yield f"docs/math.md:{rows[key][0]}: [{key}] is used nowhere in the code"
    names = "\n".join(code)
    tests = set()
    for path in sources("tests"):
        for suite, test in re.findall(
            r"\bTEST(?:_P|_F)?\(\s*(\w+)\s*,\s*(\w+)\s*\)", path.read_text(encoding="utf-8")
        ):
            tests.add(f"{suite}.{test}")
    for key, (number, functions, named_tests) in sorted(rows.items()):
        if not functions:
            yield f"docs/math.md:{number}: [{key}] names no function"
        if not named_tests:
            yield f"docs/math.md:{number}: [{key}] names no test"
        for function in functions:
            if not re.search(rf"\b{re.escape(function.split('::')[-1])}\b", names):
                yield f"docs/math.md:{number}: [{key}] names {function}, which does not exist"
        for test in named_tests:
            if test not in tests:
                yield f"docs/math.md:{number}: [{key}] names test {test}, which does not exist"


def main():
    violations = []
    for check in (check_includes, check_cycles, check_core_rules, check_names, check_ledger):
        violations += check()
    for violation in violations:
        print(violation)
    return 1 if violations else 0


if __name__ == "__main__":
    sys.exit(main())
