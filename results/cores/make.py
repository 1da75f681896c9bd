#!/usr/bin/env python3
"""Wall time on one core and on two: a solid, a wear block of 1e6 dofs, and bodies that yield (reye-bench)."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from wear_case import benchmarks, figure, write_csv, write_measured  # noqa: E402

CASES = {"cores_ball": "ball", "cores_block": "block", "cores_plastic": "plastic"}


def main():
    rows, measured = [], {}
    for benchmark, name in CASES.items():
        [run] = benchmarks(f"^{benchmark}/")
        rows.append((name, *(run[c] for c in ("dofs", "one_core_s", "two_cores_s", "times_faster"))))
        measured[f"{name}_times_faster"] = run["times_faster"]
        if "change_of_energy" in run:
            measured[f"{name}_change_of_energy"] = run["change_of_energy"]
    write_csv("cores.csv", ["case", "dofs", "one_core_s", "two_cores_s", "times_faster"], rows)
    write_measured(measured)
    figure("set style data histogram\nset style fill solid 0.6\nset ylabel 'wall time, s'\nset logscale y\nset key top right\n"
           "plot 'cores.csv' using 3:xtic(1) skip 1 title 'one core', '' using 4 skip 1 title 'two cores'\n")


if __name__ == "__main__":
    main()
