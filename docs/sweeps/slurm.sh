#!/usr/bin/env bash
# A sweep as a Slurm array, one part a task: sbatch --array=1-100 slurm.sh PLAN.json DIR.
# DIR is on a disk that all nodes see. Submitted again, it does what is missing; afterwards
# planish gather DIR -o results.csv
#SBATCH --job-name=planish-sweep
#SBATCH --cpus-per-task=1
#SBATCH --requeue
set -euo pipefail
planish sweep "$1" --part "$((SLURM_ARRAY_TASK_ID - SLURM_ARRAY_TASK_MIN + 1))/$SLURM_ARRAY_TASK_COUNT" -o "$2"
