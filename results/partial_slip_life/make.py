#!/usr/bin/env python3
"""Partial-slip fretting towards its state without further wear (references B4), for several element sizes; the edge forces of
a flat punch, pressed and sheared, on the same meshes, which show where its stick edge ends; and at Q = 0.6 mu P the depth
at equal cycles against the half-plane solution of the tests (both by reye-bench)."""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from wear_case import benchmarks, figure, run, value_at, write_csv, write_measured  # noqa: E402

A, P0, R, MU = 0.0913360, 836.410, 6.0, 0.6
C = A * math.sqrt(0.5)
LIMIT = 0.15674e-3                # largest depth of the limit [mm]
SIZES = {(1, 20): 0.009, (1, 40): 0.0045, (1, 80): 0.00225,
         (2, 20): 0.009, (2, 30): 0.006, (2, 40): 0.0045}   # order, elements across the first contact
FIRST_ORDER = [('material = "steel"\nmesh', 'material = "steel"\norder = 1\nmesh')]   # left open, the scene takes second order
STRONGER = ("force_N_per_mm = 36.0", "force_N_per_mm = 43.2")   # Q = 0.6 mu P
LAST_STEP = """[[step]]
name = "to 25 mm^3 per J"
play = ["shear"]
increments = 40
cycles = 9000
jump = { tolerance = 0.01 }
"""


def largest_depth(c):
    """Of the limit profile with stick half width c, at x^2 = (a^2 + c^2) / 2."""
    x = math.sqrt(0.5 * (A * A + c * c))
    return (A * A * math.acosh(x / c) - x * math.sqrt(x * x - c * c)) / (2.0 * R)


def edge_of_stick(rows):
    """Half the distance between the outermost stick nodes."""
    x = [r["x_mm"] for r in rows if r["status"] == "stick"]
    return 0.5 * (max(x) - min(x))


def centre(rows):
    force = sum(r["pressure_MPa"] for r in rows)
    return sum(r["x_mm"] * r["pressure_MPa"] for r in rows) / force


def edge_ratios():
    """Edge force of a sheared over that of a pressed flat punch, by order and elements across."""
    return {tuple(int(n) for n in b["name"].split("/")[1:3]): b["edge_ratio"] for b in benchmarks("^punch")}


def worn_area(rows):
    return sum(0.5 * (r["x_mm"] - q["x_mm"]) * (r["wear_depth_mm"] + q["wear_depth_mm"]) for q, r in zip(rows, rows[1:]))


def against_half_plane(measured):
    """Depth and area over those of the half-planes at Q = 0.6 mu P, alpha N = 2.5 mm^3/J."""
    exact = next(b for b in benchmarks("^half_plane/60/2500/"))
    table = []
    for order in (1, 2):
        result = run("partial_slip_life", f"stronger_order_{order}", [STRONGER, (LAST_STEP, ""), *(FIRST_ORDER if order == 1 else [])])
        rows = result.last("secondary")
        depth = max(r["wear_depth_mm"] for r in rows) / exact["depth_mm"]
        area = worn_area(rows) / exact["area_mm2"]
        table.append([order, 2.5, depth, area])
        measured[f"depth_over_half_plane_order_{order}"], measured[f"area_over_half_plane_order_{order}"] = depth, area
    write_csv("half_plane.csv", ["order", "alpha_N_mm3_per_J", "depth_over_half_plane", "area_over_half_plane"], table)


def main():
    measured, sizes, profiles, growth = {}, [], [], []
    against_half_plane(measured)
    ratios = edge_ratios()
    for (order, across), h in SIZES.items():
        result = run("partial_slip_life", f"order_{order}_across_{across}",
                     [("size_mm = 0.0045", f"size_mm = {h}"), *(FIRST_ORDER if order == 1 else [])])
        frames = result.frames("secondary")
        depth = {round(cycle, 6): max(r["wear_depth_mm"] for r in rows) for cycle, rows in frames}
        rows = frames[-1][1]
        own = edge_of_stick(rows)
        pressure = value_at(rows, "pressure_MPa", centre(rows)) / P0
        wear = [d for _, d in sorted(depth.items())]   # at the ends of blocks: inside, history.csv has what is yet to be extrapolated
        counts = result.summary["counts"]
        ratio = ratios[order, across]
        # Sticking needs ratio Q / mu <= P (1 - (c/a)^2), the part of the load that a flat punch of half width c carries.
        expected = min(C, A * math.sqrt(1.0 - 0.5 * ratio))
        sizes.append([order, across, h, ratio, expected, depth[1000.0] / LIMIT, depth[10000.0] / LIMIT, own, C, pressure,
                      counts["cycles_solved"], result.summary["estimated_error"]["cycle_jump"], result.summary["cpu_s"]])
        growth += [[order, across, cycle * 2.5e-3, d / LIMIT] for cycle, d in depth.items()]
        profiles += [[order, across, r["x_mm"], 1e3 * r["wear_depth_mm"], r["pressure_MPa"], r["status"]]
                     for r in rows if abs(r["x_mm"]) < 0.125]
        measured[f"edge_order_{order}_across_{across}"] = own / C
        measured[f"edge_ratio_order_{order}_across_{across}"] = ratio
        measured[f"depth_at_25_over_limit_order_{order}_across_{across}"] = depth[10000.0] / LIMIT
        if (order, across) == (1, 40):
            measured.update({
                "cycles_solved": counts["cycles_solved"],
                "depth_at_2.5_over_limit": depth[1000.0] / LIMIT,
                "stick_edge_error_in_elements": abs(own - C) / h,
                "pressure_in_the_middle": pressure,
                "own_stick_half_width_mm": own,
                "depth_at_25_um": 1e3 * depth[10000.0],
                "depth_at_25_over_closed_form_with_own_c": depth[10000.0] / largest_depth(own),
                "largest_drop_of_depth": max(0.0, max(a - b for a, b in zip(wear, wear[1:]))) / wear[-1],
                "cpu_s": result.summary["cpu_s"],
                "ledger": result.contact["ledger_relative_error"]})
    write_csv("sizes.csv", ["order", "across", "h_mm", "punch_edge_ratio", "expected_edge_mm", "depth_at_2.5", "depth_at_25",
                            "stick_edge_mm", "exact_c_mm", "p0_ratio", "cycles_solved", "estimate", "cpu_s"], sizes)
    write_csv("profiles.csv", ["order", "across", "x_mm", "depth_um", "pressure_MPa", "status"], profiles)
    write_csv("growth.csv", ["order", "across", "alpha_N_mm3_per_J", "depth_over_limit"], growth)
    write_measured(measured)
    lines = ", ".join(f"'< grep ^{k},{n}, profiles.csv' using 3:4 with linespoints pt 7 ps 0.4 title 'order {k}, {n} across'"
                      for k, n in SIZES if n != 20)
    figure(f"a = {A}\nc = {C}\nset samples 1000\nset xrange [-0.125:0.125]\nset yrange [0:0.4]\n"
           f"w(x) = abs(x) <= c ? 0 : (a**2 * acosh(abs(x) / c) - abs(x) * sqrt(x**2 - c**2)) / {2.0 * R} * 1e3\n"
           "set xlabel 'x [mm]'\nset ylabel 'depth [um]'\n"
           f"set title 'alpha N = 25 mm^3/J'\nplot {lines}, w(x) > 0 ? w(x) : 0 with lines lc 'black' title 'limit, half-plane'\n")


if __name__ == "__main__":
    main()
