#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the checks: `checks.py` those that a change needs before it is shown (npm test), `checks.py rest`
the others of every commit (npm run check), `checks.py nightly` everything long as well, `checks.py NAME...`
these, `checks.py nightly NAME...` these as at night. What a check needs is built first; checks that use one core
run beside each other.

Every check writes a log and, where it runs tests, JUnit files under build/checks/NAME. They alone say what
passed. Ends with the times, the ten slowest tests and one line that counts. A test may take 15 s, one of `rest` a
minute, and four times that where CI is set: how fast that machine is, nobody knows. Nightly ones may take longer.
A check that has not ended after 30 minutes is stopped and has failed; a nightly one after two hours.
"""

import dataclasses
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import threading
import time
import xml.etree.ElementTree as ElementTree

TREE = pathlib.Path(__file__).resolve().parents[2]
OUT = TREE / "build/checks"
CORES = int(os.environ.get("PLANISH_JOBS", os.cpu_count() or 1))
# Thirteen recipes on a page, 55 designs in one runtime twice.
LONG_TESTS = ("a recipe gives", "gives the same bits")
SLOWER = 4 if os.environ.get("CI") else 1
LONGEST = 15.0 * SLOWER
MOST_MINUTES, MOST_MINUTES_NIGHTLY = 30, 120
LONGEST_OF_REST = 60.0 * SLOWER  # a browser with storage, workers and a solver to load, two of them at a time


@dataclasses.dataclass(frozen=True)
class Check:
    """A node of the graph. `command` is run by bash with $OUT, a folder of its own, and $CORES; once for each of
    its `parts` with $PART from 0, as cores become free."""

    command: str
    needs: tuple = ()
    cores: int = 1
    parts: int = 1


def compiled(preset, *targets):
    """A tree of CMake: configured once, then built."""
    return Check(
        f"[ -e build/{preset}/build.ninja ] || cmake --preset {preset} --log-level=WARNING; "
        f"cmake --build --preset {preset} -j $CORES --target {' '.join(targets)}",
        cores=CORES,
    )


def dealt(command, *needs, parts=4 * CORES):
    """GoogleTest's program, its tests dealt out to processes that fill what other checks leave of the cores."""
    return Check(
        f"GTEST_TOTAL_SHARDS={parts} GTEST_SHARD_INDEX=$PART {command} --gtest_brief=1 "
        "--gtest_output=xml:$OUT/$PART.xml",
        needs, parts=parts)


def vitest(folder, options="", config="web/vitest.config.ts"):
    """PLANISH_BAIL: ends with the first failure, where that is all that is asked."""
    return (
        "npx --no-install vitest run ${PLANISH_BAIL:+--bail=1} "
        f"--config {config} --dir tests/{folder} "
        f"--reporter=default --reporter=junit --outputFile.junit=$OUT/vitest.xml {options}"
    )


WASM_TEST = "node --no-experimental-fetch build/wasm/tests/{}.cjs"
NIGHTLY = {"PLANISH_NIGHTLY": "1", "PLANISH_INSETS": "100000"}

