#!/usr/bin/env python3
"""Hertz in three dimensions: a ball on a flat from STEP, the error against the element size and the time for three kinds of
elements, crossed cylinders."""
import math
import os
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from wear_case import ROOT, WORK, figure, run, write_csv, write_measured  # noqa: E402
from hexahedra import write_hertz_blocks  # noqa: E402

E_STAR = 210e3 / (2.0 * (1.0 - 0.3 ** 2))
R, P = 50.0, 4 * 770.0                                   # the scene is a quarter
A = (3.0 * P * R / (4.0 * E_STAR)) ** (1.0 / 3.0)
P0 = 1.5 * P / (math.pi * A * A)

STATIC = [("increments = 8\n\n[[step]]                                     # what slides", "increments = 1\n\n#[[step]]"),
          ('name = "pulse"\nplay = ["pulse"]\nincrements = 8\ncycles = 1', "#"), ("friction  = 0.3", "friction  = 0.0"),
          (', { force_N = 385.0, history = "pulse" }', ""), ("pulse = [[0.0, 0.0], [0.5, 1.0], [1.0, 0.0]]", "")]
STEP = [('["ball_on_flat.geo"]', f'["ball.step", "{ROOT}/geo/ball_on_flat/flat.step"]'),
        ("flat_contact = {", 'ball_sx = { body = "ball", box_mm = [-0.1, -0.1, -0.1, 0.1, 50.1, 50.1] }\n'
         'ball_sy = { body = "ball", box_mm = [-0.1, -0.1, -0.1, 50.1, 0.1, 50.1] }\n'
         'ball_top = { body = "ball", box_mm = [-0.1, -0.1, 49.9, 50.1, 50.1, 50.1] }\n'
         'flat_sx = { body = "flat", box_mm = [-0.1, -0.1, -50.1, 0.1, 50.1, 0.1] }\n'
         'flat_sy = { body = "flat", box_mm = [-0.1, -0.1, -50.1, 50.1, 0.1, 0.1] }\n'
         'flat_bottom = { body = "flat", box_mm = [-0.1, -0.1, -50.1, 50.1, 50.1, -49.9] }\nflat_contact = {')]


def exact(r):
    return P0 * math.sqrt(max(0.0, 1.0 - (r / A) ** 2))


def fitted(rows, most=0.9):
    """p0 and a of a straight line through p^2 over r^2 at r < most a."""
    points = [(r["x_mm"] ** 2 + r["y_mm"] ** 2, r["pressure_MPa"] ** 2) for r in rows]
    points = [(x, y) for x, y in points if x < (most * A) ** 2]
    n, mx, my = len(points), sum(x for x, _ in points) / len(points), sum(y for _, y in points) / len(points)
    slope = sum((x - mx) * (y - my) for x, y in points) / sum((x - mx) ** 2 for x, _ in points)
    start = my - slope * mx
    return math.sqrt(start), math.sqrt(-start / slope)


def l2(rows):
    total = sum(r["area_mm2"] * (r["pressure_MPa"] - exact(math.hypot(r["x_mm"], r["y_mm"]))) ** 2 for r in rows)
    return math.sqrt(total / sum(r["area_mm2"] * exact(math.hypot(r["x_mm"], r["y_mm"])) ** 2 for r in rows))


def sized(elements, order):
    text = f"size_mm = {1.0 / elements:.6g} }}"
    words = [("radius_mm = 1.4, size_mm = 0.12 }", "radius_mm = 1.3, " + text)]
    if order == 1:
        words.append(("mesh     = { far_size_mm = 6.0 }", "mesh     = { far_size_mm = 6.0 }\norder = 1"))
    return words


def tetrahedra(order, elements):
    return run("ball_on_flat", f"tet_{order}_{elements}", STATIC + STEP + sized(elements, order))


def hexahedra(elements):
    file = WORK / f"hex_{elements}.msh"
    WORK.mkdir(parents=True, exist_ok=True)
    write_hertz_blocks(file, 1.0 / elements, 1.25 * A, R, 16.0)
    return run("ball_on_flat", f"hex_{elements}", STATIC + sized(elements, 2) + [
        ('["ball_on_flat.geo"]', f'["{os.path.relpath(file, ROOT / "geo" / "ball_on_flat")}"]'),
        ('ball_contact = { body = "ball", type = "sphere" }\n', ""),
        ('flat_contact = { body = "flat", box_mm = [-0.1, -0.1, -0.1, 50.1, 50.1, 0.1] }', "")])


