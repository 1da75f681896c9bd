#!/usr/bin/env python3
"""A measured series of 100 000 points played as a cycle: what thinning it costs, against a run on all of its points."""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from wear_case import WORK, figure, run, write_csv, write_measured  # noqa: E402

POINTS = 100_000
TOLERANCES = (0.05, 0.02, 0.01, 0.002)


def series():
    """Time and slip: three frequencies, and a ripple of 0.15 % of the range, from crest to trough."""
    rows = []
    for i in range(POINTS):
        t = 10.0 * i / POINTS
        w = 0.2 * math.pi * t
        rows.append((t, math.sin(w) + 0.3 * math.sin(7.0 * w) + 0.1 * math.sin(31.0 * w) + 2e-3 * math.sin(211.0 * w)))
    return rows


def play(name, table, increments):
    """One cycle; increments besides the corners, so that implicit steps are as short in all runs."""
    return run("column", name, [
        ("imposed_sliding_mm = 1000.0", 'imposed_sliding_mm = { value = 20.0, history = "slide" }'),
        ("[history]\n", f"[history]\nslide = {table}\n"),
        ("increments = 10\ncycles = 1", f'play = ["slide"]\nincrements = {increments}\ncycles = 1')])


def main():
    WORK.mkdir(parents=True, exist_ok=True)
    rows = series()
    write = [f"{t:.4f},{s:.9f}" for t, s in rows]
    path = WORK / "load.csv"
    path.write_text("time_s,slide_mm\n" + "\n".join(write) + "\n", encoding="utf-8")
    source = f'file = "{path}", close = true'
    everything = play("all", f"{{ {source}, tolerance = 0.0 }}", 1)
    depth = everything.contact["secondary"]["max_depth_mm"]
    measured = {"points_played": everything.summary["histories"]["slide"]["points_kept"], "depth_um": 1e3 * depth}
    table = []
    for tolerance in TOLERANCES:
        result = play(f"tolerance_{tolerance:g}", f"{{ {source}, tolerance = {tolerance} }}", 20_000)
        history = result.summary["histories"]["slide"]
        error = 1.0 - result.contact["secondary"]["max_depth_mm"] / depth
        table.append([tolerance, history["points_kept"], history["way_lost"], error])
        measured[f"points_{tolerance:g}"] = history["points_kept"]
        measured[f"error_over_stated_{tolerance:g}"] = error / history["way_lost"]
        measured[f"stated_{tolerance:g}"] = history["way_lost"]
    write_csv("tolerance.csv", ["tolerance", "points_kept", "way_lost", "depth_error"], table)
    plain = play("plain", f"{{ {source}, tolerance = 0.01 }}", 1)
    measured["speedup"] = everything.summary["wall_s"] / plain.summary["wall_s"]
    write_measured(measured)
    figure("set xlabel 'tolerance, share of the range'\nset ylabel 'share'\nset logscale xy\nset key left top\n"
           "plot 'tolerance.csv' skip 1 using 1:3 with lines title 'way lost, as the run states', "
           "'' skip 1 using 1:4 with points pt 7 title 'depth lost against all 100 000 points'\n")


if __name__ == "__main__":
    main()