# Builds and checks in the order in which they start where there is a choice.
GRAPH = {
    "format": Check("git ls-files --cached --others --exclude-standard '*.cpp' '*.hpp' | xargs clang-format --dry-run -Werror"),
    "lint": Check("npx --no-install biome ci --reporter=summary"),
    "types": Check("npx --no-install tsc -p web/tsconfig.json && npx --no-install tsc -p wasm/package/tsconfig.json --noEmit"),
    "architecture": Check("python3 .tools/ci/check-architecture.py && python3 .tools/ci/check-web-layers.py"),
    "build-wasm": compiled("wasm", "planish_page_wasm"),
    "build-native": compiled("native", "planish", "planish_tests"),
    # Each of them ends with one long link, which uses one core: side by side.
    "build-wasm-rest": compiled("wasm", "planish_package_wasm", "planish_wasm_tests"),
    "build-sanitize": compiled("sanitize", "planish", "planish_quick_tests"),
    "build-fuzz": compiled("fuzz", "all"),
    "build-site": Check("bash .tools/start/build.sh site", ("build-wasm",)),
    # The longest of one core each, or of somewhat more: two pages keep two cores busy but for a sixth of the time.
    "page": Check(vitest("page", config="web/vitest.page.config.ts"), ("build-native", "build-wasm")),
    "browser": Check(vitest("browser", config="web/vitest.browser.config.ts"), ("build-site",), cores=max(1, CORES - 1)),
    "build-package": Check("bash .tools/start/build.sh npm", ("build-wasm", "build-wasm-rest")),
    "build-wheel": Check("bash .tools/start/wheel.sh", ("build-native",)),
    # One set of recipes through all of them, and what leads from one to another.
    "doors": Check(vitest("doors", config="web/vitest.browser.config.ts"), ("build-wheel", "build-package", "build-site")),
    "unit": Check(vitest("web"), ("build-wasm",)),
    "parity": Check(vitest("parity"), ("build-native", "build-wasm")),
    # The second engine draws only on a screen, even one that nobody looks at.
    "firefox": Check(
        "bash .tools/start/setup.sh firefox && xvfb-run -a -s '-screen 0 1500x1000x24' " + vitest("firefox"), ("build-site",)),
    # The packed npm package in a project of its own; the wheel in an environment with nothing but numpy.
    "package": Check(vitest("package"), ("build-native", "build-package")),
    "python": Check(
        "build/python/venv/bin/python -X faulthandler -m pytest -q -p no:cacheprovider --timeout=300 "
        "--junitxml=$OUT/pytest.xml tests/python",
        ("build-wheel",)),
    # Six edits of kinds in which no handle can get nearer; of all kinds (--edits 60) some can: decision 4.
    "infeasible": Check(
        "/usr/bin/python3 tests/reference/infeasible.py --edits 6 --kinds edge,area,slide,keep-out,plane,line "
        "--points 26 --folder none", ("build-native",)),
    "cppcheck": Check("bash .tools/ci/cppcheck.sh"),
    "native": dealt("build/native/tests/planish_tests", "build-native", parts=8 * CORES),
    "sanitize": dealt("build/sanitize/tests/planish_quick_tests", "build-sanitize"),
    "wasm": dealt(WASM_TEST.format("planish_wasm_tests"), "build-wasm-rest", parts=CORES),
    "tidy": Check("python3 .tools/ci/tidy.py", cores=CORES),
    "fuzz": Check("bash .tools/ci/fuzz.sh", ("build-fuzz",), cores=CORES),
    # Nightly: the long forms of the same.
    "build-wasm-all": compiled("wasm", "planish_all_tests"),
    "build-sanitize-all": compiled("sanitize", "planish", "planish_all_tests"),
    "wasm-all": dealt(WASM_TEST.format("planish_all_tests"), "build-wasm-all", parts=8 * CORES),
    "sanitize-all": dealt("build/sanitize/tests/planish_all_tests", "build-sanitize-all", parts=16 * CORES),
    "tidy-all": Check("python3 .tools/ci/tidy.py --all --record", cores=CORES),
    "fuzz-long": Check("bash .tools/ci/fuzz.sh --long", ("build-fuzz", "build-wasm"), cores=CORES),
}
BEFORE_SHOWING = ["format", "lint", "types", "architecture", "unit", "page", "parity", "native"]
REST = ["browser", "firefox", "package", "python", "doors", "sanitize", "wasm", "tidy", "cppcheck", "infeasible", "fuzz"]
LONG = ["wasm-all", "sanitize-all", "tidy-all", "fuzz-long"]
SETS = {"rest": REST, "nightly": BEFORE_SHOWING + [c for c in REST if c not in ("sanitize", "wasm", "tidy", "fuzz")] + LONG}


@dataclasses.dataclass
class Test:
    check: str
    name: str
    seconds: float
    outcome: str  # passed, failed, skipped
    said: str = ""


