#!/usr/bin/env python3
"""A cam on a flat follower over a million strokes: what both sides wear, and how many iterations an increment takes."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import wear_case as case  # noqa: E402

LOAD, WAY, RATE, CYCLES = 100.0, 24.0, 1e-10, 1e6  # N/mm, mm a cycle, 1/MPa

run = case.run("cam_on_follower", "cam")
counts, sides = run.summary["counts"], (run.contact["secondary"], run.contact["primary"])
case.write_measured({
    "follower_area_over_k_F_s": sides[0]["worn_area_mm2"] / (RATE * LOAD * WAY * CYCLES),
    "nose_area_over_k_F_s": sides[1]["worn_area_mm2"] / (RATE * LOAD * WAY * CYCLES),
    "follower_depth_um": 1e3 * sides[0]["max_depth_mm"],
    "nose_depth_um": 1e3 * sides[1]["max_depth_mm"],
    "ledger": run.contact["ledger_relative_error"],
    "iterations_an_increment": counts["newton_iterations"] / counts["increments"],
    "cutbacks_over_increments": counts["cutbacks"] / counts["increments"],
    "cpu_s": run.summary["cpu_s"],
})
for side in ("secondary", "primary"):
    case.write_csv(f"{side}.csv", ["x_mm", "wear_um"], [(x, 1e3 * w) for x, w in case.worn_profile(run.last(side), 100.0)])
case.figure("set xlabel 'x [mm]'\nset ylabel 'worn depth after a million strokes [um]'\nset key top right\n"
            "plot 'secondary.csv' using 1:2 skip 1 with lines lw 2 title 'follower', "
            "'primary.csv' using 1:2 skip 1 with lines lw 2 title 'nose'\n")
