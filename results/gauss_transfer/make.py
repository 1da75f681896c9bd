#!/usr/bin/env python3
"""Plastic state from mesh to mesh by each choice: error against h, and what a hundred transfers leave (reye-bench)."""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from wear_case import benchmarks, figure, write_csv, write_measured  # noqa: E402

ERROR = ("way", "cells", "n", "error")
DECAY = ("way", "cells", "front", "times", "peak", "integral", "error", "least")


def rows(runs, name, columns):
    return [[*run["label"].split(), *(run[c] for c in columns[2:])] for run in runs if run["name"].startswith(name)]


def main():
    runs = benchmarks("^gauss_")
    error, decay = rows(runs, "gauss_error", ERROR), rows(runs, "gauss_decay", DECAY)
    write_csv("error.csv", ERROR, error)
    write_csv("decay.csv", DECAY, decay)
    write_csv("time.csv", ("way", "cells", "ms_per_1e4_cells"),
              [[*run["label"].split(), run["real_time"]] for run in runs if run["name"].startswith("gauss_time")])
    measured = {}
    for way, cells in {(row[0], row[1]) for row in error}:
        by_n = {row[2]: row[3] for row in error if row[:2] == [way, cells]}
        measured[f"order_{way}_{cells}"] = math.log2(by_n[16] / by_n[64]) / 2
        for row in decay:
            if row[:2] == [way, cells] and row[3] == 100:
                what = f"{'front' if row[2] else 'bell'}_{way}_{cells}"
                measured |= {f"peak_{what}": row[4], f"integral_{what}": row[5], f"least_{what}": row[7]}
    write_measured(measured)
    figure("""set logscale xy 2
set xlabel 'cells across the square'
set ylabel 'relative L2 error of one transfer'
set key bottom left
file = 'error.csv'
plot for [way in 'nearest patch l2'] for [cells in 'tri3 quad4'] file \\
     using 3:((strcol(1) eq way && strcol(2) eq cells) ? $4 : NaN) with linespoints title way.' '.cells
""")


if __name__ == "__main__":
    main()
