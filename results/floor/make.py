#!/usr/bin/env python3
"""What condensing and a whole wear cycle cost in plain factorisations of the same stiffness, at two sizes (reye-bench)."""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from wear_case import benchmarks, write_csv, write_measured  # noqa: E402

COLUMNS = ("dofs", "contact_nodes", "factorisation_s", "condensing_in_factorisations", "cycle_s", "cycle_in_factorisations")


def main():
    rows = [[run[c] for c in COLUMNS] for run in benchmarks("^floor")]
    write_csv("floor.csv", COLUMNS, rows)
    measured = {}
    for row in rows:
        size = f"at_{round(row[0], -3):.0f}_dofs"
        measured |= {f"condensing_{size}": row[3], f"cycle_{size}": row[5]}
    slope = math.log(rows[-1][4] / rows[0][4]) / math.log(rows[-1][0] / rows[0][0])
    write_measured(measured | {"slope_of_a_cycle_over_dofs": slope})


if __name__ == "__main__":
    main()
