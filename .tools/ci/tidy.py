#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""clang-tidy over the core and the session, a folder at a time, because most of the time goes into
Eigen's headers. At every commit it looks at what changed since .tools/ci/tidy-passed.txt was recorded: each
source in its unit, each header in one unit that includes it. What a changed header means for the other
units is nightly's (--all --record): a header that most units include would else ask about all of them for
each of the commits that follow. --record asks about everything, and writes the record where nothing is found.

A unit that passed before on this machine, with the same text of all that it includes, rules and clang-tidy,
is skipped, but not by --all. PLANISH_JOBS or CORES: how many at once."""

import concurrent.futures
import hashlib
import json
import os
import pathlib
import shlex
import subprocess
import sys
import time

TREE = pathlib.Path(__file__).resolve().parents[2]
MOST = 15
DATABASE = TREE / "build/tidy/database"
UNITS = TREE / "build/tidy/units"
KNOWN = pathlib.Path(os.environ.get("XDG_CACHE_HOME", pathlib.Path.home() / ".cache")) / "planish/tidy"
RECORD = TREE / ".tools/ci/tidy-passed.txt"
RULES = ".clang-tidy"
PACKAGES = ["libeigen3-dev", "libstdc++-12-dev"]
JOBS = int(os.environ.get("CORES") or os.environ.get("PLANISH_JOBS") or os.cpu_count() or 1)


def said(*command):
    return subprocess.run(command, cwd=TREE, stdout=subprocess.PIPE, text=True, check=True).stdout


def sources():
    """Files by folder, as the build takes them together: names without linkage are unique in a folder. A large
    folder is dealt out to parts of equal size."""
    listed = said("git", "ls-files", "core/src/*.cpp", "wasm/session*.cpp", "wasm/keep_out_lines.cpp").split()
    for folder in sorted({os.path.dirname(file) for file in listed}):
        files = sorted(file for file in listed if os.path.dirname(file) == folder)
        parts = -(-len(files) // MOST)
        for part in range(parts):
            name = folder.replace("/", "_") + (f"_{part}" if parts > 1 else "")
            yield name, files[part * len(files) // parts : (part + 1) * len(files) // parts]


def write_units():
    """One file that includes those of a unit, with how it is compiled: as the first of them. Gives the files
    that each unit is made of."""
    subprocess.run(["cmake", "--preset", "native", "-B", DATABASE, "-DPLANISH_UNITY=OFF", "--log-level=WARNING"],
                   cwd=TREE, check=True, stdout=subprocess.DEVNULL)
    commands = {entry["file"]: entry for entry in json.loads((DATABASE / "compile_commands.json").read_text())}
    UNITS.mkdir(parents=True, exist_ok=True)
    entries, units = [], {}
    for name, files in sources():
        unit = str(UNITS / f"{name}.cpp")
        lines = [f'#include "{TREE / file}"  // NOLINT(bugprone-suspicious-include)\n' for file in files]
        pathlib.Path(unit).write_text("".join(lines))
        entry = commands[str(TREE / files[0])]
        entries.append({**entry, "file": unit, "command": entry["command"].replace(entry["file"], unit)})
        units[unit] = files
    (UNITS / "compile_commands.json").write_text(json.dumps(entries))
    return units, {entry["file"]: entry["command"] for entry in entries}


def digest(*texts):
    return hashlib.sha256(b"".join(texts)).hexdigest()


def conditions():
    """What the answer depends on beside the text and the checks: how it is compiled, the versions."""
    texts = [(TREE / name).read_bytes() for name in ["CMakeLists.txt", "core/CMakeLists.txt"]]
    return b"".join([said("dpkg-query", "-W", "clang-tidy-14", *PACKAGES).encode(), *texts])


def included(command, unit):
    """The files of the tree that a unit reads."""
    words = shlex.split(command)
    options = [word for word in words[1:] if word.startswith(("-I", "-D", "-std"))]
    systems = [f"-isystem{after}" for word, after in zip(words, words[1:]) if word == "-isystem"]
    listed = said("clang++", "-MM", *options, *systems, unit).replace("\\\n", " ").split()
    inside = (path for path in listed[1:] if path.startswith(f"{TREE}/") and "/build/" not in path)
    return {str(pathlib.Path(path).resolve().relative_to(TREE)) for path in inside}


def recorded():
    """The texts with which all passed: path and digest. The rules count as a text of every unit."""
    lines = RECORD.read_text().splitlines() if RECORD.exists() else []
    return dict(line.split() for line in lines)


def to_look_at(units, reads, texts):
    """The units of what changed since the record, then few that read the headers which these do not."""
    before = recorded()
    changed = {path for path, text in texts.items() if before.get(path) != text}
    if RULES in changed:
        return list(units)
    chosen = [unit for unit, files in units.items() if changed & set(files)]
    left = changed.difference(*(reads[unit] for unit in chosen))
    while left:
        chosen.append(max(units, key=lambda unit: (len(left & reads[unit]), -len(reads[unit]))))
        left -= reads[chosen[-1]]
    return chosen


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


def remembered():
    """The keys of units that passed on this machine; those of long ago are forgotten."""
    KNOWN.mkdir(parents=True, exist_ok=True)
    for old in KNOWN.iterdir():
        if old.stat().st_mtime < time.time() - 30 * 86400:
            old.unlink()
    return {path.name for path in KNOWN.iterdir()}


def main():
    units, commands = write_units()
    about = conditions()
    with concurrent.futures.ThreadPoolExecutor(JOBS) as pool:
        reads = dict(zip(units, pool.map(lambda unit: included(commands[unit], unit) | {RULES}, units)))
        texts = {path: digest((TREE / path).read_bytes())[:16] for path in set().union(*reads.values())}
        every = "--all" in sys.argv or "--record" in sys.argv
        chosen = list(units) if every else to_look_at(units, reads, texts)
        keys = {unit: digest(about, *(texts[path].encode() for path in sorted(reads[unit]))) for unit in chosen}
        known = set() if "--all" in sys.argv else remembered()
        found = list(pool.map(lambda unit: complaints(unit, keys[unit], known), chosen))
    print("".join(found), end="")
    print(f"tidy: {sum(key not in known for key in keys.values())} of {len(units)} units looked at")
    if "--record" in sys.argv and not any(found):
        RECORD.write_text("".join(f"{path} {texts[path]}\n" for path in sorted(texts)))
    sys.exit(any(found))


main()
