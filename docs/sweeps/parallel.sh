#!/usr/bin/env bash
# A sweep with GNU parallel: parallel.sh PLAN.json DIR. Run again, it does what is missing.
set -euo pipefail
planish sweep "$1" --list | cut -f1 | parallel --halt soon,fail=1 planish sweep "$1" --job {} -o "$2"
planish gather "$2" -o "$2/results.csv"
