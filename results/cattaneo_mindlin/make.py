#!/usr/bin/env python3
"""Cattaneo-Mindlin (references B2) in load control: loading, unloading, reversal, and the error against h."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import contact_case as cc  # noqa: E402
from wear_case import figure, run, write_csv, write_measured  # noqa: E402

A, P0, MU, P, Q = 0.0913360, 836.410, 0.6, 120.0, 36.0
C, C_UNLOADED = 0.0645843, 0.0790993
ACROSS = (10, 20, 40, 80)
STEPS = ("press", "load", "unload", "reverse")
ENDS = {"press": 10, "load": 30, "unload": 50, "reverse": 70}  # increments played by then


def exact(step, x):
    """Shear on the flat; the last load is a full reversal, the mirror image of the first."""
    loaded = cc.mindlin(x, A, C, MU * P0)
    back = cc.mindlin(x, A, C_UNLOADED, 2.0 * MU * P0)
    return {"press": 0.0, "load": loaded, "unload": loaded - back, "reverse": -loaded}[step]


def stick_width(points, status, limit):
    """Half the distance between the zeros of lines through (limit - |q|)^2 / |x - other end| at the outermost stick nodes."""
    kept = [(x, (limit(x, p) - abs(q)) ** 2) for (x, p, q), s in zip(points, status) if s == "stick"]
    low, high = kept[0][0], kept[-1][0]

    def zero(outer, inner, other):
        f1, f2 = (f / abs(x - other) for x, f in (outer, inner))
        ratio = f1 / (f2 - f1) if f2 > f1 else 2.0
        return outer[0] if ratio > 1.0 else outer[0] - ratio * (inner[0] - outer[0])
    for _ in range(30):
        low, high = zero(kept[0], kept[1], high), zero(kept[-1], kept[-2], low)
    return 0.5 * (high - low)


def unloaded_stick_width(rows, before):
    """c' from the change of shear since the reversal, which is Cattaneo-Mindlin's with twice the friction."""
    middle = cc.centroid(rows)
    points = [(r["x_mm"] - middle, r["pressure_MPa"], r["shear_MPa"] - b["shear_MPa"]) for r, b in zip(rows, before)]
    return stick_width(points, [r["status"] for r in rows], lambda _, p: 2.0 * MU * p)


def curves(measured):
    result = run("cattaneo_mindlin", "whole")
    frames = [rows for _, rows in result.frames("secondary")]
    at = {step: frames[ENDS[step]] for step in STEPS}
    table = []
    for step in STEPS[1:]:
        points = cc.profile(at[step], "shear_MPa")
        table += [[step, x / A, q, exact(step, x)] for x, q in points]
        error = cc.l2_error(points, lambda x: exact(step, x)) / (MU * P0 * (4.0 * A / 3.0) ** 0.5)
        measured[f"{step}_l2_error_of_shear"] = error
    write_csv("curves.csv", ["step", "x_over_a", "shear_MPa", "exact_MPa"], table)
    measured["unload_stick_half_width_mm"] = unloaded_stick_width(at["unload"], at["load"])
    measured["reverse_stick_half_width_mm"] = result.contact["stick_half_width_mm"]
    # What the holder feels; the contact's own tangential force is counted across its pressure, which leans by 5e-4 rad.
    measured["reverse_force_N_per_mm"] = -result.history[-1]["holder_force_x_N_per_mm"]
    measured["load_peak_shear_MPa"] = max(r["shear_MPa"] for r in at["load"])


def only_loading():
    """The scene without its last two steps."""
    return [('[[step]]\nname = "unload"\nplay = ["unload"]\nincrements = 20\n', ""),
            ('[[step]]\nname = "reverse"\nplay = ["reverse"]\nincrements = 20\n', ""),
            ("every_increment = true", "every_cycles = 1"), ("increments = 10", "increments = 5")]


def one(across, k):
    size = 2.0 * A / across * (0.0045 / (A / 20.0))
    r = run("cattaneo_mindlin", f"study_{across}_{k}", cc.zone("0.0045", size, k * size / cc.SHIFTS) + only_loading())
    points = cc.profile(r.last("secondary"), "shear_MPa")
    l2 = cc.l2_error(points, lambda x: exact("load", x)) / (MU * P0 * (4.0 * A / 3.0) ** 0.5)
    inner = cc.largest_error(points, lambda x: exact("load", x), 0.8 * C) / (MU * P0)
    return cc.spacing(points), l2, inner, r.contact["stick_half_width_mm"] / C - 1.0


def study(measured):
    table, means = [], []
    for across in ACROSS:
        errors = [one(across, k) for k in range(cc.SHIFTS)]
        table += [[across, k, *e] for k, e in enumerate(errors)]
        means.append([errors[0][0]] + [cc.mean_square([e[i] for e in errors]) for i in (1, 2, 3)])
        if across == 40:
            measured["stick_half_width_mm"] = C * (1.0 + errors[0][3])
            measured["stick_half_width_error_40_mean"] = sum(e[3] for e in errors) / len(errors)
            measured["stick_half_width_error_40_worst_position"] = max(abs(e[3]) for e in errors)
    measured["l2_slope_of_shear"] = cc.slope([(m[0], m[1]) for m in means])
    measured["stick_half_width_slope"] = cc.slope([(m[0], m[3]) for m in means])
    write_csv("study.csv", ["elements_across", "position", "h_mm", "l2_error", "inner_error", "stick_error"], table)
    write_csv("study_mean.csv", ["h_mm", "l2_error", "inner_error", "stick_error"], means)


def main():
    measured = {}
    curves(measured)
    study(measured)
    write_measured(measured)
    lines = ", ".join(f"'< grep ^{s}, curves.csv' using 2:4 with lines lc {k} notitle, "
                      f"'< grep ^{s}, curves.csv' using 2:3 pt 7 ps 0.4 lc {k} title '{t}'"
                      for k, s, t in ((1, "load", "Q = 36"), (2, "unload", "back to 0"), (3, "reverse", "Q = -36")))
    figure("set multiplot layout 1,2\nset xlabel 'x / a'\nset ylabel 'q [MPa]'\nset key top right notitle\n"
           f"set title 'shear on the flat; lines: exact'\nplot {lines}\n"
           "set logscale xy\nset format y '%.0e'\nset xlabel 'h / a'\nset ylabel 'relative error'\nset key top left\n"
           "set title 'mean over five positions'\n"
           f"plot 'study_mean.csv' skip 1 using ($1/{A}):2 with linespoints pt 7 title 'L2(q)', "
           f"'' skip 1 using ($1/{A}):4 with linespoints pt 9 title 'stick half width', 0.1*x with lines dt 2 lc 'black' title 'h'\n"
           "unset multiplot\n")


if __name__ == "__main__":
    main()
