#!/usr/bin/env python3
"""Time of a block and memory over the number of dofs, at some 240 contact nodes a side (reye-bench)."""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from wear_case import benchmarks, figure, write_csv, write_measured  # noqa: E402

COLUMNS = ("dofs", "block_s", "peak_kB_per_dof")


def rows_of(benchmark, depths):
    """One process each: the largest memory is that of the whole program."""
    return [[run[c] for c in COLUMNS] for depth in depths for run in benchmarks(f"^{benchmark}/{depth}/")]


def slope(a, b):
    return math.log(b[1] / a[1]) / math.log(b[0] / a[0])


def line(rows, exponent):
    return f"{rows[0][1]:.6g}*(x/{rows[0][0]:.6g})**{exponent}"


def main():
    linear = rows_of("scaling", (4, 20, 60, 200))
    plastic = rows_of("scaling_plastic", (4, 20))
    write_csv("scaling.csv", COLUMNS, linear)
    write_csv("plastic.csv", COLUMNS, plastic)
    write_measured({"steepest_slope_of_block_time": max(map(slope, linear, linear[1:])),
                    "slope_of_block_time_over_all": slope(linear[0], linear[-1]),
                    "largest_dofs": linear[-1][0],
                    "kB_per_dof_at_the_largest": linear[-1][2],
                    "plastic_slope_of_block_time_over_all": slope(plastic[0], plastic[-1]),
                    "plastic_kB_per_dof_at_the_largest": plastic[-1][2]})
    figure("set logscale xy\nset key top left\nset xlabel 'dofs'\nset ylabel 'CPU of a block, s'\n"
           "plot 'scaling.csv' using 1:2 skip 1 with linespoints lw 2 pt 7 title 'linear, 40 increments', "
           "'plastic.csv' using 1:2 skip 1 with linespoints lw 2 pt 5 title 'plastic at small strain, 8 increments', "
           f"{line(linear, 1.3)} dashtype 2 lc rgb '#888888' title 'dofs^{{1.3}}', "
           f"{line(plastic, 1.3)} dashtype 2 lc rgb '#888888' notitle\n")


if __name__ == "__main__":
    main()