@dataclasses.dataclass
class Run:
    """From when to when, in seconds since all began, and how much of a processor's time it took."""

    name: str
    status: int
    tests: list
    start: float = 0.0
    end: float = 0.0
    processor: float = 0.0


def tests_of(check, folder):
    """What the JUnit files of a check say."""
    for file in sorted(folder.glob("*.xml")):
        for case in ElementTree.parse(file).iter("testcase"):
            bad = case.find("failure") if case.find("failure") is not None else case.find("error")
            skipped = case.find("skipped") is not None or case.get("status") == "notrun"
            said = "" if bad is None else (bad.get("message") or "") + "\n" + (bad.text or "")
            outcome = "failed" if bad is not None else "skipped" if skipped else "passed"
            name = f"{case.get('classname')}.{case.get('name')}"
            yield Test(check, name, float(case.get("time") or 0), outcome, said)


def stop(command, log, minutes):
    """SIGABRT first: Python, asked by faulthandler, says where it stands."""
    log.write(f"checks: stopped after {minutes} minutes\n".encode())
    os.killpg(command.pid, signal.SIGABRT)
    time.sleep(5)
    os.killpg(command.pid, signal.SIGKILL)


def run_part(name, part, nightly):
    """Runs a part of a check: its status, and the processor time of all that it started."""
    folder = OUT / name
    environment = {**os.environ, "OUT": str(folder), "CORES": str(CORES), "PART": str(part), **(NIGHTLY if nightly else {})}
    with open(folder / "log", "ab") as log:
        # A session of its own, so that it can be stopped with all that it started.
        command = subprocess.Popen(["bash", "-c", f"set -o pipefail; {GRAPH[name].command}"], cwd=TREE, env=environment,
                                   stdin=subprocess.DEVNULL, stdout=log, stderr=log, start_new_session=True)
        minutes = MOST_MINUTES_NIGHTLY if nightly else MOST_MINUTES
        too_late = threading.Timer(minutes * 60, stop, (command, log, minutes))
        too_late.start()
        _, status, used = os.wait4(command.pid, 0)
        command.returncode = os.waitstatus_to_exitcode(status)
        too_late.cancel()
    return command.returncode, used.ru_utime + used.ru_stime


def ended(done, nightly):
    """What a check that has run says; a failure without a test that failed is a failed test of its own name."""
    done.tests = list(tests_of(done.name, OUT / done.name))
    if not nightly:
        longest = LONGEST if done.name in BEFORE_SHOWING else LONGEST_OF_REST
        for test in done.tests:
            if test.outcome == "passed" and test.seconds > longest and not any(long in test.name for long in LONG_TESTS):
                test.outcome, test.said = "failed", f"took {test.seconds:.1f} s, more than {longest:.0f}"
    wrong = done.status != 0 and not any(test.outcome == "failed" for test in done.tests)
    if wrong or not done.tests and not done.name.startswith("build-"):
        seconds = done.end - done.start if not done.tests else 0
        done.tests.append(Test(done.name, done.name, seconds, "failed" if wrong else "passed"))
    return done


def report(done):
    """One line a check, and under it what failed."""
    failed = [test for test in done.tests if test.outcome == "failed"]
    count = sum(test.outcome == "passed" for test in done.tests)
    word = "FAIL" if failed else "ok"
    print(f"  {word:5} {done.name:17} {count:5} passed {done.start:5.0f} to {done.end:4.0f} s, "
          f"{done.processor:4.0f} s of a processor", flush=True)
    for test in failed[:20]:
        print(f"        {test.name}")
        for line in test.said.strip().splitlines()[:12]:
            print(f"            {line[:300]}")
    if failed and any(test.name == done.name for test in failed):
        text = (OUT / done.name / "log").read_text(errors="replace")
        print("".join(f"        {line[:300]}\n" for line in text.splitlines()[-40:]), end="", flush=True)


def with_needs(names):
    """These and all that they need, as the graph lists them."""
    wanted, open_ones = set(), list(names)
    while open_ones:
        name = open_ones.pop()
        if name not in wanted:
            wanted.add(name)
            open_ones += GRAPH[name].needs
    return [name for name in GRAPH if name in wanted]


