#!/usr/bin/env python3
"""What condensing a solid costs in plain factorisations, and where the time of a cycle in gross slip goes (reye-bench)."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from wear_case import benchmarks, write_csv, write_measured  # noqa: E402

CONDENSING = ("dofs", "retained", "factorisation_s", "condensing_in_factorisations")
CYCLE = ("dofs", "kept_nodes", "increments", "iterations_an_increment", "cutbacks", "fall_of_errors", "balance", "factors_s",
         "mortar_s", "interface_s", "cycle_s")


def main():
    measured = {}
    rows = [[run[c] for c in CONDENSING] for run in benchmarks("^condensing_solid")]
    write_csv("condensing.csv", CONDENSING, rows)
    for row in rows:
        measured[f"condensing_at_{round(row[0], -3):.0f}_dofs"] = row[3]
    rows = []
    for run in benchmarks("^sliding_ball"):
        _, size, kind, worn, *_ = run["name"].split("/")
        name = ("ball_secondary", "flat_secondary", "rigid_ball")[int(kind)] + ("_worn" if worn == "1" else "") + f"_{size}"
        rows.append([name] + [run[c] for c in CYCLE])
        measured[f"{name}_iterations"] = run["iterations_an_increment"]
        measured[f"{name}_cutbacks"] = int(run["cutbacks"])
        measured[f"{name}_fall_of_errors"] = run["fall_of_errors"]
        measured[f"{name}_balance"] = run["balance"]
        measured[f"{name}_cycle_s"] = run["cycle_s"]
    write_csv("cycle.csv", ("ball_and_facets_um",) + CYCLE, rows)
    write_measured(measured)


if __name__ == "__main__":
    main()
