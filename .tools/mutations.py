#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Do the checks notice a fault? Draws mutations with a seed (a comparison turned, a statement dropped, two
arguments swapped), makes one at a time in a copy of the tree and runs checks on it until one fails.

    mutations.py web --count 40 --seed 1 lint types unit page browser
    mutations.py core --count 40 --seed 1 native sanitize

Prints a line for each: what was changed, and by which check it was caught; ends with the count. The copy
lies in build/mutations/ with a build of its own; core/src needs some minutes of two cores a mutation.
"""

import argparse
import pathlib
import random
import re
import shutil
import subprocess
import sys

TREE = pathlib.Path(__file__).resolve().parent.parent
COPY = TREE / "build/mutations/tree"
FOLDERS = {"web": ("web/src", (".ts", ".tsx")), "core": ("core/src", (".cpp",))}
COMPARISONS = {" < ": " >= ", " > ": " <= ", " <= ": " > ", " >= ": " < ", " == ": " != ", " != ": " == ",
               " === ": " !== ", " !== ": " === ", " && ": " || ", " || ": " && "}
# A call with two plain arguments.
CALL = re.compile(r"(\b\w+\()([\w.]+), ([\w.]+)(\))")
# A statement of one line that is neither a declaration, a jump nor part of another.
STATEMENT = re.compile(r"^\s+(?!return|break|continue|throw|import|export|using|case|const |let |auto |type )[\w.#>\-]+"
                       r"(\(.*\)|[\w.\[\]]* [-+*/|&]?= .*);$")


def turned(line):
    for old, new in COMPARISONS.items():
        if old in line and "template" not in line and "=>" not in line:
            yield "comparison", line.replace(old, new, 1)


def dropped(line):
    if STATEMENT.match(line):
        yield "statement", re.match(r"\s*", line)[0]


def swapped(line):
    for call in CALL.finditer(line):
        if call[2] != call[3]:
            yield "arguments", line[:call.start()] + f"{call[1]}{call[3]}, {call[2]}{call[4]}" + line[call.end():]


def mutations(which):
    """All of them: file, line from 0, what kind, the new line."""
    folder, endings = FOLDERS[which]
    for path in sorted(p for p in (TREE / folder).rglob("*") if p.suffix in endings):
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines()):
            if line.strip().startswith(("//", "*", "/*", "#")):
                continue
            for kind, new in (*turned(line), *dropped(line), *swapped(line)):
                yield path.relative_to(TREE), number, kind, new


def drawn(which, count, seed):
    """As many of each kind as the count allows."""
    kinds = {}
    for mutation in mutations(which):
        kinds.setdefault(mutation[2], []).append(mutation)
    chooser = random.Random(seed)
    for each in kinds.values():
        chooser.shuffle(each)
    names = sorted(kinds)
    return [kinds[names[k % len(names)]].pop() for k in range(count)]


def caught_by(checks):
    for check in checks:
        run = subprocess.run(["python3", ".tools/checks.py", check], cwd=COPY, capture_output=True, check=False)
        if run.returncode != 0:
            return check
    return None


def main():
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("which", choices=FOLDERS)
    words.add_argument("--count", type=int, default=40)
    words.add_argument("--seed", type=int, default=1)
    words.add_argument("checks", nargs="+")
    asked = words.parse_args()
    if not COPY.exists():
        subprocess.run(["git", "clone", "-q", TREE, COPY], check=True)
        shutil.copytree(TREE / "node_modules", COPY / "node_modules", symlinks=True)
    subprocess.run(["git", "fetch", "-q", "origin"], cwd=COPY, check=True)
    subprocess.run(["git", "reset", "-q", "--hard", "FETCH_HEAD"], cwd=COPY, check=True)
    if check := caught_by(asked.checks):
        sys.exit(f"mutations: {check} fails without any")
    caught = 0
    for path, number, kind, new in drawn(asked.which, asked.count, asked.seed):
        file = COPY / path
        text = file.read_text(encoding="utf-8")
        lines = text.splitlines(keepends=True)
        old = lines[number].strip()
        lines[number] = new + "\n"
        file.write_text("".join(lines), encoding="utf-8")
        check = caught_by(asked.checks)
        file.write_text(text, encoding="utf-8")
        caught += check is not None
        print(f"{check or 'NOT CAUGHT':12} {kind:10} {path}:{number + 1}: {old[:90]}", flush=True)
    print(f"{caught} of {asked.count} caught")


main()
