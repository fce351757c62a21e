#!/usr/bin/env bash
# clang-tidy over the core and the session, one process per core. A file whose preprocessed-by-hash
# inputs have not changed since it last passed is skipped.
set -euo pipefail
cd "$(dirname "$0")/.."
# File by file, so that each is also seen to include what it needs.
database=build/tidy/database
cmake --preset native -B "$database" -DPLANISH_UNITY=OFF --log-level=WARNING >/dev/null

stamps=build/tidy
mkdir -p "$stamps"
headers=$(cat .clang-tidy $(git ls-files 'core/**/*.hpp' 'wasm/*.hpp') | sha256sum)

tidy_one() {
  local stamp
  stamp="$stamps/$(echo "$1" | tr / _).ok"
  local now
  now=$( (echo "$headers"; cat "$1") | sha256sum)
  [ -e "$stamp" ] && [ "$(cat "$stamp")" = "$now" ] && return 0
  if clang-tidy -p "$database" --quiet --warnings-as-errors='*' "$1" 2>"$stamp.err"; then
    echo "$now" >"$stamp"
  else
    cat "$stamp.err" >&2
    return 1
  fi
}
export -f tidy_one
export stamps headers database

git ls-files 'core/src/**/*.cpp' 'core/src/*.cpp' 'wasm/session*.cpp' |
  sort -u | xargs -P "${PLANISH_JOBS:-$(nproc)}" -I{} bash -c 'tidy_one {}'
