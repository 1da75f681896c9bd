#!/usr/bin/env python3
"""Error against run time: Hertz, Cattaneo-Mindlin (references B1, B2) and a line contact that wears in gross slip (B8), over
mesh levels, orders and, where it wears, jump tolerances and jumps of one size."""
import pathlib
import statistics
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import contact_case as cc  # noqa: E402
from mesh_case import A, A0, C, LOW_A, LOW_P0, MU, ONLY_LOADING, P0, SAME_BLOCKS, SECOND, TO_ONE  # noqa: E402
from wear_case import figure, profile_error, run, worn_profile, write_csv, write_measured  # noqa: E402

PER_HALF_WIDTH = (5, 10, 20, 40)  # intervals between nodes; an element of order 2 spans two
ORDERS = (1, 2)
SHIFTS = 3                        # positions of the mesh, a third of an element apart
TOLERANCES, JUMPS = (0.01, 0.003, 0.001, 0.0003), (250, 100, 50, 20, 10)


def played(scene, name, order, size, old_size, shift, words):
    return run(scene, name, cc.zone(old_size, size, shift * size / SHIFTS) + words + ([SECOND] if order == 2 else []))


def hertz(order, per_half_width, shift):
    """Relative L2 error of the pressure, cycles solved, seconds of CPU."""
    done = played("hertz_halfplane", f"hertz_{order}_{per_half_width}_{shift}", order, order * LOW_A / per_half_width, "0.010", shift,
                  [("increments = 5", "increments = 1")])
    points = cc.profile(done.last("secondary"), "pressure_MPa")
    error = cc.l2_error(points, lambda x: cc.hertz(x, LOW_A, LOW_P0)) / (LOW_P0 * (4.0 * LOW_A / 3.0) ** 0.5)
    return error, 0, done.summary["cpu_s"]


def cattaneo_mindlin(order, per_half_width, shift):
    """The same of the shear at Q = mu P / 2."""
    done = played("cattaneo_mindlin", f"shear_{order}_{per_half_width}_{shift}", order, order * A / per_half_width, "0.0045", shift,
                  ONLY_LOADING)
    points = cc.profile(done.last("secondary"), "shear_MPa")
    error = cc.l2_error(points, lambda x: cc.mindlin(x, A, C, MU * P0)) / (MU * P0 * (4.0 * A / 3.0) ** 0.5)
    return error, 0, done.summary["cpu_s"]


def worn(order, per_half_width, shift, name="", blocks=SAME_BLOCKS):
    """B8 to S = 1."""
    return played("line_contact_gross_slip", f"worn_{order}_{per_half_width}_{shift}{name}", order, order * A0 / per_half_width,
                  "0.0018", shift, TO_ONE + blocks)


def by_jump(kind, value):
    """The same in one step, on one mesh of order 1 with 20 elements per half width."""
    jump = f"{{ tolerance = {value}, first = 1 }}" if kind == "tolerance" else value
    return worn(1, 20, 0, f"_{kind}_{value}",
                [('cycles = 50\njump = 1\n\n[[step]]\nname = "to S = 1"\ncycles = 450\njump = 10', f"cycles = 500\njump = {jump}")])


def depth_profile(done):
    return worn_profile(done.last("secondary"))


def wear_errors(done, reference):
    """Error of the profile, cycles solved, seconds of CPU."""
    return profile_error(depth_profile(done), reference), done.summary["counts"]["cycles_solved"], done.summary["cpu_s"]


def study(name, one, measured):
    """Root mean squares of the error over the positions, the median of the time."""
    rows = []
    for order in ORDERS:
        means = []
        for n in PER_HALF_WIDTH:
            found = [one(order, n, shift) for shift in range(SHIFTS)]
            means.append((1.0 / n, cc.mean_square([f[0] for f in found])))
            rows.append((order, n, means[-1][1], found[0][1], statistics.median(f[2] for f in found)))
            measured[f"{name}_order_{order}_error_{n}"] = means[-1][1]
        measured[f"{name}_order_{order}_slope"] = cc.slope(means)
    write_csv(f"{name}.csv", ["order", "per_half_width", "error", "cycles_solved", "cpu_s"], rows)


def jumps(measured):
    """Tolerances and jumps of one size against the finest tolerance, all on one mesh."""
    exact = depth_profile(by_jump("tolerance", 0.00003))
    rows = []
    for kind, values in (("tolerance", TOLERANCES), ("jump", JUMPS)):
        for value in values:
            error, solved, cpu = wear_errors(by_jump(kind, value), exact)
            rows.append((kind, value, error, solved, cpu))
            measured[f"worn_{kind}_{value}_error"] = error
            measured[f"worn_{kind}_{value}_cycles_solved"] = solved
        measured[f"worn_{kind}_slope"] = cc.slope([(r[3], r[2]) for r in rows if r[0] == kind])
    write_csv("jumps.csv", ["blocks_by", "value", "error", "cycles_solved", "cpu_s"], rows)


def plot(file, title, label):
    lines = ", ".join(f"'< grep ^{o}, {file}' using 5:3 with linespoints pt 7 title 'order {o}'" for o in ORDERS)
    return f"set title '{title}'\nset ylabel '{label}'\nplot {lines}\n"


def main():
    measured = {}
    study("hertz", hertz, measured)
    study("cattaneo_mindlin", cattaneo_mindlin, measured)
    reference = depth_profile(worn(2, 80, 0))
    study("worn", lambda order, n, shift: wear_errors(worn(order, n, shift), reference), measured)
    jumps(measured)
    write_measured(measured)
    kinds = ", ".join(f"'< grep ^{k}, jumps.csv' using 5:3 with linespoints pt 7 title '{k}'" for k in ("tolerance", "jump"))
    figure("set terminal svg size 900,760 dynamic background '#ffffff'\nset multiplot layout 2,2\nset logscale xy\n"
           "set format y '%.0e'\nset xlabel 'seconds of CPU'\nset key top right notitle\n"
           + plot("hertz.csv", "Hertz", "L2 error of the pressure")
           + plot("cattaneo_mindlin.csv", "Cattaneo-Mindlin", "L2 error of the shear")
           + plot("worn.csv", "gross slip, worn to S = 1", "error of the worn profile, of the mesh")
           + f"set title 'the same, 20 elements per half width'\nset ylabel 'error of the worn profile, of the jump'\nplot {kinds}\n"
           "unset multiplot\n")


if __name__ == "__main__":
    main()
