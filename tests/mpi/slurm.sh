#!/usr/bin/env bash
# A job of Slurm in which mpirun starts two ranks must end as the run of one process does.
#
#   bash tests/mpi/slurm.sh build/bin/reye
#
# Ends with 77 (skipped) where there is no Slurm.
set -euo pipefail
reye=$(realpath "$1")
tests=$(realpath "$(dirname "$0")/..")
source "$tests/slurm/cluster.sh"

scene="$tests/../geo/sliding_ball/scene.toml"
sbatch --wait -n 2 --output "$work/job.txt" --wrap "mpirun --allow-run-as-root '$reye' plan '$scene' &&
  mpirun --allow-run-as-root '$reye' run '$scene' --out '$work/run' --quiet" || { cat "$work/job.txt"; exit 1; }
grep -q "on the largest of 2 ranks" "$work/job.txt" || { cat "$work/job.txt"; exit 1; }
grep -q '"status": "done"' "$work/run/summary.json"
echo "two ranks under Slurm"
