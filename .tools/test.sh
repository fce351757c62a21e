#!/usr/bin/env bash
# The checks that a change needs before it is shown: npm test. With `rest`, those that take longer:
# npm run check. With names, only those: format lint types architecture native wasm unit parity browser
# browser_first browser_rest firefox python package doors tidy cppcheck sanitize fuzz sanitize_all wasm_all. sanitize runs
# the unit and regression tests under ASan and UBSan, sanitize_all (half an hour) all of them; so do wasm and
# wasm_all as WebAssembly. The last line counts.
set -uo pipefail
cd "$(dirname "$0")/.."
bash .tools/setup.sh || exit 1

jobs=${PLANISH_JOBS:-$(nproc)}
logs=build/test-logs
mkdir -p "$logs"
passed=0
failed=0
failures=()

sources() { git ls-files --cached --others --exclude-standard '*.cpp' '*.hpp'; }

ready() { # preset target
  [ -e "build/$1/build.ninja" ] || cmake --preset "$1" --log-level=WARNING || return 1
  cmake --build --preset "$1" --target "$2" -j "$jobs"
}

# GoogleTest's program, its tests dealt out to as many processes as there are cores.
in_shards() { # command
  local pids=() status=0 shard
  for ((shard = 0; shard < jobs; shard++)); do
    GTEST_TOTAL_SHARDS=$jobs GTEST_SHARD_INDEX=$shard "$@" &
    pids+=($!)
  done
  for pid in "${pids[@]}"; do wait "$pid" || status=1; done
  return "$status"
}

