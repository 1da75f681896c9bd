#!/usr/bin/env python3
"""Residuals of every Newton iteration of four scenes, from the library (its verification test writes them)."""
import csv
import math
import os
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from wear_case import figure, program, write_csv, write_measured  # noqa: E402


def rows_of(name):
    with open(f"{name}.csv", newline="", encoding="utf-8") as file:
        return [{k: v if k == "step" else float(v) for k, v in row.items()} for row in csv.DictReader(file)]


def worse(row):
    return max(row["force"], row["condition"])


def tails(rows):
    """(r, next r) of iterations with settled active set and r between 1e-5 and 1e-2."""
    return [(worse(a), max(worse(b), 1e-13)) for a, b in zip(rows, rows[1:])
            if b["iteration"] == a["iteration"] + 1 and a["changes"] == 0 == b["changes"] and 1e-5 < worse(a) < 1e-2]


def main():
    subprocess.run([program("test_verification"), "--gtest_filter=ContactNewton.*", "--gtest_brief=1"], check=True,
                   env=dict(os.environ, REYE_NEWTON=str(pathlib.Path.cwd())))
    measured, pairs = {}, []
    for name in ("hertz", "cattaneo_mindlin"):
        rows = rows_of(name)
        found = tails(rows)
        orders = [math.log(b) / math.log(a) for a, b in found]
        measured[f"{name}_smallest_order"] = min(orders)
        measured[f"{name}_most_iterations"] = max(r["iteration"] for r in rows)
        pairs += [[name, a, b] for a, b in found]
    for name in ("ironing", "pressed_ring_plastic"):   # a row is a renewal of the nonlinear bodies
        rows = rows_of(name)
        found = tails(rows)
        orders = sorted(math.log(b) / math.log(a) for a, b in found)
        measured[f"{name}_median_order"] = orders[len(orders) // 2]
        measured[f"{name}_most_iterations"] = max(r["iteration"] for r in rows)
        pairs += [[name, a, b] for a, b in found]
    write_csv("tails.csv", ["scene", "residual", "next_residual"], pairs)
    write_measured(measured)
    figure("set logscale xy\nset format '%.0e'\nset xlabel 'residual'\nset ylabel 'next residual'\nset key top left notitle\n"
           "set title 'settled active set: the next residual is the square'\n"
           "plot '< grep ^hertz tails.csv' using 2:3 pt 7 title 'Hertz', "
           "'< grep ^cattaneo tails.csv' using 2:3 pt 6 title 'Cattaneo-Mindlin', "
           "'< grep ^ironing tails.csv' using 2:3 pt 1 title 'ironing', "
           "'< grep ^pressed tails.csv' using 2:3 pt 2 title 'pressed ring, plastic', x**2 with lines lc 'black' title 'r^2'\n")


if __name__ == "__main__":
    main()
