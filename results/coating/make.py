#!/usr/bin/env python3
"""Laws written as formulas: a coating on the confined column in closed form, and one worn through under a cylinder."""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from wear_case import figure, run, write_csv, write_measured  # noqa: E402

K = 2e5 * 0.7 / (1.3 * 0.4) / 10.0   # M / H of the column
COMPRESSION, COAT, K1, K2 = 0.01, 0.002, 2e-8, 1e-7
COATED = ("secondary_per_MPa = 1.0e-7", 'secondary_per_MPa = "depth_mm < 0.002 ? 2e-8 : 1e-7"')


def backward_euler(steps, ds):
    """Depths of the column after each implicit step; in one of them the coating gives way."""
    depths = [0.0]
    for _ in range(steps):
        w = depths[-1]
        k = K1 if w < COAT else K2
        following = (w + k * K * ds * COMPRESSION) / (1.0 + k * K * ds)
        if w < COAT < following:
            following = (COAT + K2 * (K * ds * COMPRESSION - (COAT - w) / K1)) / (1.0 + K2 * K * ds)
        depths.append(following)
    return depths


def exact_life(depth):
    """Sliding [mm] after which the column is worn by a depth beyond the coating."""
    left = lambda w: COMPRESSION - w
    return math.log(left(0.0) / left(COAT)) / (K1 * K) + math.log(left(COAT) / left(depth)) / (K2 * K)


def depths_of(result):
    """[(cycle, largest depth in um)] of the ends of blocks."""
    ends = {}
    for row in result.history:
        if row["progress"] > 0.999:
            ends[row["cycle"]] = 1e3 * row["depth_max_secondary_mm"]
    return sorted(ends.items())


def main():
    measured = {}
    column = run("column", "coated", [COATED])
    depth = [row["depth_max_secondary_mm"] for row in column.history if row["step"] == "slide"]
    expected = backward_euler(10, 100.0)[1:]
    measured["column_error"] = max(abs(a / b - 1.0) for a, b in zip(depth, expected))
    measured["column_ledger"] = column.contact["ledger_relative_error"]
    life = run("column", "coated_life", [COATED, ("imposed_sliding_mm = 1000.0", "imposed_sliding_mm = 1.0"),
                                         ("increments = 10\ncycles = 1",
                                          "cycles = 4000\njump = { tolerance = 0.01 }\n"
                                          '[limit.half]\ncontact = "foot"\ndepth_mm = 0.005')])
    measured["column_life_error"] = life.summary["life_cycles"]["half"] / exact_life(0.005) - 1.0

    chosen = run("coating", "tolerance")
    fine = run("coating", "jump_500", [("jump       = { tolerance = 0.02 }", "jump       = 500")])
    bare = run("coating", "bare", [('"depth_mm < 0.002 ? 3e-6 : 3e-5"', "3e-5")])
    through = chosen.summary["life_cycles"]["through"]
    measured["through_cycles"] = through
    measured["through_error"] = through / fine.summary["life_cycles"]["through"] - 1.0
    measured["ledger"] = chosen.contact["ledger_relative_error"]
    measured["bare_through_cycles"] = bare.summary["life_cycles"]["through"]
    for name, result in (("chosen", chosen), ("fine", fine), ("bare", bare)):
        write_csv(f"{name}.csv", ["cycle", "depth_um"], depths_of(result))
    write_measured(measured)
    figure("set xlabel 'cycles'\nset ylabel 'largest depth [um]'\nset key left top\nset xrange [0:4e5]\nset yrange [0:8]\n"
           "plot 'fine.csv' skip 1 using 1:2 with lines title 'coated, jumps of 500', "
           "'chosen.csv' skip 1 using 1:2 with points pt 7 title 'coated, tolerance 2 %', "
           "'bare.csv' skip 1 using 1:2 with lines title 'without coating', 2 with lines dashtype 2 title 'coating'\n")


if __name__ == "__main__":
    main()
