#!/usr/bin/env bash
# Fuzzes the readers: 20 s each, --long 600 s each, or PLANISH_FUZZ_SECONDS. With names, only those:
# obj off ply glb. What is learnt is kept in build/fuzz/corpus, a finding in build/fuzz/findings.
set -euo pipefail
cd "$(dirname "$0")/.."

seconds=${PLANISH_FUZZ_SECONDS:-20}
formats=()
for word in "$@"; do
  case $word in
    --long) seconds=${PLANISH_FUZZ_SECONDS:-600} ;;
    obj | off | ply | glb) formats+=("$word") ;;
    *) echo "fuzz: unknown word '$word' (--long, obj, off, ply, glb)" >&2 && exit 2 ;;
  esac
done
[ ${#formats[@]} -gt 0 ] || formats=(obj off ply glb)

[ -e build/fuzz/build.ninja ] || cmake --preset fuzz --log-level=WARNING
cmake --build --preset fuzz -j "${PLANISH_JOBS:-2}" | grep -v '^\[' || [ "${PIPESTATUS[0]}" -eq 0 ]

failed=0
for format in "${formats[@]}"; do
  corpus=build/fuzz/corpus/$format findings=build/fuzz/findings/$format- log=build/fuzz/$format.log
  mkdir -p "$corpus" build/fuzz/findings
  # -timeout: a refusal takes 2 s at most; the limits are for the whole process, in MB.
  if nice -n 19 "build/fuzz/fuzz_$format" "$corpus" "build/fuzz/seeds/$format" \
    -dict="tests/fuzz/dictionaries/$format.dict" -artifact_prefix="$findings" \
    -max_total_time="$seconds" -max_len=16384 -timeout=2 -rss_limit_mb=1024 -malloc_limit_mb=256 \
    -print_final_stats=1 >"$log" 2>&1; then
    runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
    echo "fuzz: $format: $runs inputs, no finding"
  else
    echo "fuzz: $format: a finding, see $log" >&2
    grep -m 3 -E 'broken promise|ERROR:|runtime error:|bytes held|read again' "$log" >&2 || true
    failed=1
  fi
done
exit "$failed"
