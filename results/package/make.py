#!/usr/bin/env python3
"""The package on an empty Debian 12: what it brings, how long it takes, and whether its demo has the figures of the build's."""
import json
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from wear_case import REYE, ROOT, WORK, read_csv, write_measured  # noqa: E402

MISSING = 77
OF_THE_DAY = {"wall_s", "cpu_s", "peak_rss_MB", "room_seconds"}


def numbers(value):
    """Every number of a summary, by its place, but for times."""
    if isinstance(value, dict):
        return {(name, *place): number for name, inner in value.items() if name not in OF_THE_DAY for place, number in numbers(inner).items()}
    return {(): value} if isinstance(value, (int, float)) else {}


def figures(folder):
    found = numbers(json.loads((folder / "summary.json").read_text(encoding="utf-8")))
    for table in sorted(folder.glob("*.csv")):
        for i, row in enumerate(read_csv(table)):
            found |= {(table.name, i, name): float(cell) for name, cell in row.items() if cell.lstrip("-")[:1].isdigit()}
    return found


def main():
    done = subprocess.run(["bash", ROOT / "apps" / "package_test.sh", pathlib.Path(REYE).parent.parent, WORK], check=False)
    if done.returncode == MISSING:
        return write_measured("root, debootstrap and dpkg-dev are needed")
    done.check_returncode()
    scene, built = ROOT / "geo" / "fretting_demo" / "scene.toml", WORK / "built"
    subprocess.run([REYE, "run", scene, "--out", built, "--quiet", "--force"], check=True)
    reference = figures(built)
    packaged = [figures(WORK / run) for run in ("demo", "demo_python")]
    if any(run.keys() != reference.keys() for run in packaged):
        raise SystemExit("the runs have other figures")
    lines = (WORK / "figures.txt").read_text(encoding="utf-8").split("\n")
    measured = {name: float(number) for name, number in map(str.split, filter(None, lines))}
    apart = [abs(run[name] - value) / abs(value) if value else abs(run[name]) for run in packaged for name, value in reference.items()]
    return write_measured(measured | {"compared_figures": len(apart), "largest_relative_difference": max(apart)})


if __name__ == "__main__":
    main()
