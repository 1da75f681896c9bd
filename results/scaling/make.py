#!/usr/bin/env python3
"""Time of a block and memory over the number of dofs, at some 240 contact nodes a side (reye-bench)."""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from wear_case import benchmarks, figure, write_csv, write_measured  # noqa: E402

COLUMNS = ("dofs", "block_s", "peak_kB_per_dof")


def main():
    # One process each: the largest memory is that of the whole program.
    rows = [[run[c] for c in COLUMNS] for depth in (4, 20, 60, 180) for run in benchmarks(f"^scaling/{depth}/")]
    write_csv("scaling.csv", COLUMNS, rows)
    steps = [math.log(b[1] / a[1]) / math.log(b[0] / a[0]) for a, b in zip(rows, rows[1:])]
    write_measured({"steepest_slope_of_block_time": max(steps),
                    "slope_of_block_time_over_all": math.log(rows[-1][1] / rows[0][1]) / math.log(rows[-1][0] / rows[0][0]),
                    "largest_dofs": rows[-1][0],
                    "kB_per_dof_at_the_largest": rows[-1][2]})
    figure("set logscale xy\nset key top left\nset xlabel 'dofs'\nset ylabel 'CPU of a block of 40 increments, s'\n"
           "plot 'scaling.csv' using 1:2 skip 1 with linespoints lw 2 pt 7 title 'block', "
           f"{rows[0][1]:.6g}*(x/{rows[0][0]:.6g})**1.3 dashtype 2 lc rgb '#888888' title 'dofs^{{1.3}}'\n")


if __name__ == "__main__":
    main()
