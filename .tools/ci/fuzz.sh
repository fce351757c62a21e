#!/usr/bin/env bash
# Fuzzes the readers: 10 s each, with --long 12 minutes (PLANISH_FUZZ_SECONDS), or until PLANISH_FUZZ_INPUTS inputs
# each, and says how many they were. With names, only those: obj off ply glb design, and web: the page's own
# decoders of links and kept designs, 200,000 inputs each (the unit check gives them 20,000; part of --long
# without names). What is learnt is kept outside the tree, in PLANISH_FUZZ_CORPUS or ~/.cache/planish/fuzz; a
# finding in build/fuzz/findings.
set -euo pipefail
cd "$(dirname "$0")/../.."

known=(glb obj off ply design) # the slowest first
corpora=${PLANISH_FUZZ_CORPUS:-${XDG_CACHE_HOME:-$HOME/.cache}/planish/fuzz}
# The short run always starts alike, so that a finding comes back; the long one starts anew each time.
seconds=10 seed=(-seed=1)
readers=() long='' web=''
for word in "$@"; do
  case " ${known[*]} " in
    *" $word "*) readers+=("$word") && continue ;;
  esac
  [ "$word" = web ] && web=yes && continue
  [ "$word" = --long ] || { echo "fuzz: unknown word '$word' (--long, ${known[*]}, web)" >&2 && exit 2; }
  long=yes seconds=720 seed=()
done
limit=(-max_total_time="${PLANISH_FUZZ_SECONDS:-$seconds}" "${seed[@]}")
[ -z "${PLANISH_FUZZ_INPUTS:-}" ] || limit=(-runs="$PLANISH_FUZZ_INPUTS" "${seed[@]}")
[ ${#readers[@]} -gt 0 ] || [ -n "$web" ] || { readers=("${known[@]}") && web=$long; }

[ -e build/fuzz/build.ninja ] || cmake --preset fuzz --log-level=WARNING
cmake --build --preset fuzz -j "${PLANISH_JOBS:-2}" | grep -v '^\[' || [ "${PIPESTATUS[0]}" -eq 0 ]

fuzz_web() {
  PLANISH_FUZZ_INPUTS=${PLANISH_FUZZ_INPUTS:-200000} npx --no-install vitest run \
    --config web/vitest.config.ts --dir tests/web decoder-fuzz
}
fuzz() { # reader
  local corpus=$corpora/$1 findings=build/fuzz/findings/$1- log=build/fuzz/$1.log
  mkdir -p "$corpus" build/fuzz/findings
  # -timeout: wall-clock seconds for one input, on a busy machine too; the other limits are for the
  # whole process, in MB.
  if "build/fuzz/fuzz_$1" "$corpus" "build/fuzz/seeds/$1" \
    -dict="tests/fuzz/dictionaries/$1.dict" -artifact_prefix="$findings" "${limit[@]}" \
    -max_len=16384 -timeout=5 -rss_limit_mb=1024 -malloc_limit_mb=256 \
    -print_final_stats=1 >"$log" 2>&1; then
    echo "fuzz: $1: $(sed -n 's/^stat::number_of_executed_units: *//p' "$log") inputs, no finding"
  else
    echo "fuzz: $1: a finding, see $log" >&2
    grep -m 3 -E 'broken promise|ERROR:|runtime error:|bytes held|read again' "$log" >&2 || true
    return 1
  fi
}
# As many at once as there are cores.
failed=0 running=0
for reader in ${web:+web} "${readers[@]}"; do
  if [ "$running" -ge "${PLANISH_JOBS:-$(nproc)}" ]; then
    wait -n || failed=1
    running=$((running - 1))
  fi
  if [ "$reader" = web ]; then fuzz_web & else fuzz "$reader" & fi
  running=$((running + 1))
done
while [ "$running" -gt 0 ]; do
  wait -n || failed=1
  running=$((running - 1))
done
exit "$failed"