class Schedule:
    """As many beside each other as there are cores, in the order of the graph. A build that takes all of them is
    waited for, since others need it. What needs something that failed has failed."""

    def __init__(self, names, nightly):
        self.nightly = nightly
        self.began = time.monotonic()
        self.waiting = [(name, part) for name in with_needs(names) for part in range(GRAPH[name].parts)]
        self.running = []
        self.runs = {}
        self.left = {name: GRAPH[name].parts for name, _ in self.waiting}
        self.changed = threading.Condition()

    def now(self):
        return time.monotonic() - self.began

    def begin(self, name, part):
        if name not in self.runs:
            shutil.rmtree(OUT / name, ignore_errors=True)
            (OUT / name).mkdir(parents=True)
            self.runs[name] = Run(name, 0, [], self.now())
        self.running.append((name, part))
        threading.Thread(target=self.work, args=(name, part)).start()

    def work(self, name, part):
        status, processor = run_part(name, part, self.nightly)
        with self.changed:
            done = self.runs[name]
            done.status, done.end = done.status or status, self.now()
            done.processor += processor
            self.left[name] -= 1
            self.running.remove((name, part))
            if self.left[name] == 0:
                report(ended(done, self.nightly))
            self.changed.notify()

    def give_up(self, name):
        self.waiting = [each for each in self.waiting if each[0] != name]
        self.left[name] = 0
        said = f"{name}: what it needs was not built"
        self.runs[name] = Run(name, 1, [Test(name, said, 0.0, "failed")], self.now(), self.now())
        report(self.runs[name])

    def begin_what_can(self):
        for name, part in list(self.waiting):
            check = GRAPH[name]
            built = [need for need in check.needs if self.left[need] == 0]
            if any(self.runs[need].status != 0 for need in built):
                if self.left[name]:
                    self.give_up(name)
            elif len(built) == len(check.needs):
                if check.cores + sum(GRAPH[other].cores for other, _ in self.running) <= CORES:
                    self.waiting.remove((name, part))
                    self.begin(name, part)
                elif name.startswith("build-"):
                    break

    def run(self):
        with self.changed:
            while self.waiting or self.running:
                self.begin_what_can()
                if self.running:
                    self.changed.wait()
        return list(self.runs.values())


def draw(runs):
    """When each ran, over the whole time."""
    whole = max(done.end for done in runs) or 1.0
    for done in runs:
        first, last = (round(60 * at / whole) for at in (done.start, done.end))
        print(f"  {done.name:17} {' ' * first}{'=' * max(last - first, 1)}")


def main():
    words = sys.argv[1:]
    nightly = words[:1] == ["nightly"]
    names = words[1:] if len(words) > 1 and nightly else SETS.get(words[0], words) if words else BEFORE_SHOWING
    if unknown := [name for name in names if name not in GRAPH]:
        sys.exit(f"checks: unknown check '{unknown[0]}' (rest, nightly, {', '.join(GRAPH)})")
    runs = Schedule(names, nightly).run()
    tests = [test for done in runs for test in done.tests]
    slowest = sorted(tests, key=lambda test: -test.seconds)[:10]
    print("\nThe ten slowest tests:")
    for test in slowest:
        print(f"  {test.seconds:6.1f} s  {test.check}: {test.name[:110]}")
    print()
    draw(runs)
    OUT.joinpath("times.json").write_text(json.dumps(
        {"checks": {done.name: [round(at, 1) for at in (done.start, done.end, done.processor)] for done in runs},
         "tests": [[test.check, test.name, test.seconds, test.outcome] for test in tests]}, indent=0))
    count = {word: sum(test.outcome == word for test in tests) for word in ("passed", "failed", "skipped")}
    print(f"\n{max(done.end for done in runs):.0f} s, {sum(done.processor for done in runs):.0f} s of a processor")
    print(f"{count['passed']} passed, {count['failed']} failed, {count['skipped']} skipped")
    sys.exit(count["failed"] > 0)


main()
