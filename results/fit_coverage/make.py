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
    coverage = {kind: [float(row[5]) for row in rows if (row[0] == "a flank missing") == (kind == "flank_missing")]
                for kind in ("profiles", "flank_missing")}
    measured = {"intervals": len(rows), "called_poor_percent": max(float(row[8]) for row in rows)}
    for kind, percent in coverage.items():
        measured |= {f"{kind}_mean_percent": sum(percent) / len(percent), f"{kind}_least_percent": min(percent),
                     f"{kind}_most_percent": max(percent)}
    write_measured(measured)


if __name__ == "__main__":
    main()
