#!/usr/bin/env python3
"""A ball fretting on a flat for 18 000 cycles at 1 %: depth, volume and life against elements 1.5 times as large and against
half the tolerance; and with ten elements per radius of the worn contact, whose time is measured."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import wear_case as case  # noqa: E402

ALPHA = {"secondary": 1.9e-8, "primary": 2.9e-8}      # mm3/mJ
ORDER_TWO = 1.5**2 - 1.0                              # what the step from 1.5 h to h holds of the error of h

base = case.run("ball_on_flat_fretting", "base")
larger = case.run("ball_on_flat_fretting", "larger", [("size_mm = 0.3 ", "size_mm = 0.45 "), ("far_size_mm = 8.0", "far_size_mm = 12.0")])
finer = case.run("ball_on_flat_fretting", "finer", [("size_mm = 0.3 ", "size_mm = 0.21 ")])
closer = case.run("ball_on_flat_fretting", "closer", [("tolerance = 0.01", "tolerance = 0.005")])


def off(run, key):
    """The larger difference of both sides from the base, relative."""
    return max(abs(run.contact[side][key] / base.contact[side][key] - 1.0) for side in ALPHA)


life, life_error = base.summary["life_cycles"]["allowed"], base.summary["estimated_error"]["life_cycles"]["allowed"]
energy = base.contact["dissipated_energy_mJ"]
counts = base.summary["counts"]
case.write_measured({
    "ledger": base.contact["ledger_relative_error"],
    "balance": base.summary["balance"],
    "worn_volume_over_alpha_E": max(abs(base.contact[side]["worn_volume_mm3"] / (a * energy) - 1.0) for side, a in ALPHA.items()),
    "depth_error_of_the_mesh": off(larger, "max_depth_mm") / ORDER_TWO,
    "volume_error_of_the_mesh": off(larger, "worn_volume_mm3") / ORDER_TWO,
    "depth_by_half_the_tolerance": off(closer, "max_depth_mm"),
    "volume_by_half_the_tolerance": off(closer, "worn_volume_mm3"),
    "life_cycles": life,
    "life_error_cycles": life_error,
    "life_by_larger_elements": abs(larger.summary["life_cycles"]["allowed"] / life - 1.0),
    "life_by_half_the_tolerance": abs(closer.summary["life_cycles"]["allowed"] / life - 1.0),
    "flat_depth_um": 1e3 * base.contact["secondary"]["max_depth_mm"],
    "ball_depth_um": 1e3 * base.contact["primary"]["max_depth_mm"],
    "depth_by_ten_elements": off(finer, "max_depth_mm"),
    "volume_by_ten_elements": off(finer, "worn_volume_mm3"),
    "ten_elements_cpu_s": finer.summary["cpu_s"],
    "cycles_solved": counts["cycles_solved"],
    "cutbacks": counts["cutbacks"],
    "iterations_per_increment": counts["newton_iterations"] / counts["increments"],
})


def ends(run):
    """(cycle, depth of the flat, depth of the ball) at the ends of blocks, in um."""
    rows = [r for r in run.history if r["step"] == "fretting" and abs(r["progress"] - 1.0) < 1e-9]
    return sorted((r["cycle"], 1e3 * r["pad_depth_max_secondary_mm"], 1e3 * r["pad_depth_max_primary_mm"]) for r in rows)


runs = {"base": base, "larger": larger, "closer": closer}
case.write_csv("depth.csv", ["run", "cycle", "flat_um", "ball_um"], [(name, *row) for name, run in runs.items() for row in ends(run)])
case.write_csv("profile.csv", ["run", "x_mm", "flat_um"],
               [(name, r["x_mm"], 1e3 * r["wear_depth_mm"]) for name, run in runs.items()
                for r in sorted(run.last("secondary"), key=lambda r: r["x_mm"]) if r["y_mm"] < 1e-6 and abs(r["x_mm"]) < 2.6])
case.figure("""
set multiplot layout 2,1
set xlabel 'cycle'; set ylabel 'depth [um]'; set key bottom right
plot [0:18000][0:] "< grep '^base' depth.csv" using 2:3 with linespoints pt 7 ps 0.5 title 'flat', \\
     "< grep '^base' depth.csv" using 2:4 with linespoints pt 7 ps 0.5 lc rgb '#e08030' title 'ball', \\
     "< grep '^larger' depth.csv" using 2:3 with points pt 6 lc 0 title 'elements 1.5 times as large', \\
     "< grep '^larger' depth.csv" using 2:4 with points pt 6 lc 0 notitle, \\
     "< grep '^closer' depth.csv" using 2:3 with points pt 2 lc 0 title 'half the tolerance', \\
     "< grep '^closer' depth.csv" using 2:4 with points pt 2 lc 0 notitle
set xlabel 'x [mm]'; set ylabel 'depth of the flat [um]'; set key bottom right
plot [-2.6:2.6][17:-1] "< grep '^base' profile.csv" using 2:3 with lines lw 2 title 'base', \\
     "< grep '^larger' profile.csv" using 2:3 with points pt 6 ps 0.7 lc 0 title 'elements 1.5 times as large', \\
     "< grep '^closer' profile.csv" using 2:3 with points pt 2 ps 0.5 lc 0 title 'half the tolerance'
unset multiplot
""")
