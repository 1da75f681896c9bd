#!/usr/bin/env python3
"""What geo/fretting_mccoll takes, in CPU seconds on one core and in plain factorisations of its own stiffness."""
import os
import pathlib
import statistics
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from wear_case import benchmarks, run, write_csv, write_measured  # noqa: E402

REPEATS = 5
SCENES = {"fixed_blocks": "fretting_mccoll", "by_tolerance": "fretting_mccoll_tolerance"}


def main():
    os.environ |= {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
    seconds, factorisation, rooms = {name: [] for name in SCENES}, [], {}
    for _ in range(REPEATS):  # in turn: the machine may be another one a minute later
        for name, scene in SCENES.items():
            summary = run(scene, name).summary
            seconds[name].append(summary["cpu_s"])
            rooms[name] = summary["room_seconds"]
        factorisation += [b["factorisation_s"] for b in benchmarks("^floor/0/")]
    one = statistics.median(factorisation)
    rows = [(name, statistics.median(values), min(values), max(values), statistics.median(values) / one) for name, values in seconds.items()]
    write_csv("run_time.csv", ("run", "cpu_s", "least", "most", "in_factorisations"), rows)
    write_csv("share.csv", ("run", "room", "share_of_wall_time"),
              [(name, room, value / sum(times.values())) for name, times in rooms.items() for room, value in times.items()])
    measured = {"factorisation_s": one}
    for name, middle, _, _, ratio in rows:
        measured |= {f"{name}_cpu_s": middle, f"{name}_in_factorisations": ratio}
    write_measured(measured)


if __name__ == "__main__":
    main()
