#!/usr/bin/env python3
"""What `reye plan` says of time and increments against what `reye run` takes, one after the other on the same machine."""
import os
import pathlib
import re
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from wear_case import ROOT, WORK, write_csv, write_measured  # noqa: E402

SCENES = ("fretting_mccoll", "measured_load", "coating", "hinge", "block_on_ring", "ball_worn_flat", "rubber_pin_wear",
          "plastic_fretting", "partial_slip_life", "spectrum", "line_contact_gross_slip", "pin_worn_flat",
          "fretting_mccoll_tolerance", "spinning_shaft")
UNITS = {"s": 1.0, "min": 60.0, "h": 3600.0}


def planned(scene):
    """Seconds and increments, as the command prints them."""
    text = subprocess.run([os.environ["REYE"], "plan", scene, "--threads", "1"], capture_output=True, text=True, check=True).stdout
    number, unit = re.search(r"^time: about ([\d.]+) (\w+)", text, re.M).groups()
    increments = re.search(r"cycles, (\d+) increments$", text, re.M).group(1)
    return float(number) * UNITS[unit], float(increments)


def taken(scene, name):
    import json
    start = time.monotonic()
    subprocess.run([os.environ["REYE"], "run", scene, "--out", WORK / name, "--threads", "1", "--force", "--quiet"], check=True,
                   stdout=subprocess.DEVNULL)
    seconds = time.monotonic() - start
    return seconds, json.loads((WORK / name / "summary.json").read_text())["counts"]["increments"]


def main():
    os.environ |= {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
    WORK.mkdir(parents=True, exist_ok=True)
    rows, worst = [], 1.0
    for name in SCENES:
        scene = str(ROOT / "geo" / name / "scene.toml")
        said, increments = planned(scene)
        seconds, solved = taken(scene, name)
        ratio = said / seconds
        worst = max(worst, ratio, 1.0 / ratio)
        rows.append([name, said, round(seconds, 2), round(ratio, 2), increments, solved])
        print(*rows[-1], flush=True)
    write_csv("forecast.csv", ["scene", "planned_s", "taken_s", "ratio", "planned_increments", "increments"], rows)
    write_measured({"scenes": len(rows), "worst_factor": worst,
                    "within_a_factor_of_two": sum(0.5 <= row[3] <= 2.0 for row in rows)})


if __name__ == "__main__":
    main()
