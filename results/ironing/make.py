#!/usr/bin/env python3
"""Ironing (references C6): onset, and reactions over the long stroke with linear and quadratic elements and multipliers."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from wear_case import figure, run, write_csv, write_measured  # noqa: E402

STROKE = 8.0
SECOND_ORDER = [('kinematics = "finite"', 'kinematics = "finite"\norder      = 2')]


def bends(values):
    """Largest |v_i - (v_(i-1) + v_(i+1)) / 2| over |v_i| where the die is fully in."""
    return max(abs(values[i] - 0.5 * (values[i - 1] + values[i + 1])) / abs(values[i]) for i in range(15, 75))


def main():
    measured, columns = {}, {}
    for name, words in (("linear", []), ("quadratic", SECOND_ORDER)):
        done = run("ironing", name, words)
        rows = done.history
        fx, fy = ([row[f"die_force_{c}_N_per_mm"] for row in rows] for c in "xy")
        measured[f"{name}_increments"] = done.summary["counts"]["increments"]
        measured[f"{name}_cutbacks"] = done.summary["counts"]["cutbacks"]
        measured[f"{name}_jump_x"], measured[f"{name}_jump_y"] = bends(fx), bends(fy)
        columns[name] = (fx, fy)
        if name == "linear":
            first = [row for row in done.frames("secondary") if any(r["pressure_MPa"] > 0.0 for r in row[1])][0][1]
            loaded = [row for row in first if row["pressure_MPa"] > 0.0]
            measured["onset_nodes"] = len(loaded)
            measured["onset_pressure"] = loaded[0]["pressure_MPa"]
            measured["onset_friction"] = abs(loaded[0]["shear_MPa"]) / loaded[0]["pressure_MPa"]
            progress = [row["progress"] for row in rows]
    write_csv("reactions.csv", ["x_mm", "linear_x_N_per_mm", "linear_y_N_per_mm", "quadratic_x_N_per_mm", "quadratic_y_N_per_mm"],
              [[STROKE * t, *(columns[name][c][i] for name in columns for c in (0, 1))] for i, t in enumerate(progress)])
    write_measured(measured)
    figure("set xlabel 'stroke [mm]'\nset ylabel 'force on the die [N/mm]'\nset key center right notitle\nset title 'ironing'\n"
           "plot 'reactions.csv' skip 1 using 1:(-$3) with lines lw 2 title 'linear, pressing', "
           "'' skip 1 using 1:2 with lines lw 2 title 'drawing', "
           "'' skip 1 using 1:(-$5) with lines dt 2 lw 2 title 'quadratic, pressing', "
           "'' skip 1 using 1:4 with lines dt 2 lw 2 title 'drawing'\n")


if __name__ == "__main__":
    main()
