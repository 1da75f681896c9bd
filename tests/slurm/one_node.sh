#!/usr/bin/env bash
# A sweep through Slurm must give the table it gives here: 32 members, byte by byte but for times and memory.
#
#   bash tests/slurm/one_node.sh build/bin/reye
#
# Ends with 77 (skipped) where there is no Slurm.
set -euo pipefail
reye=$(realpath "$1")
scenes=$(realpath "$(dirname "$0")")/..

source "$scenes/slurm/cluster.sh"

cp -r "$scenes/../geo/life_band" "$work/scene"
sweep() { "$reye" sweep "$work/scene/scene.toml" --vary contact.pad.friction=0.6:0.9:4 \
  --vary support.holder.y.force_N_per_mm=-40:-75:8 --vary "step[1].cycles=400" "$@"; }
sweep --out "$work/here" --quiet
sweep --out "$work/slurm" --slurm --quiet
without_times() { sed -E 's/(,[^,]*){3}$//' "$1/sweep.csv"; }   # wall_s, cpu_s, peak_rss_MB
[ "$(wc -l <"$work/slurm/sweep.csv")" -eq 33 ] || { echo "not 32 members"; cat "$work/slurm/sweep.csv"; exit 1; }
cmp <(without_times "$work/here") <(without_times "$work/slurm")
echo "32 members, the same table here and through Slurm"
