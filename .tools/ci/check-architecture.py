#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks what the compiler cannot: the direction of includes, and the equation ledger.

Run from anywhere: python3 .tools/ci/check-architecture.py
One line per violation on standard output; exit code 1 if there is any.
"""

import re
import sys
from pathlib import Path

from circles import find_circles

ROOT = Path(__file__).resolve().parents[2]

# A group is a folder of core/src and core/include/planish; here is which others each may include, in
# the order in which data flows. Everything may include itself, and a new arrow is a decision.
FROM_MESH = {"numeric", "text", "mesh"}
GEOMETRY = FROM_MESH | {"symmetry", "obstacles", "constraints", "supports", "measures"}
SOLVED = GEOMETRY | {"problem", "engines"}
CORE = SOLVED | {"cuts", "io", "shapes", "projection", "edit", "variations", "families", "fabrication"}
CORE |= {"splitting", "repetition", "offset", "mobility", "design", "sweep"}
ARROWS = {
    "numeric": set(),
    "text": set(),  # numbers as text, sentences, refusals
    "mesh": {"numeric", "text"},
    "symmetry": FROM_MESH,
    "obstacles": {"text"},  # where nothing may go
    "cuts": FROM_MESH,  # panels are parted, points are added, none moves
    "constraints": FROM_MESH | {"obstacles"},
    "supports": FROM_MESH | {"obstacles", "constraints"},
    "measures": FROM_MESH | {"constraints"},
    "problem": GEOMETRY,
    "engines": GEOMETRY | {"problem"},
    "io": FROM_MESH,
    "shapes": FROM_MESH,
    "projection": SOLVED,
    "edit": SOLVED | {"projection"},
    "splitting": SOLVED | {"cuts", "projection", "edit"},  # panels parted for what a solve asks
    "variations": SOLVED | {"projection", "edit"},
    "families": {"numeric", "text"},  # shapes in a plane, of whatever they are
    "fabrication": FROM_MESH | {"constraints", "measures", "io", "families"},
    "repetition": SOLVED | {"projection", "families", "fabrication"},  # more panels alike
    "offset": SOLVED,
    "mobility": GEOMETRY | {"edit", "fabrication"},
    "design": SOLVED | {"cuts", "projection", "edit", "variations", "shapes", "io"},
    "sweep": FROM_MESH | {"io", "design"},
    "comparison": SOLVED | {"edit", "variations", "projection"},  # native only
    "workflow": CORE,  # what is asked for, done and told, under every door
    "library": CORE | {"workflow"},
    "cli": None,  # everything
    "wasm": None,
    "python": None,
}

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
    return name.split("/")[0]


def group_of_file(path):
    relative = path.relative_to(ROOT).as_posix()
    for prefix in ("core/include/planish/", "core/src/"):
        if relative.startswith(prefix):
            return group_of(relative[len(prefix):])
    for folder in ("cli", "comparison", "library", "workflow"):
        if relative.startswith(f"core/{folder}/"):
            return folder
    return "python" if relative.startswith("python/") else "wasm"


def check_includes():
    layers = {p.name: f for f in ("workflow", "library", "cli") for p in sources(f"core/{f}")}
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
            # Without a folder it lies beside the file that includes it, or is one of the layers above.
            match = re.match(r'\s*#\s*include\s*"([^"]+)"', line)
            if not match:
                continue
            name = match.group(1)
            target = group_of(re.sub(r"^planish/", "", name)) if "/" in name else layers.get(name, group)
            if target != group and target not in allowed:
                yield f"{where}:{number}: {group} must not include {target} ({match.group(1)})"


def check_cycles():
    """File by file, since groups may hide one."""
    graph = {}
    known = {}
    for path in sources("core"):
        relative = path.relative_to(ROOT).as_posix()
        known[re.sub(r"^core/(comparison/)?(include|src|cli|library|workflow)/", "", relative)] = relative
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
