#!/usr/bin/env python3
"""Line contact in gross slip to S = 0.1, 1 and 10 (references B8), beside the universal curve."""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from wear_case import contact_half_width, figure, run, value_at, write_csv, write_measured  # noqa: E402

A0, P0, R = 0.0358622, 328.409, 6.0
S_PER_CYCLE = 0.002
SCALE = 2.0 * R / A0 ** 2


def rows_of(result):
    """S, a / a0, w(0), p(0) / p0 and worn area over its exact value (pi / 2) S at each frame after the pressing."""
    table = []
    for (cycle, secondary), (_, primary) in zip(result.frames("secondary"), result.frames("primary")):
        if cycle == 0.0:
            continue
        depth = (value_at(secondary, "wear_depth_mm") + value_at(primary, "wear_depth_mm")) * SCALE
        table.append([cycle * S_PER_CYCLE, contact_half_width(secondary) / A0, depth,
                      value_at(secondary, "pressure_MPa") / P0])
    return table


def main():
    frames = [("every_cycles = 500", "every_cycles = 100")]
    result = run("line_contact_gross_slip", "line", frames)
    table = rows_of(result)
    write_csv("curve.csv", ["S", "a_over_a0", "w0_2R_over_a0sq", "p0_ratio"], table)
    measured = {}
    for S in (0.1, 1.0, 10.0):
        row = min(table, key=lambda r: abs(r[0] - S))
        for name, value in zip(("a", "depth", "pressure"), row[1:]):
            measured[f"{name}_S_{S:g}"] = value
    worn = result.contact
    area = worn["secondary"]["worn_area_mm2"] + worn["primary"]["worn_area_mm2"]
    measured["volume_over_exact_S_10"] = area * 2.0 * R / A0 ** 3 / (0.5 * math.pi * 10.0)
    measured["share_of_sides"] = worn["secondary"]["worn_area_mm2"] / worn["primary"]["worn_area_mm2"]
    measured["ledger"] = worn["ledger_relative_error"]
    measured["cutbacks"] = result.summary["counts"]["cutbacks"]
    write_measured(measured)
    reference = "$curve << EOD\n0.1,1.063,.0984,.9681\n1,1.350,.8594,.7437\n10,2.393,4.969,.347\nEOD\n"
    plots = [f"'curve.csv' skip 1 using 1:{column} with lines lc {column} title 'Reye: {title}'"
             for column, title in ((2, "a / a_0"), (3, "2 R w(0) / a_0^2"), (4, "p(0) / p_0"))]
    plots += [f"$curve using 1:{column} with points pt 6 ps 1.2 lc {column} {title}"
              for column, title in ((2, "title 'half-plane solution'"), (3, "notitle"), (4, "notitle"))]
    figure(reference + "set logscale xy\nset xrange [0.08:12]\nset key bottom right\nset xlabel 'S = k E^* s / a_0'\nplot "
           + ", ".join(plots) + "\n")


if __name__ == "__main__":
    main()
