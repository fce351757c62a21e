#!/usr/bin/env bash
# clang-tidy over the core and the session, one process per core. A file that passed before with the
# same headers, rules and clang-tidy is skipped; what passed is remembered outside the tree, so that the
# next clone on this machine need not ask again.
set -euo pipefail
cd "$(dirname "$0")/.."
# File by file, so that each is also seen to include what it needs.
database=build/tidy/database
cmake --preset native -B "$database" -DPLANISH_UNITY=OFF --log-level=WARNING >/dev/null

known=${XDG_CACHE_HOME:-$HOME/.cache}/planish/tidy
mkdir -p "$known"
find "$known" -type f -mtime +30 -delete
around=$( (clang-tidy --version; dpkg-query -W libeigen3-dev libstdc++-12-dev 2>/dev/null
  cat .clang-tidy CMakeLists.txt core/CMakeLists.txt $(git ls-files 'core/**/*.hpp' 'wasm/*.hpp')) | sha256sum)

tidy_one() {
  local key complaints
  key=$( (echo "$around" "$1"; cat "$1") | sha256sum | cut -d ' ' -f 1)
  [ -e "$known/$key" ] && touch "$known/$key" && return 0
  if complaints=$(clang-tidy -p "$database" --quiet --warnings-as-errors='*' "$1" 2>&1); then
    touch "$known/$key"
  else
    echo "$complaints" >&2
    return 1
  fi
}
export -f tidy_one
export known around database

git ls-files 'core/src/**/*.cpp' 'core/src/*.cpp' 'wasm/session*.cpp' |
  sort -u | xargs -P "${PLANISH_JOBS:-$(nproc)}" -I{} bash -c 'tidy_one {}'
