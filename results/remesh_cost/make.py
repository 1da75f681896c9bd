#!/usr/bin/env python3
"""What a fresh mesh costs beside gmsh, in plain factorisations of the same stiffness, at three sizes (reye-bench)."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from wear_case import benchmarks, write_csv, write_measured  # noqa: E402

COLUMNS = ("dofs", "gmsh_s", "own_s", "factorisation_s", "own_in_factorisations")


def main():
    rows = [[run[c] for c in COLUMNS] for run in benchmarks("^remesh")]
    write_csv("cost.csv", COLUMNS, rows)
    write_measured({f"own_in_factorisations_at_{round(row[0], -3):.0f}_dofs": row[-1] for row in rows})


if __name__ == "__main__":
    main()
