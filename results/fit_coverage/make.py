#!/usr/bin/env python3
"""How often the 95 % intervals of `reye calibrate` hold the coefficient that made a synthetic scar (tests/slow, FitCoverage)."""
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from wear_case import program, write_csv, write_measured  # noqa: E402

COLUMNS = ("kind", "scar", "noise", "correlation", "parameter", "coverage_percent", "deviation", "error", "called_poor_percent", "refused_percent")
KINDS = ("OneProfile", "CutEnds", "FlankMissing", "TwoProfiles", "TwoSides")


def main():
    tests = program("test_slow")
    running = [subprocess.Popen([tests, f"--gtest_filter=FitCoverage.{kind}"], stdout=subprocess.PIPE, text=True) for kind in KINDS]
    rows = [line.split(",")[1:] for run in running for line in run.communicate()[0].splitlines() if line.startswith("coverage,")]
    write_csv("coverage.csv", COLUMNS, rows)
    coverage = [float(row[5]) for row in rows]
    uncut = [float(row[5]) for row in rows if row[0] not in ("cut ends", "a flank missing")]
    write_measured({"intervals": len(rows), "mean_percent": sum(coverage) / len(coverage), "least_percent": min(coverage),
                    "most_percent": max(coverage), "uncut_least_percent": min(uncut), "uncut_most_percent": max(uncut),
                    "called_poor_percent": max(float(row[8]) for row in rows)})


if __name__ == "__main__":
    main()