check_format() { sources | xargs clang-format --dry-run -Werror; }
check_lint() { npx --no-install biome ci --reporter=summary; }
check_types() {
  npx --no-install tsc -p web/tsconfig.json && npx --no-install tsc -p wasm/package/tsconfig.json --noEmit
}
check_architecture() { python3 .tools/check-architecture.py && python3 .tools/check-web-layers.py; }
check_native() { ready native planish && ready native planish_tests && ctest --preset native -j "$jobs"; }
# Surveys of many edits have nothing in them but the solver, whose bits `parity` and the recipes compare with
# the native build's: wasm_all has them, too.
run_wasm() { # suite
  ready wasm planish_wasm && ready wasm planish_whole_wasm && ready wasm "$1" &&
    python3 .tools/wasm-loads.py &&
    in_shards node --no-experimental-fetch "build/wasm/tests/$1.cjs"
}
check_wasm() { run_wasm planish_quick_tests; }
check_wasm_all() { run_wasm planish_tests; }
check_unit() {
  bash .tools/build.sh wasm && npx --no-install vitest run --config web/vitest.config.ts --dir tests/web
}
check_parity() {
  bash .tools/build.sh native wasm && npx --no-install vitest run --config web/vitest.config.ts --dir tests/parity
}
# What everybody does with the page; the other browser files are for `rest`.
browser_first=(first-minute dragging exploring saving share links)
# A page keeps one core busy for most of its time: two run beside each other, the longest files first.
in_browser() { # files, or options of vitest
  bash .tools/build.sh wasm site &&
    npx --no-install vitest run --config web/vitest.config.ts --dir tests/browser \
      --fileParallelism --maxWorkers=$((jobs < 2 ? 1 : 2)) "$@"
}
check_browser() { in_browser; }
check_browser_first() { in_browser "${browser_first[@]/%/.test.ts}"; }
check_browser_rest() {
  local others=()
  for name in "${browser_first[@]}"; do others+=(--exclude "**/$name.test.ts"); done
  in_browser "${others[@]}"
}
# A second engine. It draws only on a screen, even one that nobody looks at.
check_firefox() {
  bash .tools/setup.sh firefox && bash .tools/build.sh wasm site &&
    xvfb-run -a -s "-screen 0 1500x1000x24" \
      npx --no-install vitest run --config web/vitest.config.ts --dir tests/firefox
}
# The packed npm package in a project of its own.
check_package() {
  bash .tools/build.sh native wasm npm &&
    npx --no-install vitest run --config web/vitest.config.ts --dir tests/package
}
# The wheel as whoever installs it has it, in an environment with nothing else but numpy.
install_wheel() {
  ready native planish && ready native planish_python && bash .tools/build.sh catalogue || return 1
  local place=build/python
  rm -rf "$place" && mkdir -p "$place"
  /usr/bin/python3 -m build --wheel --no-isolation --outdir "$place" python >"$place/wheel.log" 2>&1 ||
    { cat "$place/wheel.log"; return 1; }
  /usr/bin/python3 -m venv --system-site-packages --without-pip "$place/venv" &&
    /usr/bin/python3 -m pip --python "$place/venv/bin/python" install --quiet --no-index --no-deps "$place"/*.whl
}
check_python() {
  install_wheel && build/python/venv/bin/python -m unittest discover --start-directory tests/python
}
# One set of recipes through all of them, and what leads from one to another.
check_doors() {
  install_wheel && bash .tools/build.sh wasm npm site &&
    npx --no-install vitest run --config web/vitest.config.ts --dir tests/doors
}
check_tidy() { python3 .tools/tidy.py; }
check_cppcheck() { bash .tools/cppcheck.sh; }
check_fuzz() { bash .tools/fuzz.sh; }
check_sanitize() {
  ready sanitize planish_quick_tests && in_shards build/sanitize/tests/planish_quick_tests --gtest_brief=1
}
check_sanitize_all() { ready sanitize planish_tests && ctest --preset sanitize -j "$jobs"; }

# How many tests a log speaks of: "passed failed"; a check without tests counts as one.
count() { # log status
  python3 - "$1" "$2" <<'PY'
import re, sys
text = re.sub(r"\x1b\[[0-9;]*m", "", open(sys.argv[1], errors="replace").read())
status = int(sys.argv[2])
good = bad = 0
if m := re.search(r"(\d+) tests? failed out of (\d+)", text):  # ctest
    bad = int(m[1]); good = int(m[2]) - bad
elif m := re.findall(r"\[  PASSED  \] (\d+) test", text):  # GoogleTest, one or more shards
    good = sum(map(int, m))
    bad = sum(map(int, re.findall(r"\[  FAILED  \] (\d+) test", text)))
elif m := re.search(r"^Ran (\d+) tests", text, re.M):  # unittest
    bad = sum(map(int, re.findall(r"(?:failures|errors)=(\d+)", text))); good = int(m[1]) - bad
elif m := re.findall(r"Tests +(?:(\d+) failed)?[ |]*(?:(\d+) passed)? .*\(\d+\)\s", text):  # vitest
    bad = sum(int(f or 0) for f, _ in m); good = sum(int(p or 0) for _, p in m)
if status == 0: good, bad = max(good, 1), 0
else: bad = max(bad, 1)
print(good, bad)
PY
}

# What a failed check said: the lines that name a failure with what follows them, then its end.
explain() { # log
  local text
  text=$(sed 's/\x1b\[[0-9;]*m//g' "$1") # vitest colours what it names
  grep -nE -A 8 'Failure$|FAILED|\*\*\*|RuntimeError|Aborted|error:|^ *FAIL ' <<<"$text" | head -n 80
  echo "..."
  tail -n 20 <<<"$text"
}

run() { # name
  local log="$logs/$1.log" start=$SECONDS status=0
  "check_$1" >"$log" 2>&1 || status=$?
  local good bad
  read -r good bad < <(count "$log" "$status")
  passed=$((passed + good))
  failed=$((failed + bad))
  if [ "$status" -eq 0 ]; then
    printf '  ok    %-13s %4d passed  %4d s\n' "$1" "$good" $((SECONDS - start))
  else
    failures+=("$1")
    printf '  FAIL  %-13s %4d failed  %4d s   %s\n' "$1" "$bad" $((SECONDS - start)) "$log"
    explain "$log" | sed 's/^/        /'
  fi
}

checks=("$@")
if [ ${#checks[@]} -eq 0 ]; then
  checks=(format lint types architecture native unit parity browser_first)
elif [ "$*" = rest ]; then
  checks=(wasm python package doors browser_rest firefox tidy cppcheck sanitize fuzz)
fi
for check in "${checks[@]}"; do run "$check"; done
echo
[ ${#failures[@]} -eq 0 ] || echo "Failed: ${failures[*]}"
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
