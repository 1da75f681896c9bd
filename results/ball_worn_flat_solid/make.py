#!/usr/bin/env python3
"""A ball worn flat in space, and by its axisymmetric twin: depth, radius, volume, and the cap cut off a ball."""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import wear_case as case  # noqa: E402

R, VOLUME = 5.0, 3.0e-8 * 20.0 * 1e6                  # k P s of the whole ball


def cap_depth(volume):
    low, high = 0.0, R
    for _ in range(60):
        d = 0.5 * (low + high)
        low, high = (d, high) if math.pi * d * d * (R - d / 3.0) < volume else (low, d)
    return low


solid, twin = case.run("ball_worn_flat_solid", "solid"), case.run("ball_worn_flat", "twin", [("half_width_mm = 0.4", "half_width_mm = 1.6")])
worn, flat = solid.contact["secondary"], twin.contact["secondary"]
d = cap_depth(VOLUME)
a = math.sqrt(2.0 * R * d - d * d)
rows = sorted((math.hypot(r["x_mm"], r["y_mm"]), 1e3 * r["wear_depth_mm"], r["pressure_MPa"]) for r in solid.last("secondary"))
inner = [p for r, _, p in rows if r < 0.8 * a]
changes = [float(line.split("differ by ")[1].split(" %")[0]) for line in (solid.folder / "log.txt").read_text().splitlines()
           if "on the fresh mesh" in line]
case.write_measured({
    "ledger": solid.contact["ledger_relative_error"],
    "balance": solid.summary["balance"],
    "depth_over_twin": worn["max_depth_mm"] / flat["max_depth_mm"],
    "radius_over_twin": solid.contact["equivalent_radius_mm"] / flat["scar_width_mm"],
    "volume_over_twin": 4.0 * worn["worn_volume_mm3"] / flat["worn_volume_mm3"],
    "depth_over_cap": worn["max_depth_mm"] / d,
    "radius_over_cap": solid.contact["equivalent_radius_mm"] / a,
    "volume_over_k_P_s": 4.0 * worn["worn_volume_mm3"] / VOLUME,
    "mean_pressure_inside_over_even": sum(inner) / len(inner) / (20.0 / (math.pi * a * a)),
    "remeshes": solid.summary["counts"]["remeshes"],
    "pressure_change_at_remesh_percent": max(changes),
    "cutbacks": solid.summary["counts"]["cutbacks"],
    "cycles_solved": solid.summary["counts"]["cycles_solved"],
    "iterations_per_increment": solid.summary["counts"]["newton_iterations"] / solid.summary["counts"]["increments"],
})
case.write_csv("profile.csv", ["r_mm", "depth_um", "pressure_MPa"], [row for row in rows if row[0] < 1.7][::3])
case.write_csv("twin.csv", ["r_mm", "depth_um", "pressure_MPa"],
               [(r["x_mm"], 1e3 * r["wear_depth_mm"], r["pressure_MPa"]) for r in twin.last("secondary") if r["x_mm"] < 1.7 and r["y_mm"] < 0.5][::4])
case.figure(f"""
set xlabel 'distance from the axis [mm]'; set ylabel 'depth [um]'; set y2label 'pressure [MPa]'; set y2tics; set key bottom left
plot [0:1.7][0:230] 'profile.csv' every ::1 using 1:2 with points pt 7 ps 0.4 title 'depth, in space', \\
     'twin.csv' every ::1 using 1:2 with lines lc 0 title 'axisymmetric', \\
     'profile.csv' every ::1 using 1:3 axes x1y2 with points pt 6 ps 0.4 lc rgb '#e08030' title 'pressure, in space', \\
     'twin.csv' every ::1 using 1:3 axes x1y2 with lines dt 2 lc 0 title 'axisymmetric'
""")
