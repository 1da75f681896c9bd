#!/usr/bin/env python3
"""Two balls of which one wears in partial slip until nothing slips any more, against the limit (reye-bench); and how stiff
in shear a half-space of elements is."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from surface_waves import table  # noqa: E402
from wear_case import benchmarks, write_csv, write_measured  # noqa: E402

COLUMNS = ("dofs", "cycles_solved", "cutbacks", "stick_radius_over_exact", "stick_radius_error_in_elements",
           "depth_over_limit_of_own_radius", "volume_over_limit_of_own_radius", "punch_radius_over_exact",
           "depth_over_limit_of_punch_radius", "volume_over_limit_of_punch_radius", "cpu_s")


def main():
    rows, measured = [], {}
    for run in benchmarks("^worn_balls"):
        _, q, elements, *_ = run["name"].split("/")
        rows.append([int(q) / 100.0, int(elements)] + [run[c] for c in COLUMNS])
        case = f"q{q}_{elements}"
        measured[f"{case}_stick_radius_in_elements"] = abs(run["stick_radius_error_in_elements"])
        exact_in_elements = int(elements) * (1.0 - int(q) / 100.0) ** (1.0 / 3.0)
        punch = (run["punch_radius_over_exact"] - 1.0) * exact_in_elements
        measured[f"{case}_punch_radius_in_elements"] = abs(punch)
        measured[f"{case}_edge_inside_nodes_in_elements"] = run["stick_radius_error_in_elements"] - punch
        for what in ("depth", "volume"):
            for radius in ("own", "punch"):
                measured[f"{case}_{what}_{radius}_radius"] = run[f"{what}_over_limit_of_{radius}_radius"]
    write_csv("study.csv", ("q", "elements_per_radius") + COLUMNS, rows)
    waves = table()
    write_csv("surface_waves.csv", ("nodes_per_wave", "cubes", "half", "quarter"), waves)
    for length, cubes, _, quarter in waves:
        measured[f"wave_of_{length}_cubes"] = cubes
        measured[f"wave_of_{length}_quarter"] = quarter
    write_measured(measured)


if __name__ == "__main__":
    main()
