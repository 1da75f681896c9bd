#!/usr/bin/env python3
"""Plastic bodies pressed together and meshed anew a hundred times: what each choice leaves of their plastic strain (reye-bench)."""
import json
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from wear_case import REYE, figure, write_csv, write_measured  # noqa: E402

TIMES = 100
STATES = ("held", "released")


def main():
    told = subprocess.run([pathlib.Path(REYE).with_name("reye-bench"), "--benchmark_filter=^plastic_remesh",
                           "--benchmark_format=json"], check=True, capture_output=True, text=True).stdout
    runs = json.loads(told)["benchmarks"]
    rows, measured = [], {}
    for run in runs:
        if run.get("error_occurred"):
            raise SystemExit(f"{run['name']}: {run['error_message']}")
        way, state = run["label"], STATES[int(run["name"].split("/")[2])]
        rows.append([way, state, 0, 1.0, 1.0])
        rows += [[way, state, n, run[f"integral_{n}"], run[f"peak_{n}"]] for n in range(1, TIMES + 1)]
        measured |= {f"integral_{state}_{way}": rows[-1][3], f"peak_{state}_{way}": rows[-1][4],
                     f"start_peak_{state}_{way}": run["start_peak"]}
    write_csv("decay.csv", ["way", "state", "times", "integral", "peak"], rows)
    write_measured(measured)
    figure("""set xlabel 'meshed anew, times'
set ylabel 'integral of the plastic strain over that before'
set key top left
file = 'decay.csv'
plot for [state in 'held released'] for [way in 'nearest patch l2'] file \\
     using 3:((strcol(1) eq way && strcol(2) eq state) ? $4 : NaN) with lines lw 2 title way.', '.state
""")


if __name__ == "__main__":
    main()
