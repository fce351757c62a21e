#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""clang-tidy over the core and the session. Twelve files are looked at as one, because most of
the time goes into Eigen's headers: a quarter of the time of each file for itself. A unit that passed
before, with the same text of all that it includes, rules and clang-tidy, is skipped; what passed is
remembered outside the tree, and with --record in .tools/tidy-passed.txt, so that CI on a new machine asks
only about what changed since; --all (nightly) asks about everything again."""

import concurrent.futures
import hashlib
import json
import os
import pathlib
import shlex
import subprocess
import sys
import time

TREE = pathlib.Path(__file__).resolve().parent.parent
TOGETHER = 12
DATABASE = TREE / "build/tidy/database"
UNITS = TREE / "build/tidy/units"
KNOWN = pathlib.Path(os.environ.get("XDG_CACHE_HOME", pathlib.Path.home() / ".cache")) / "planish/tidy"
RECORD = TREE / ".tools/tidy-passed.txt"
PACKAGES = ["libeigen3-dev", "libstdc++-12-dev"]


def said(*command):
    return subprocess.run(command, cwd=TREE, capture_output=True, text=True, check=False).stdout


def sources():
    """Files, twelve at a time, in the order of their folders."""
    listed = said("git", "ls-files", "core/src/*.cpp", "wasm/session*.cpp", "wasm/keep_out_lines.cpp").split()
    files = sorted(listed, key=lambda f: (os.path.dirname(f), f))
    for start in range(0, len(files), TOGETHER):
        yield f"unit_{start // TOGETHER}", files[start : start + TOGETHER]


def write_units():
    """One file that includes twelve, with how it is compiled: as the first of them."""
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
        units[unit] = entries[-1]["command"]
    (UNITS / "compile_commands.json").write_text(json.dumps(entries))
    return units


def rules():
    """What the answer depends on beside the text: the checks, how it is compiled, the versions."""
    texts = [(TREE / name).read_bytes() for name in [".clang-tidy", "CMakeLists.txt", "core/CMakeLists.txt"]]
    words = said("dpkg-query", "-W", "clang-tidy-14", *PACKAGES)
    return hashlib.sha256(b"".join([words.encode(), *texts])).hexdigest()


def included(command, unit):
    """The files of the tree that a unit reads."""
    words = shlex.split(command)
    options = [word for word in words[1:] if word.startswith(("-I", "-D", "-std"))]
    systems = [f"-isystem{after}" for word, after in zip(words, words[1:]) if word == "-isystem"]
    listed = said("clang++", "-MM", *options, *systems, unit).replace("\\\n", " ").split()
    return sorted({path for path in listed[1:] if path.startswith(str(TREE)) and "/build/" not in path})


def key_of(command, unit, about):
    """Of everything that the answer depends on."""
    texts = [pathlib.Path(path).read_bytes() for path in included(command, unit)]
    return hashlib.sha256(b"".join([about.encode(), *texts])).hexdigest()


def complaints(unit, key, known):
    """What clang-tidy says; "" where it passed, now or before with the same texts."""
    if key in known:
        return ""
    run = subprocess.run(["clang-tidy", "-p", UNITS, "--quiet", "--warnings-as-errors=*", unit],
                         cwd=TREE, capture_output=True, text=True, check=False)
    if run.returncode == 0:
        (KNOWN / key).touch()
        return ""
    return run.stdout + run.stderr or f"{unit}: clang-tidy ended with {run.returncode}\n"


def main():
    KNOWN.mkdir(parents=True, exist_ok=True)
    for old in KNOWN.iterdir():
        if old.stat().st_mtime < time.time() - 30 * 86400:
            old.unlink()
    known = {path.name for path in KNOWN.iterdir()} | set(RECORD.read_text().split() if RECORD.exists() else ())
    units = write_units()
    about = rules()
    with concurrent.futures.ThreadPoolExecutor(int(os.environ.get("PLANISH_JOBS", os.cpu_count() or 1))) as pool:
        keys = dict(zip(units, pool.map(lambda unit: key_of(units[unit], unit, about), units)))
        asked = set() if "--all" in sys.argv else known
        found = list(pool.map(lambda unit: complaints(unit, keys[unit], asked), units))
    print("".join(found), end="")
    print(f"tidy: {len(units)} units, {sum(key not in asked for key in keys.values())} looked at")
    if "--record" in sys.argv and not any(found):
        RECORD.write_text("".join(f"{key}\n" for key in sorted(keys.values())))
    sys.exit(any(found))


main()
