#!/usr/bin/env python3
"""Two equal balls with nu = 0 under a swinging tangential force: radius of stick and work of a loop against Cattaneo's and
Mindlin's (reye-bench)."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from wear_case import benchmarks, figure, write_csv, write_measured  # noqa: E402

COLUMNS = ("dofs", "stick_radius_over_exact", "stick_radius_error_in_elements", "loop_over_exact", "iterations_an_increment",
           "cutbacks", "balance", "cycle_s")


def main():
    rows, measured = [], {}
    for run in benchmarks("^two_balls"):
        _, q, elements, *_ = run["name"].split("/")
        rows.append([int(q) / 100.0, int(elements)] + [run[c] for c in COLUMNS])
        case = f"q{q}_{elements}"
        measured[f"{case}_loop"] = run["loop_over_exact"]
        measured[f"{case}_stick_radius_in_elements"] = abs(run["stick_radius_error_in_elements"])
    write_csv("study.csv", ("q", "elements_per_radius") + COLUMNS, rows)
    measured["cutbacks"] = int(sum(row[2 + COLUMNS.index("cutbacks")] for row in rows))
    measured["balance"] = max(row[2 + COLUMNS.index("balance")] for row in rows)
    write_measured(measured)
    figure("set xlabel 'Q / (mu P)'\nset xrange [0:1]\nset multiplot layout 1,2\nset ylabel 'radius of stick / a'\n"
           "plot (1 - x)**(1.0 / 3.0) with lines lc 'black' title 'Cattaneo and Mindlin', "
           "'study.csv' using 1:($4 * (1 - $1)**(1.0 / 3.0)) every ::1 with points pt 7 title 'Reye'\n"
           "set logscale y\nset format y '%.0e'\nset ylabel 'work of a loop / (mu P K)'\nset key bottom right\n"
           "w(x) = 4.8 * (1 - (1 - x)**(5.0 / 3.0) - 5 * x / 6 * (1 + (1 - x)**(2.0 / 3.0)))\n"
           "plot [0.1:1] w(x) with lines lc 'black' title 'Cattaneo and Mindlin', "
           "'study.csv' using 1:($6 * w($1)) every ::1 with points pt 7 title 'Reye'\nunset multiplot\n")


if __name__ == "__main__":
    main()
