#!/usr/bin/env python3
"""Two pressed blocks (references C5): nodal multipliers beside the published ones, and why they differ."""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from wear_case import figure, run, write_csv, write_measured  # noqa: E402

PUBLISHED = (86628.75, 101873.31, 112298.40, 112799.85)   # y = -1, -5/6, -2/3, -1/2
SHEAR = (794.326, 284.924, 69.965)                        # mu = 1, y = 0, -1/6, -1/3 (here by symmetry from y = -1)
STRAIN = 0.05 / 0.6   # both blocks together lose 0.05 of 0.6 mm
LOG = -math.log(1.0 - STRAIN) / STRAIN
STICKING = [('[material.elastic]\nE_MPa = 1.0e6', '[material.hard]\nE_MPa = 1.0e8\nnu    = 0.3\n\n[material.elastic]\nE_MPa = 1.0e4'),
            ('[body.right]\nmaterial = "elastic"', '[body.right]\nmaterial = "hard"'),
            ('primary   = ["right_left"]', 'primary   = ["right_left"]\nfriction  = 1.0')]
FINITE = [("E_MPa = ", 'law   = "hencky_cauchy"\nE_MPa = '), ('kinematics = "small"', 'kinematics = "finite"')]


def upwards(name, words):
    return sorted(run("two_blocks_dual", name, words).last("secondary"), key=lambda r: r["y_mm"])


def main():
    rows, stick = upwards("frictionless", []), upwards("sticking", STICKING)
    finite, finite_stick = upwards("finite", FINITE), upwards("finite_sticking", STICKING + FINITE)
    measured, table = {}, []
    for k, published in enumerate(PUBLISHED):
        p = rows[k]["pressure_MPa"]
        now = finite[k]["pressure_MPa"]
        table.append([rows[k]["y_mm"], p, p * LOG, published, p / published - 1.0, p * LOG / published - 1.0, now])
        measured[f"finite_gap_to_published_{k}"] = now / published - 1.0
        measured[f"gap_to_published_{k}"] = p / published - 1.0
        if k < 3:  # the fourth is the middle itself
            measured[f"shape_{k}"] = p / rows[3]["pressure_MPa"]
            measured[f"symmetry_{k}"] = p / rows[6 - k]["pressure_MPa"] - 1.0
    measured["middle_with_log_strain"] = rows[3]["pressure_MPa"] * LOG
    for k, published in enumerate(SHEAR):
        measured[f"sticking_shear_{k}"] = stick[k]["shear_MPa"]
        measured[f"finite_sticking_shear_{k}"] = finite_stick[k]["shear_MPa"]
    measured["sticking_shear_middle"] = stick[3]["shear_MPa"]
    measured["finite_sticking_shear_middle"] = finite_stick[3]["shear_MPa"]
    write_csv("multipliers.csv", ["y_mm", "small_strain_MPa", "times_log_factor_MPa", "published_MPa", "gap", "gap_with_factor",
                                "finite_MPa"], table)
    write_csv("sticking.csv", ["y_mm", "shear_MPa", "published_MPa", "finite_MPa"],
              [[stick[k]["y_mm"], stick[k]["shear_MPa"], s, finite_stick[k]["shear_MPa"]] for k, s in enumerate(SHEAR)])
    write_measured(measured)
    figure("set xlabel 'y [mm]'\nset ylabel 'multiplier [MPa]'\nset key bottom right notitle\nset title 'two pressed blocks'\n"
           "plot 'multipliers.csv' skip 1 using 1:4 with linespoints lc 'black' title 'published, log strain', "
           "'' skip 1 using 1:7 with points pt 6 ps 1.5 title 'here, finite strain', "
           "'' skip 1 using 1:2 with linespoints pt 7 title 'here, small strain', "
           "'' skip 1 using 1:3 with linespoints pt 9 dt 2 title 'here times ln(1-e)/(-e)'\n")


if __name__ == "__main__":
    main()
