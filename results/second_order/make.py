#!/usr/bin/env python3
"""Hertz at a low load and Cattaneo-Mindlin (references B1, B2) with first and second order, linear and quadratic
multipliers: error against h and against run time."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import contact_case as cc  # noqa: E402
from mesh_case import A, C, LOW_A, LOW_P0, MU, ONLY_LOADING, P0, SECOND  # noqa: E402
from wear_case import figure, half_width, run, write_csv, write_measured  # noqa: E402

INTERVALS = (10, 20, 40, 80)      # between neighbouring nodes across the contact; a facet of order 2 spans two
KINDS = {"linear": [], "quadratic": [SECOND],
         "quadratic_linear_dual": [SECOND, ('secondary = "face"', 'secondary = "face"\ndual = "linear"')]}


def played(scene, kind, intervals, shift, half, old_size, words):
    """A run and the rows of the nodes that carry multipliers; nodes 2 half / intervals apart."""
    size = 2.0 * half / intervals * (1 if kind == "linear" else 2)
    done = run(scene, f"{scene}_{kind}_{intervals}_{shift}", cc.zone(old_size, size, shift * size / cc.SHIFTS) + words + KINDS[kind])
    rows = done.last("secondary")
    return done, rows[::2] if kind == "quadratic_linear_dual" else rows


def hertz(kind, intervals, shift):
    """Relative errors of one mesh at one position: L2, inner, half width; seconds of CPU."""
    done, rows = played("hertz_halfplane", kind, intervals, shift, LOW_A, "0.010", [("increments = 5", "increments = 1")])
    points = cc.profile(rows, "pressure_MPa")
    def exact(x):
        return cc.hertz(x, LOW_A, LOW_P0)
    l2 = cc.l2_error(points, exact) / (LOW_P0 * (4.0 * LOW_A / 3.0) ** 0.5)
    inner = cc.largest_error(points, exact, 0.8 * LOW_A) / LOW_P0
    return l2, inner, half_width([(x, p * p) for x, p in points if p > 0.0]) / LOW_A - 1.0, done.summary["cpu_s"]


def cattaneo_mindlin(kind, intervals, shift):
    """The same of the shear at Q = mu P / 2 and of the stick half width."""
    done, rows = played("cattaneo_mindlin", kind, intervals, shift, A, "0.0045", ONLY_LOADING)
    points = cc.profile(rows, "shear_MPa")
    def exact(x):
        return cc.mindlin(x, A, C, MU * P0)
    l2 = cc.l2_error(points, exact) / (MU * P0 * (4.0 * A / 3.0) ** 0.5)
    inner = cc.largest_error(points, exact, 0.8 * C) / (MU * P0)
    return l2, inner, done.contact["stick_half_width_mm"] / C - 1.0, done.summary["cpu_s"]


def study(case, half, measured):
    """Means over the positions per kind and mesh, the median of the time."""
    table = []
    for kind in KINDS:
        means = []
        for intervals in INTERVALS:
            errors = [case(kind, intervals, k) for k in range(cc.SHIFTS)]
            means.append([2.0 * half / intervals] + [cc.mean_square([e[i] for e in errors]) for i in (0, 1, 2)]
                         + [sorted(e[3] for e in errors)[len(errors) // 2]])
            table.append([kind, *means[-1]])
        name = f"{case.__name__}_{kind}"
        measured[f"{name}_l2_slope"] = cc.slope([(m[0], m[1]) for m in means])
        for key, value in zip(("l2", "inner", "width", "cpu_s"), means[-1][1:]):
            measured[f"{name}_{key}_80"] = value
    write_csv(f"{case.__name__}.csv", ["kind", "h_mm", "l2_error", "inner_error", "width_error", "cpu_s"], table)


def plots(name, half, title):
    lines = ", ".join(f"'< grep ^{k}, {name}.csv' using {{x}}:{{y}} with linespoints title '{k.replace('_', ', ')}'" for k in KINDS)
    text = f"set title '{title}'\nset ylabel 'L2 error'\nset xlabel 'distance of nodes / a'\nset key top left notitle\n"
    text += "plot " + lines.format(x=f"($2/{half})", y=3) + "\n"
    return text + "set xlabel 'seconds of CPU'\nset key bottom left\nplot " + lines.format(x=6, y=3) + "\n"


def main():
    measured = {}
    study(hertz, LOW_A, measured)
    study(cattaneo_mindlin, A, measured)
    write_measured(measured)
    figure("set terminal svg size 720,840 dynamic background '#ffffff'\nset multiplot layout 2,2\nset logscale xy\nset format y '%.0e'\n"
           + plots("hertz", LOW_A, "Hertz, pressure") + plots("cattaneo_mindlin", A, "Cattaneo-Mindlin, shear") + "unset multiplot\n")


if __name__ == "__main__":
    main()
