#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Do the checks notice a fault? Draws mutations with a seed (a comparison turned, a statement dropped, two
arguments swapped), makes one at a time in a copy of the tree and runs checks on it until one fails.

    mutations.py web --count 40 --seed 1 browser
    mutations.py core --count 40 --seed 1 parity

Prints a line for each: its number, what was changed, and what caught it; ends with the count. A mutation of
the core is given to the compiler, then to the C++ tests, without sanitizers, the quickest first, each as long as
the last `checks.py native sanitize` in this tree says, until one fails; only what they leave goes to the checks
named. --tests 80 ends with the quickest that take so many seconds together. One of the page is given to the
linter and the type checker, then to the files of unit and page tests that reach its function (page_tests.py),
the quickest first; only what they leave goes to the checks named. --only 3,17 goes on with these. The copy lies in build/mutations/ with a
build of its own.
"""

import argparse
import os
import pathlib
import random
import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

import page_tests

TREE = pathlib.Path(__file__).resolve().parents[2]
COPY = TREE / "build/mutations/tree"
PROGRAMS = {"native": "planish_tests", "sanitize": "planish_quick_tests"}
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


def said(*command, **options):
    return subprocess.run(command, cwd=COPY, capture_output=True, text=True, check=False, **options)


def caught_by(checks):
    environment = os.environ | {"PLANISH_BAIL": "yes"}
    for check in checks:
        if said("python3", ".tools/ci/checks.py", check, env=environment).returncode != 0:
            return check
    return None


def compiled():
    """The command and all C++ tests, without sanitizers."""
    if not (COPY / "build/native/build.ninja").exists():
        said("cmake", "--preset", "native")
    targets = ["planish", *PROGRAMS.values()]
    return said("cmake", "--build", "--preset", "native", "-j", os.environ.get("PLANISH_JOBS", "2"), "--target", *targets).returncode == 0


def recorded_tests():
    """The C++ tests that the last checks of this tree passed: seconds, program, name, the quickest first."""
    for check, program in PROGRAMS.items():
        for file in (TREE / "build/checks" / check).glob("*.xml"):
            for case in ElementTree.parse(file).iter("testcase"):
                if case.get("status") == "run" and case.find("skipped") is None and case.find("failure") is None:
                    yield float(case.get("time")), program, f"{case.get('classname')}.{case.get('name')}"


def portions(most):
    """Tests that one process runs: of some seconds at first, then more."""
    longest, tests, left = 5.0, {}, most
    for seconds, program, name in sorted(recorded_tests()):
        left -= seconds
        if left < 0:
            break
        spent, names = tests.setdefault(program, [0.0, []])
        tests[program][0] = spent + seconds
        names.append(name)
        if tests[program][0] > longest:
            yield program, *tests.pop(program)
            longest *= 1.2
    for program, (seconds, names) in tests.items():
        yield program, seconds, names


def caught_by_test(most):
    """What the compiler or a test says first; None where all pass."""
    if not compiled():
        return "compiler"
    for program, seconds, names in portions(most):
        options = COPY / "build/flags"
        options.write_text(f"--gtest_filter={':'.join(names)}\n--gtest_fail_fast\n--gtest_brief=1\n", encoding="utf-8")
        try:
            run = said(f"build/native/tests/{program}", f"--gtest_flagfile={options}", timeout=120 + 20 * seconds)
        except subprocess.TimeoutExpired:
            return f"{names[0]} or after it: no end"
        if run.returncode != 0:
            failed = re.findall(r"\[  FAILED  \] ([\w./]+)", run.stdout)
            return failed[0] if failed else f"{names[0]} or after it: status {run.returncode}"
    return None


def column(old, new):
    """Where two lines begin to differ; in a statement that is dropped, its start."""
    if not new.strip():
        return len(new)
    return next(k for k in range(len(old)) if old[:k + 1] != new[:k + 1])


def caught_on_page(tests, number, path):
    """Not the formatter, which would notice any line that is gone."""
    if said("node_modules/.bin/biome", "lint", path).returncode != 0:
        return "lint"
    types = said("node_modules/.bin/tsc", "-p", "web/tsconfig.json", "--incremental", "--tsBuildInfoFile", "build/types.json")
    return "types" if types.returncode != 0 else tests.caught_by(number)


def copied():
    """The last commit of this tree, elsewhere."""
    if not COPY.exists():
        subprocess.run(["git", "clone", "-q", TREE, COPY], check=True)
        os.symlink(TREE / "node_modules", COPY / "node_modules")
    subprocess.run(["git", "fetch", "-q", "origin"], cwd=COPY, check=True)
    subprocess.run(["git", "reset", "-q", "--hard", "FETCH_HEAD"], cwd=COPY, check=True)


def ready(asked, faults):
    """What looks at a fault before the checks that are named, having passed without one."""
    if asked.which == "core":
        if not any(recorded_tests()):
            sys.exit("mutations: run `checks.py native sanitize` first")
        look, check = lambda number, path: caught_by_test(asked.tests), caught_by_test(asked.tests)
    else:
        places = [[number, str(path), line, at] for number, (path, line, at, *_) in faults.items()]
        tests = page_tests.PageTests(COPY, TREE / "build/mutations/page", places)
        look = lambda number, path: caught_on_page(tests, number, path)
        check = caught_by(["build-native", "build-wasm"]) or tests.record()
    if check := check or caught_by(asked.checks):
        sys.exit(f"mutations: {check} fails without any")
    return look


def main():
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("which", choices=FOLDERS)
    words.add_argument("--count", type=int, default=40)
    words.add_argument("--seed", type=int, default=1)
    words.add_argument("--tests", type=float, default=float("inf"))
    words.add_argument("--only", type=lambda text: {int(word) for word in text.split(",")})
    words.add_argument("checks", nargs="*")
    asked = words.parse_args()
    copied()
    faults = {}
    for place, (path, number, kind, new) in enumerate(drawn(asked.which, asked.count, asked.seed), 1):
        old = (COPY / path).read_text(encoding="utf-8").splitlines()[number]
        faults[place] = path, number, column(old, new), kind, old, new
    look = ready(asked, faults)
    count = of = 0
    for place, (path, number, _, kind, old, new) in faults.items():
        if asked.only and place not in asked.only:
            continue
        file = COPY / path
        text = file.read_text(encoding="utf-8")
        lines = text.splitlines(keepends=True)
        lines[number] = new + "\n"
        file.write_text("".join(lines), encoding="utf-8")
        check = look(place, path) or caught_by(asked.checks)
        file.write_text(text, encoding="utf-8")
        count += check is not None
        of += 1
        changed = f" -> {new.strip()[:90]}" if new.strip() else ""
        print(f"{place:3} {check or 'NOT CAUGHT'}: {kind} {path}:{number + 1}: {old.strip()[:90]}{changed}", flush=True)
    print(f"{count} of {of} caught")


main()
