#!/usr/bin/env python3
"""Hertz at a low load (references B1) with first and second order, linear and quadratic multipliers: error and time."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import contact_case as cc  # noqa: E402
from wear_case import figure, half_width, run, write_csv, write_measured  # noqa: E402

LOW_A, LOW_P0 = 0.2, 109.89011    # p0 / E* = 1e-3
INTERVALS = (10, 20, 40, 80)      # between neighbouring nodes across the contact; a facet of order 2 spans two
KINDS = {"linear": [], "quadratic": [('material = "steel"', 'material = "steel"\norder = 2')],
         "quadratic_linear_dual": [('material = "steel"', 'material = "steel"\norder = 2'),
                                   ('secondary = "face"', 'secondary = "face"\ndual = "linear"')]}


def one(kind, intervals, shift):
    """Errors of one mesh at one position: h between nodes, L2, inner, half width, all relative; seconds of CPU."""
    size = 2.0 * LOW_A / intervals * (1 if kind == "linear" else 2)
    done = run("hertz_halfplane", f"{kind}_{intervals}_{shift}",
               cc.zone("0.010", size, shift * size / cc.SHIFTS) + [("increments = 5", "increments = 1")] + KINDS[kind])
    rows = done.last("secondary")
    if kind == "quadratic_linear_dual":
        rows = rows[::2]   # mid nodes carry no multiplier
    points = cc.profile(rows, "pressure_MPa")
    def exact(x):
        return cc.hertz(x, LOW_A, LOW_P0)
    l2 = cc.l2_error(points, exact) / (LOW_P0 * (4.0 * LOW_A / 3.0) ** 0.5)
    inner = cc.largest_error(points, exact, 0.8 * LOW_A) / LOW_P0
    return 2.0 * LOW_A / intervals, l2, inner, half_width([(x, p * p) for x, p in points if p > 0.0]) / LOW_A - 1.0, done.summary["cpu_s"]


def main():
    measured, table = {}, []
    for kind in KINDS:
        means = []
        for intervals in INTERVALS:
            errors = [one(kind, intervals, k) for k in range(cc.SHIFTS)]
            means.append([errors[0][0]] + [cc.mean_square([e[i] for e in errors]) for i in (1, 2, 3)]
                         + [sorted(e[4] for e in errors)[len(errors) // 2]])
            table.append([kind, *means[-1]])
        measured[f"{kind}_l2_slope"] = cc.slope([(m[0], m[1]) for m in means])
        measured[f"{kind}_l2_80"], measured[f"{kind}_inner_80"] = means[-1][1], means[-1][2]
        measured[f"{kind}_half_width_80"] = means[-1][3]
    write_csv("study.csv", ["kind", "h_mm", "l2_error", "inner_error", "half_width_error", "cpu_s"], table)
    write_measured(measured)
    lines = ", ".join(f"'< grep ^{k}, study.csv' using {{x}}:3 with linespoints title '{k.replace('_', ', ')}'" for k in KINDS)
    figure("set multiplot layout 1,2\nset logscale xy\nset format y '%.0e'\nset ylabel 'L2 error of p'\nset key top left notitle\n"
           "set xlabel 'distance of nodes / a'\nplot " + lines.replace("{x}", f"($2/{LOW_A})") +
           "\nset xlabel 'seconds of CPU'\nset key bottom left\nplot " + lines.replace("{x}", "6") + "\nunset multiplot\n")


if __name__ == "__main__":
    main()
