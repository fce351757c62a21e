# SPDX-License-Identifier: MIT
"""The unit and page tests of the page, without what checks.py says of slow ones: which files of them reach
a place in the sources, and whether one of these fails.

All of them run once to record it, with a call at the start of the innermost function around each place. What is
outside of functions is reached by all files of a suite that reads it. A function that a page calls
once, for many files of tests, is recorded with the first: who asks for certainty runs the whole suite on what is left.
"""

import json
import os
import pathlib
import signal
import subprocess

SUITES = {"web": "unit", "page": "page"}


class PageTests:
    """`places`: number, file, line and column from 0. `out` keeps what is recorded."""

    def __init__(self, tree, out, places):
        self.tree, self.out, self.places = tree, out, places
        self.out.mkdir(parents=True, exist_ok=True)
        self.seconds, self.reached = {}, {}

    def vitest(self, folder, files, places, longest):
        """What fails, as one line, or None; and the seconds of each file."""
        said, reached = self.out / f"{folder}.json", self.out / f"{folder}.txt"
        said.unlink(missing_ok=True)
        order = {"suite": SUITES[folder], "order": files, "places": places, "reached": str(reached)}
        command = ["node_modules/.bin/vitest", "run", "--config", ".tools/ci/reached.config.mjs", "--dir", f"tests/{folder}",
                   f"--bail={0 if places else 1}", "--reporter=json", f"--outputFile={said}", *files]
        # CI: tests wait longer (tests/patience.ts), since a busy machine is no fault.
        environment = os.environ | {"PLANISH_REACHED": json.dumps(order), "CI": "true"}
        with open(self.out / f"{folder}.log", "wb") as log:
            run = subprocess.Popen(command, cwd=self.tree, env=environment,
                                   stdout=log, stderr=log, start_new_session=True)
            try:
                status = run.wait(longest)
            except subprocess.TimeoutExpired:
                return f"{SUITES[folder]}: no end", {}
            finally:
                if run.poll() is None:
                    os.killpg(run.pid, signal.SIGKILL)
                    run.wait()
        return told(SUITES[folder], said, status), times(self.tree, said)

    def record(self):
        """Runs everything: what fails, or None. What the same sources said before is read again."""
        kept, key = self.out / "recorded.json", [head(self.tree), self.places]
        if kept.exists():
            recorded = json.loads(kept.read_text())
            if recorded["key"] == key:
                self.seconds, self.reached = recorded["seconds"], recorded["reached"]
                return None
        for folder in SUITES:
            notes = self.out / f"{folder}.txt"
            notes.write_text("")
            failed, seconds = self.vitest(folder, [], self.places, 3600)
            if failed:
                return failed
            self.seconds[folder] = seconds
            for line in notes.read_text().splitlines():
                file, number = line.split()
                of = self.reached.setdefault(number, {}).setdefault(folder, [])
                of += [each for each in (seconds if file == "all" else [file]) if each not in of]
        kept.write_text(json.dumps({"key": key, "seconds": self.seconds, "reached": self.reached}))
        return None

    def fails(self, folder, files):
        return self.vitest(folder, files, [], 240 + 10 * sum(map(self.seconds[folder].get, files)))[0]

    def caught_by(self, number):
        """The first test that fails, of those that reach the place, the quickest files first, and again where its file
        is run alone: what only a busy machine makes fail has noticed nothing."""
        for folder, files in self.reached.get(str(number), {}).items():
            left = sorted(files, key=self.seconds[folder].get)
            while left and (failed := self.fails(folder, left)):
                at = next((k for k, file in enumerate(left) if f" {pathlib.Path(file).name}: " in failed), None)
                if at is None or self.fails(folder, left[at:at + 1]):
                    return failed
                left = left[at + 1:]
        return None


def head(tree):
    return subprocess.run(["git", "rev-parse", "HEAD"], cwd=tree, capture_output=True, text=True, check=True).stdout.strip()


def told(suite, said, status):
    """The first failure in vitest's own file of results."""
    if status == 0:
        return None
    for file in json.loads(said.read_text())["testResults"] if said.exists() else []:
        for test in file["assertionResults"]:
            if test["status"] == "failed":
                first = (test["failureMessages"] or [""])[0].splitlines()[:1]
                return f"{suite}: {pathlib.Path(file['name']).name}: {test['title']}: {''.join(first)[:120]}"
        if file["status"] == "failed":
            return f"{suite}: {pathlib.Path(file['name']).name}: {file['message'].strip().splitlines()[0][:120]}"
    return f"{suite}: status {status}"


def times(tree, said):
    """Seconds of each file."""
    results = json.loads(said.read_text())["testResults"] if said.exists() else []
    return {str(pathlib.Path(file["name"]).relative_to(tree)): (file["endTime"] - file["startTime"]) / 1000
            for file in results}
