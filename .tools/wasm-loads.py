#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Looks for the instruction that LLVM 14 misplaces: a load into both lanes of a vector, which may
come after a later store to the same place (wasm/shim/emmintrin.h). Reads the objects of build/wasm."""
import pathlib, re, subprocess, sys

# What they load comes in by a const reference and nothing there stores to it.
HARMLESS = (
    r"planish::edit_weights\(",
    r"planish::hessian\(planish::(CircleEquation|CornerShape) const&",
    r"PackageWriter::write\(",
)

root = pathlib.Path(__file__).resolve().parent.parent / "build" / "wasm"
objects = sorted(o for part in ("core", "wasm") for o in (root / part).rglob("*.o"))
if not objects:
    sys.exit("wasm-loads: no objects under build/wasm; build first")
found = set()
for path in objects:
    text = subprocess.run(["llvm-objdump-14", "-dC", path], capture_output=True, text=True, check=True).stdout
    function = ""
    for line in text.splitlines():
        if named := re.match(r"[0-9a-f]+ <(.*)>:$", line):
            function = named[1]
        elif "v128.load64_splat" in line and not any(re.search(h, function) for h in HARMLESS):
            found.add(f"{path.relative_to(root)}: {function}")
for place in sorted(found):
    print(f"{place} loads a number into both lanes; see wasm/shim/emmintrin.h", file=sys.stderr)
sys.exit(1 if found else 0)
