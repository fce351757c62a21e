#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""clang-tidy over the core and the session. Twelve files of a folder are looked at as one, because most
of the time goes into Eigen's headers: a quarter of the time of each file for itself. Twelve that passed
before with the same text, headers, rules and clang-tidy are skipped; what passed is remembered outside
the tree, so that the next clone on this machine need not ask again."""

import concurrent.futures
import hashlib
import itertools
import json
import os
import pathlib
import subprocess
import sys
import time

TREE = pathlib.Path(__file__).resolve().parent.parent
TOGETHER = 12
DATABASE = TREE / "build/tidy/database"
UNITS = TREE / "build/tidy/units"
KNOWN = pathlib.Path(os.environ.get("XDG_CACHE_HOME", pathlib.Path.home() / ".cache")) / "planish/tidy"
PACKAGES = ["libeigen3-dev", "libstdc++-12-dev"]


def said(*command):
    return subprocess.run(command, cwd=TREE, capture_output=True, text=True, check=False).stdout


def sources():
    """Files of a folder, twelve at a time."""
    listed = said("git", "ls-files", "core/src/*.cpp", "wasm/session*.cpp", "wasm/keep_out_lines.cpp").split()
    for folder, files in itertools.groupby(sorted(listed, key=lambda f: (os.path.dirname(f), f)), os.path.dirname):
        files = list(files)
        for start in range(0, len(files), TOGETHER):
            yield folder.replace("/", "_") + f"_{start // TOGETHER}", files[start : start + TOGETHER]


def write_units():
    """One file that includes twelve, and how each is compiled: as the first of them."""
    subprocess.run(["cmake", "--preset", "native", "-B", DATABASE, "-DPLANISH_UNITY=OFF", "--log-level=WARNING"],
                   cwd=TREE, check=True, stdout=subprocess.DEVNULL)
    commands = {entry["file"]: entry for entry in json.loads((DATABASE / "compile_commands.json").read_text())}
    UNITS.mkdir(parents=True, exist_ok=True)
    units = {}
    entries = []
    for name, files in sources():
        unit = str(UNITS / f"{name}.cpp")
        lines = [f'#include "{TREE / file}"  // NOLINT(bugprone-suspicious-include)\n' for file in files]
        pathlib.Path(unit).write_text("".join(lines))
        entry = commands[str(TREE / files[0])]
        entries.append({**entry, "file": unit, "command": entry["command"].replace(entry["file"], unit)})
        units[unit] = files
    (UNITS / "compile_commands.json").write_text(json.dumps(entries))
    return units


def surroundings():
    """Everything but those files that the answer depends on."""
    headers = said("git", "ls-files", "core/*.hpp", "wasm/*.hpp").split()
    texts = [(TREE / name).read_bytes() for name in [".clang-tidy", "CMakeLists.txt", "core/CMakeLists.txt", *headers]]
    words = said("clang-tidy", "--version") + said("dpkg-query", "-W", *PACKAGES)
    return hashlib.sha256(b"".join([words.encode(), *texts])).hexdigest()


def complaints(unit, files, around):
    """What clang-tidy says; "" where it passed, now or before."""
    key = hashlib.sha256(b"".join([around.encode(), *((TREE / f).read_bytes() for f in files)])).hexdigest()
    if (KNOWN / key).exists():
        os.utime(KNOWN / key)
        return ""
    run = subprocess.run(["clang-tidy", "-p", UNITS, "--quiet", "--warnings-as-errors=*", unit],
                         cwd=TREE, capture_output=True, text=True, check=False)
    if run.returncode == 0:
        (KNOWN / key).touch()
        return ""
    return run.stdout + run.stderr


def main():
    KNOWN.mkdir(parents=True, exist_ok=True)
    for old in KNOWN.iterdir():
        if old.stat().st_mtime < time.time() - 30 * 86400:
            old.unlink()
    units = write_units()
    around = surroundings()
    jobs = int(os.environ.get("PLANISH_JOBS", os.cpu_count() or 1))
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        found = list(pool.map(lambda unit: complaints(unit, units[unit], around), units))
    print("".join(found), end="")
    sys.exit(any(found))


main()
