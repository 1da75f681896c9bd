#!/usr/bin/env python3
"""A hip cup worn over two million steps, beside a cup whose wall is a bed of springs (foundation.py)."""
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent), str(HERE)]
import foundation  # noqa: E402
import wear_case as case  # noqa: E402

STEPS = 2.0e6

run = case.run("hip_cup_solid", "base")
contact = run.contact
worn, counts = contact["secondary"], run.summary["counts"]
beds, cup = foundation.walked(STEPS)
loaded = next(r for r in run.history if r["step"] == "stand" and r["joint_normal_force_N"] == max(
    q["joint_normal_force_N"] for q in run.history if q["step"] == "stand"))
last = run.last("secondary")
ends = [r for r in run.history if r["step"] == "walk" and abs(r["progress"] - 1.0) < 1e-9]
bed_depth = case.Line([(c, d) for c, d, _ in beds])
measured = {
    "ledger": contact["ledger_relative_error"],
    "balance": run.summary["balance"],
    "peak_pressure_at_3_kN_MPa": loaded["joint_pressure_max_MPa"],
    "peak_pressure_over_foundation": loaded["joint_pressure_max_MPa"] / max(foundation.Cup().pressures(foundation.FORCE)),
    "worn_volume_mm3": worn["worn_volume_mm3"],
    "worn_volume_over_foundation": worn["worn_volume_mm3"] / beds[-1][2],
    "worn_volume_over_way_at_the_pole": worn["worn_volume_mm3"] / foundation.way_at_the_pole(STEPS),
    "depth_over_foundation": worn["max_depth_mm"] / beds[-1][1],
    "depth_before_over_foundation": ends[-1]["joint_depth_max_secondary_mm"] / beds[-1][1],
    "largest_force_sideways_N": max(abs(r["stem_force_y_N"]) for r in run.history),
    "life_steps": run.summary["life_cycles"]["allowed"],
    "cycles_solved": counts["cycles_solved"],
    "remeshes": counts["remeshes"],
    "cutbacks_over_increments": counts["cutbacks"] / counts["increments"],
}
case.write_measured(measured)
case.write_csv("depth.csv", ["step", "depth_mm", "pressure_MPa", "foundation_depth_mm"],
               [(r["cycle"], r["joint_depth_max_secondary_mm"], r["joint_pressure_max_MPa"], bed_depth(min(r["cycle"], 0.999999 * STEPS)))
                for r in ends])
case.write_csv("profile.csv", ["cut", "mm", "depth_mm"],
               [(name, *p) for name, along, across in (("x", "x_mm", "y_mm"), ("y", "y_mm", "x_mm"))
                for p in sorted((r[along], r["wear_depth_mm"]) for r in last if abs(r[across]) < 0.5 and r["z_mm"] < -2.0)]
               + sorted(("springs", n[0] * foundation.R, w) for (n, _), w in zip(cup.cells, cup.depth) if abs(n[1]) < 0.1 * abs(n[0])))
case.figure("""
set multiplot layout 2,1
set xlabel 'million steps'; set ylabel 'depth [mm]'; set key bottom right
plot [0:2][0:0.18] 'depth.csv' every ::1 using ($1/1e6):2 with points pt 7 ps 0.6 title 'Reye', \
     'depth.csv' every ::1 using ($1/1e6):4 with lines lc 0 title 'cup of springs'
set xlabel 'forward x, sideways y [mm]'; set ylabel 'depth at the end [mm]'; set key bottom center
plot [-14:14][0:0.18] "< grep '^x' profile.csv" using 2:3 with points pt 7 ps 0.5 title 'along x', \
     "< grep '^y' profile.csv" using 2:3 with points pt 6 ps 0.5 title 'along y', \
     "< grep '^springs' profile.csv" using 2:3 with lines lc 0 title 'cup of springs, along x'
unset multiplot
""")
