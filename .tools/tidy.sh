#!/usr/bin/env bash
# clang-tidy over the core and the session, one process per core. A file whose preprocessed-by-hash
# inputs have not changed since it last passed is skipped.
set -euo pipefail
cd "$(dirname "$0")/.."
[ -e build/native/compile_commands.json ] || cmake --preset native --log-level=WARNING

stamps=build/tidy
mkdir -p "$stamps"
headers=$(cat .clang-tidy $(git ls-files 'core/**/*.hpp' 'wasm/*.hpp') | sha256sum)

tidy_one() {
  local stamp
  stamp="$stamps/$(echo "$1" | tr / _).ok"
  local now
  now=$( (echo "$headers"; cat "$1") | sha256sum)
  [ -e "$stamp" ] && [ "$(cat "$stamp")" = "$now" ] && return 0
  if clang-tidy -p build/native --quiet --warnings-as-errors='*' "$1" 2>"$stamp.err"; then
    echo "$now" >"$stamp"
  else
    cat "$stamp.err" >&2
    return 1
  fi
}
export -f tidy_one
export stamps headers

git ls-files 'core/src/**/*.cpp' 'core/src/*.cpp' 'wasm/session*.cpp' |
  sort -u | xargs -P "${PLANISH_JOBS:-$(nproc)}" -I{} bash -c 'tidy_one {}'
