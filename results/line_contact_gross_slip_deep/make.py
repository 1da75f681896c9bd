#!/usr/bin/env python3
"""Line contact in gross slip to S = 1000 (references B8): the contact grows tenfold, remeshed on its way."""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import remesh_case as meshes  # noqa: E402
from wear_case import contact_half_width, figure, run, value_at, write_csv, write_measured  # noqa: E402

A0, P0, R = 0.0358622, 328.409, 6.0
S_PER_CYCLE = 0.002
SCALE = 2.0 * R / A0 ** 2


def rows_of(result):
    """S, a / a0, w(0), p(0) / p0 and loaded nodes at each frame after the pressing."""
    table = []
    for (cycle, secondary), (_, primary) in zip(result.frames("secondary"), result.frames("primary")):
        if cycle == 0.0:
            continue
        depth = (value_at(secondary, "wear_depth_mm") + value_at(primary, "wear_depth_mm")) * SCALE
        table.append([cycle * S_PER_CYCLE, contact_half_width(secondary) / A0, depth,
                      value_at(secondary, "pressure_MPa") / P0, sum(r["pressure_MPa"] > 0.0 for r in secondary)])
    return table


def ripple(rows):
    """Largest |p_j - (p_(j-1) + p_(j+1)) / 2| over the mean pressure, more than 3 elements inside the contact."""
    p = [r["pressure_MPa"] for r in rows if r["pressure_MPa"] > 0.0]
    return max(abs(p[i] - 0.5 * (p[i - 1] + p[i + 1])) for i in range(4, len(p) - 4)) * len(p) / sum(p)


result = run("line_contact_gross_slip_deep", "base")
table = rows_of(result)
write_csv("curve.csv", ["S", "a_over_a0", "w0_2R_over_a0sq", "p0_ratio", "loaded_nodes"], table)
measured = {}
for S in (10.0, 100.0, 1000.0):
    row = min(table, key=lambda r: abs(r[0] - S))
    for name, value in zip(("a", "depth", "pressure"), row[1:]):
        measured[f"{name}_S_{S:g}"] = value
worn = result.contact
area = worn["secondary"]["worn_area_mm2"] + worn["primary"]["worn_area_mm2"]
measured["volume_over_exact_S_1000"] = area * 2.0 * R / A0 ** 3 / (0.5 * math.pi * 1000.0)
measured["share_of_sides"] = worn["secondary"]["worn_area_mm2"] / worn["primary"]["worn_area_mm2"]
measured["ledger"] = worn["ledger_relative_error"]
measured["ripple_S_1000"] = ripple(result.last("secondary"))
measured["remeshes"] = result.summary["counts"]["remeshes"]
measured["scaled_jacobian"] = meshes.poorest_scaled_jacobian(result)
measured["most_nodes"] = meshes.most_nodes(result)
measured["cutbacks"] = result.summary["counts"]["cutbacks"]
write_measured(measured)
write_csv("remeshes.csv", ["S", "body", "nodes_before", "nodes_after"],
          [(r["cycle"] * S_PER_CYCLE, r["body"], r["nodes_before"], r["nodes_after"]) for r in meshes.remeshes(result)])
reference = "$curve << EOD\n10,2.393,4.969,.347\n100,4.95,23.835,.1604\n1000,10.57,111.352,.0745\nEOD\n"
plots = [f"'curve.csv' skip 1 using 1:{column} with lines lc {column} title 'Reye: {title}'"
         for column, title in ((2, "a / a_0"), (3, "2 R w(0) / a_0^2"), (4, "p(0) / p_0"))]
plots += [f"$curve using 1:{column} with points pt 6 ps 1.2 lc {column} {title}"
          for column, title in ((2, "title 'half-plane solution'"), (3, "notitle"), (4, "notitle"))]
plots += ["'remeshes.csv' skip 1 using 1:(0.03) with impulses lc 0 lw 0.5 title 'remeshed'"]
figure(reference + "set logscale xy\nset xrange [8:1200]\nset key top left\nset xlabel 'S = k E^* s / a_0'\nplot "
       + ", ".join(plots) + "\n")