def study(measured):
    table = []
    for name, one in (("tet4", lambda n: tetrahedra(1, n)), ("tet10", lambda n: tetrahedra(2, n)), ("hex8", hexahedra)):
        for elements in (4, 6, 10):
            result = one(elements)
            rows = result.last("secondary")
            p0, a = fitted(rows)
            s = result.summary
            table.append([name, elements, s["size"]["dofs"], l2(rows), p0 / P0 - 1.0, a / A - 1.0, s["cpu_s"],
                          s["counts"]["newton_iterations"]])
            measured[f"{name}_{elements}_l2"] = table[-1][3]
            if elements == 10:
                measured[f"{name}_10_p0_error"], measured[f"{name}_10_radius_error"] = table[-1][4], table[-1][5]
                measured[f"{name}_10_balance"] = s["balance"]
    write_csv("study.csv", ["element", "elements_per_radius", "dofs", "l2_error", "p0_error", "radius_error", "cpu_s", "newton"],
              table)


def elliptic(m):
    """K(m) and E(m), m = e^2, by the arithmetic-geometric mean."""
    a, b, c, total, power = 1.0, math.sqrt(1.0 - m), math.sqrt(m), 0.0, 0.5
    for _ in range(12):
        total += power * c * c
        a, b, c, power = 0.5 * (a + b), math.sqrt(a * b), 0.5 * (a - b), 2.0 * power
    K = math.pi / (2.0 * a)
    return K, K * (1.0 - total)


def hertz_ellipse(force, low, high):
    """Half axes a >= b for separation low x^2 + high y^2 (Johnson, Contact Mechanics, section 4.2)."""
    lo, hi = 1e-9, 1.0 - 1e-9
    for _ in range(200):
        m = 0.5 * (lo + hi)
        K, E = elliptic(m)
        ratio = (E / (1.0 - m) - K) / (K - E)
        lo, hi = (m, hi) if ratio < high / low else (lo, m)
    a = (3.0 * force * (K - E) / (2.0 * math.pi * E_STAR * m * low)) ** (1.0 / 3.0)
    return a, a * math.sqrt(1.0 - m)


def ellipse_fit(rows):
    """p^2 = c0 + c1 x^2 + c2 y^2 by least squares where p is above 0.4 of its largest: half axes along x and y, p0."""
    most = max(r["pressure_MPa"] for r in rows)
    eqs = [((1.0, r["x_mm"] ** 2, r["y_mm"] ** 2), r["pressure_MPa"] ** 2) for r in rows if r["pressure_MPa"] > 0.4 * most]
    M = [[sum(u[i] * u[k] for u, _ in eqs) for k in range(3)] + [sum(u[i] * v for u, v in eqs)] for i in range(3)]
    for i in range(3):
        for k in range(3):
            if k != i:
                f = M[k][i] / M[i][i]
                M[k] = [x - f * y for x, y in zip(M[k], M[i])]
    c = [M[i][3] / M[i][i] for i in range(3)]
    return math.sqrt(-c[0] / c[1]), math.sqrt(-c[0] / c[2]), math.sqrt(c[0])


def crossed(measured):
    result = run("crossed_cylinders", "crossed", [("friction  = 0.2", "friction  = 0.0")])
    rows = result.last("secondary")
    x, y, p0 = ellipse_fit(rows)
    force = 4.0 * result.contact["normal_force_N"]
    a, b = hertz_ellipse(force, 1.0 / 80.0, 1.0 / 40.0)   # R = 40 along y, R = 20 along x
    long, short = max(x, y), min(x, y)
    measured["crossed_long_half_axis_error"] = long / a - 1.0
    measured["crossed_short_half_axis_error"] = short / b - 1.0
    measured["crossed_p0_error"] = p0 / (1.5 * force / (math.pi * a * b)) - 1.0


def main():
    measured = {}
    study(measured)
    crossed(measured)
    write_measured(measured)
    figure("set logscale xy\nset format y '%.0e'\nset key top left notitle\nset multiplot layout 1,2\nset xlabel 'elements per radius'\n"
           "set ylabel 'L2 error of the pressure'\n"
           "plot '<grep tet4 study.csv' using 2:4 with linespoints pt 7 title 'tet4', "
           "'<grep tet10 study.csv' using 2:4 with linespoints pt 5 title 'tet10', "
           "'<grep hex8 study.csv' using 2:4 with linespoints pt 9 title 'hex8'\n"
           "set xlabel 'CPU time [s]'\n"
           "plot '<grep tet4 study.csv' using 7:4 with linespoints pt 7 title 'tet4', "
           "'<grep tet10 study.csv' using 7:4 with linespoints pt 5 title 'tet10', "
           "'<grep hex8 study.csv' using 7:4 with linespoints pt 9 title 'hex8'\nunset multiplot\n")


if __name__ == "__main__":
    main()
