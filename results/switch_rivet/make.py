#!/usr/bin/env python3
"""A contact rivet that yields and frets: blocks chosen by an error beside blocks of one size."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from wear_case import figure, run, write_csv, write_measured  # noqa: E402

SCENE, AS_WRITTEN = "switch_rivet", "jump = { tolerance = 0.01 }"
TOLERANCES, SIZES = (0.03, 0.01, 0.002), (500, 150, 50)  # the least tolerance is the reference


def depths(done):
    """Largest depths of both sides and their life [um, um, cycles]."""
    sides = [1e3 * done.contact[side]["max_depth_mm"] for side in ("secondary", "primary")]
    return [*sides, done.summary["life_cycles"]["life"]]


runs = {f"by {tolerance}": run(SCENE, f"by_{tolerance}", [(AS_WRITTEN, f"jump = {{ tolerance = {tolerance} }}")])
        for tolerance in TOLERANCES}
runs |= {f"blocks of {size}": run(SCENE, f"blocks_of_{size}", [(AS_WRITTEN, f"jump = {size}")]) for size in SIZES}
reference = depths(runs["by 0.002"])
rows, measured = [], {}
for name, done in runs.items():
    off = [found / exact - 1.0 for found, exact in zip(depths(done), reference)]
    counts, cpu = done.summary["counts"], done.summary["cpu_s"]
    rows.append((name, counts["cycles_solved"], cpu, *depths(done), *off, max(map(abs, off))))
    key = name.replace(" ", "_")
    measured[f"{key}_cycles_solved"] = counts["cycles_solved"]
    if name != "by 0.002":
        measured[f"{key}_off"] = rows[-1][-1]
    print(*rows[-1], flush=True)
by_tolerance, fixed = runs["by 0.01"], runs["blocks of 50"]
measured |= {
    "time_over_blocks_of_50": by_tolerance.summary["cpu_s"] / fixed.summary["cpu_s"],
    "life_cycles": by_tolerance.summary["life_cycles"]["life"],
    "newton_per_increment": by_tolerance.summary["counts"]["newton_iterations"] / by_tolerance.summary["counts"]["increments"],
    "cutbacks": sum(done.summary["counts"]["cutbacks"] for done in runs.values()),
    "ledger": max(done.contact["ledger_relative_error"] for done in runs.values())}
write_csv("runs.csv", ["jump", "cycles_solved", "cpu_s", "depth_secondary_um", "depth_primary_um", "life_cycles",
                       "depth_secondary_off", "depth_primary_off", "life_off", "largest_off"], rows)
write_measured(measured)
figure("set logscale xy\nset xlabel 'CPU time [s]'\nset ylabel 'largest error of depths and life'\nset key top right\n"
       "plot '< grep ^by runs.csv | head -2' using 3:10 with linespoints pt 7 title 'blocks chosen by 3 and 1 %', "
       "'< grep ^blocks runs.csv' using 3:10 with linespoints pt 5 title 'blocks of 500, 150 and 50 cycles'\n")
