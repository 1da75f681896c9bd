#!/usr/bin/env python3
"""Hertz (references B1): the steel pair at 40 elements across, and the error against h at a low load on large bodies."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import contact_case as cc  # noqa: E402
from wear_case import figure, run, write_csv, write_measured  # noqa: E402

A, P0 = 0.0913360, 836.410        # B1b
LOW_A, LOW_P0 = 0.2, 109.89011    # p0 / E* = 1e-3
ACROSS = (10, 20, 40, 80)


def pair(measured):
    """B1b. The finite-body part is what stays on ever finer meshes of the same bodies."""
    runs = {k: run("hertz", f"pair_{k}", cc.zone(0.0045, 0.0045, 0.0009 * k)) for k in range(cc.SHIFTS)}
    fine = run("hertz", "pair_fine", cc.zone(0.0045, 0.001125, 0.0))
    p_limit, a_limit = cc.fitted(cc.profile(fine.last("secondary"), "pressure_MPa"), 0.8 * A)
    peaks = [r.contact["peak_pressure_MPa"] for r in runs.values()]
    widths = [r.contact["contact_half_width_mm"] for r in runs.values()]
    measured["p0_MPa"], measured["half_width_mm"] = peaks[0], widths[0]
    measured["finite_body_part_of_p0"] = p_limit / P0 - 1.0
    measured["finite_body_part_of_half_width"] = a_limit / A - 1.0
    measured["p0_error_beyond_finite_body"] = peaks[0] / p_limit - 1.0
    measured["p0_error_beyond_finite_body_worst_position"] = max(abs(p / p_limit - 1.0) for p in peaks)
    measured["half_width_error"] = widths[0] / A - 1.0
    measured["half_width_error_worst_position"] = max(abs(w / A - 1.0) for w in widths)
    points = cc.profile(runs[0].last("secondary"), "pressure_MPa")
    write_csv("profile.csv", ["x_mm", "pressure_MPa", "exact_MPa"], [[x, p, cc.hertz(x, A, P0)] for x, p in points])


def one(across, k):
    """Errors of one mesh at one position: (h, L2, inner, half width), all relative."""
    size = 2.0 * LOW_A / across
    r = run("hertz_halfplane", f"low_{across}_{k}",
            cc.zone("0.010", size, k * size / cc.SHIFTS) + [("increments = 5", "increments = 1")])
    points = cc.profile(r.last("secondary"), "pressure_MPa")
    def exact(x):
        return cc.hertz(x, LOW_A, LOW_P0)
    l2 = cc.l2_error(points, exact) / (LOW_P0 * (4.0 * LOW_A / 3.0) ** 0.5)
    inner = cc.largest_error(points, exact, 0.8 * LOW_A) / LOW_P0
    return cc.spacing(points), l2, inner, r.contact["contact_half_width_mm"] / LOW_A - 1.0


def study(measured):
    table, means = [], []
    for across in ACROSS:
        errors = [one(across, k) for k in range(cc.SHIFTS)]
        table += [[across, k, *e] for k, e in enumerate(errors)]
        h = errors[0][0]
        means.append([h] + [cc.mean_square([e[i] for e in errors]) for i in (1, 2, 3)])
        if across == 40:
            measured["low_load_inner_error_40_worst_position"] = max(e[2] for e in errors)
            measured["low_load_half_width_error_40_worst_position"] = max(abs(e[3]) for e in errors)
    measured["low_load_l2_slope"] = cc.slope([(m[0], m[1]) for m in means])
    measured["low_load_half_width_slope"] = cc.slope([(m[0], m[3]) for m in means])
    write_csv("study.csv", ["elements_across", "position", "h_mm", "l2_error", "inner_error", "half_width_error"], table)
    write_csv("study_mean.csv", ["h_mm", "l2_error", "inner_error", "half_width_error"], means)


def main():
    measured = {}
    pair(measured)
    study(measured)
    write_measured(measured)
    figure("set multiplot layout 1,2\nset xlabel 'x [mm]'\nset ylabel 'p [MPa]'\nset key bottom center notitle\n"
           "set title 'R = 6 mm, 120 N/mm'\n"
           "plot 'profile.csv' skip 1 using 1:3 with lines lc 'black' title 'exact', '' skip 1 using 1:2 pt 7 ps 0.4 title 'run'\n"
           "set logscale xy\nset format y '%.0e'\nset xlabel 'h / a'\nset ylabel 'relative error'\nset key top left\n"
           "set title 'low load, mean over five positions'\n"
           f"plot 'study_mean.csv' skip 1 using ($1/{LOW_A}):2 with linespoints pt 7 title 'L2(p)', "
           f"'' skip 1 using ($1/{LOW_A}):3 with linespoints pt 5 title 'p, |x| < 0.8 a', "
           f"'' skip 1 using ($1/{LOW_A}):4 with linespoints pt 9 title 'half width', 0.1*x with lines dt 2 lc 'black' title 'h'\n"
           "unset multiplot\n")


if __name__ == "__main__":
    main()
