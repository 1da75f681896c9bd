#!/usr/bin/env python3
"""Plastic bodies are pressed together and remeshed many times: what each choice leaves of their plastic strain (reye-bench)."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from wear_case import benchmarks, figure, write_csv, write_measured  # noqa: E402

PLAYS = ("held", "released", "pressed", "swung")


def main():
    rows, measured = [], {}
    for run in benchmarks("^plastic_remesh"):
        _, _, play, times, _ = run["name"].split("/")
        way, play, times = run["label"], PLAYS[int(play)], int(times)
        rows.append([way, play, 0, 1.0, 1.0])
        rows += [[way, play, n, run[f"integral_{n}"], run[f"peak_{n}"]] for n in range(1, times + 1)]
        measured |= {f"integral_{play}_{way}": rows[-1][3], f"peak_{play}_{way}": rows[-1][4]}
        if (way, play) == ("l2", "held"):
            measured["beyond_yield_held_l2"] = run["beyond_yield"]
        if way == "l2" and "integral_farther" in run:   # the default: of the others it is known that they drift
            measured[f"farther_{play}_{way}"] = run["integral_farther"]
    write_csv("decay.csv", ["way", "play", "times", "integral", "peak"], rows)
    write_measured(measured)
    figure("""set xlabel 'remeshed, times'
set ylabel 'integral of the plastic strain over that without'
set key top left
file = 'decay.csv'
plot for [play in 'held released'] for [way in 'nearest patch l2'] file \\
     using 3:((strcol(1) eq way && strcol(2) eq play) ? $4 : NaN) with lines lw 2 title way.', '.play, \\
     for [play in 'pressed swung'] file \\
     using 3:(strcol(2) eq play ? $4 : NaN) with lines dt 2 lw 2 title 'l2, '.play
""")


if __name__ == "__main__":
    main()
