#!/usr/bin/env python3
"""Half disc on a stiff block (references C4): its corner, half width and largest pressure."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import contact_case as cc  # noqa: E402
from wear_case import figure, run, write_csv, write_measured  # noqa: E402

A, P0 = 0.6808, 9.351


def main():
    result = run("hertz_block", "block")
    points = cc.profile(result.last("secondary"), "pressure_MPa")
    write_csv("profile.csv", ["x_mm", "pressure_MPa", "exact_MPa"], [[x, p, cc.hertz(x, A, P0)] for x, p in points])
    write_measured({"corner_u_y_mm": result.summary["probes"]["corner"]["u_y_mm"],
                    "half_width_mm": result.contact["contact_half_width_mm"],
                    "p0_MPa": result.contact["peak_pressure_MPa"]})
    figure("set xlabel 'x [mm]'\nset ylabel 'p [MPa]'\nset title 'half disc on a stiff block'\nset key bottom center notitle\n"
           "plot 'profile.csv' skip 1 using 1:3 with lines lc 'black' title 'Hertz, rigid plane', '' skip 1 using 1:2 pt 7 ps 0.4 title 'run'\n")


if __name__ == "__main__":
    main()
