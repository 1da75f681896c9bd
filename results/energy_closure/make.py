#!/usr/bin/env python3
"""A gross-slip fretting cycle of elastic bodies (references D6): loop area, work of the supports, dissipated energy; and
the same balance of a rubber pin at finite strain."""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from wear_case import figure, run, write_csv, write_measured  # noqa: E402

STROKE, P, MU = 0.025, 18.5, 0.9
COUNTS = (40, 80, 160)
LAW = "wear      = { law = \"energy\", secondary_mm3_per_J = 3.2222222222e-5, primary_mm3_per_J = 2.1111111111e-5 }"
LIMIT = "[limit.life]                                 # the first cycle at which it is reached; the run continues unless stop = true\n" \
        "contact  = \"pad\"\nside     = \"secondary\"\ndepth_mm = 0.0025\n"


def variant(increments):
    """No wear, a finer and narrower fine zone, and a last step of one more cycle."""
    return [(LAW, ""), (LIMIT, ""), ("increments = 40", f"increments = {increments}"),
            ("cycles = 18000\njump = 100\n", ""),
            ("half_width_mm = 0.5, depth_mm = 0.2, size_mm = 0.010", "half_width_mm = 0.08, depth_mm = 0.08, size_mm = 0.004")]


def motion(progress, stroke=STROKE):
    """Of the shaker or the pin's head, as the scene's history has it."""
    t = 4.0 * progress
    return stroke * (t if t <= 1.0 else 2.0 - t if t <= 3.0 else t - 4.0)


def loop_of(result):
    """[(motion, force of the shaker)] over the second cycle, closed, and the energy dissipated in it."""
    start = [r for r in result.history if r["step"] == "run in without wear"][-1]
    cycle = [r for r in result.history if r["step"] == "wear"]
    key = "shaker_force_x_N_per_mm"
    loop = [(0.0, start[key])] + [(motion(r["progress"]), r[key]) for r in cycle]
    return loop, cycle[-1]["energy_mJ_per_mm"] - start["energy_mJ_per_mm"]


def rubber_loop(increments):
    """The same of the second cycle of the rubber pin, without wear."""
    result = run("rubber_pin_wear", f"rubber_{increments}",
                 [("wear      = { law = \"energy\", secondary_mm3_per_J = 0.5 }\n", ""), ("size_mm = 0.08", "size_mm = 0.16"),
                  ("increments = 40\ncycles = 200\njump = 10", f"increments = {increments}\ncycles = 2\njump = 1")])
    rows = [r for r in result.history if r["step"] == "slide"][-increments - 1:]
    loop = [(motion(r["progress"] % 1.0, 1.5), r["head_force_x_N_per_mm"]) for r in rows]
    return loop, rows[-1]["energy_mJ_per_mm"] - rows[0]["energy_mJ_per_mm"]


def area(loop):
    return sum(0.5 * (a[1] + b[1]) * (b[0] - a[0]) for a, b in zip(loop, loop[1:]))


def sliding_amplitude(loop):
    """Half the width of the loop where the force is zero: no elastic give is left in it there."""
    crossings = [a[0] + (b[0] - a[0]) * a[1] / (a[1] - b[1]) for a, b in zip(loop, loop[1:]) if a[1] * b[1] < 0.0]
    return 0.5 * (max(crossings) - min(crossings))


def main():
    measured, table, gaps = {}, [], []
    for n in COUNTS:
        loop, energy = loop_of(run("fretting_mccoll", f"increments_{n}", variant(n)))
        work, amplitude = area(loop), sliding_amplitude(loop)
        formula = 4.0 * MU * P * amplitude
        gaps.append(abs(work / energy - 1.0))
        table.append([n, work, energy, amplitude, formula, work / energy - 1.0, work / formula - 1.0])
        measured[f"work_over_energy_{n}"] = work / energy
        if n == COUNTS[-1]:
            measured["loop_over_4_mu_P_amplitude_160"] = work / formula
            measured["energy_over_4_mu_P_amplitude_160"] = energy / formula
            write_csv("loop.csv", ["motion_mm", "force_N_per_mm"], loop)
    rubber = []
    for n in COUNTS:
        loop, energy = rubber_loop(n)
        rubber.append([n, area(loop), energy, area(loop) / energy - 1.0])
        measured[f"rubber_work_over_energy_{n}"] = area(loop) / energy
    write_csv("rubber.csv", ["increments", "work_of_supports", "dissipated", "work_over_energy_minus_1"], rubber)
    measured["rate_40_80"] = math.log2(gaps[0] / gaps[1])
    measured["rate_80_160"] = math.log2(gaps[1] / gaps[2])
    write_csv("closure.csv", ["increments", "work_of_supports", "dissipated", "amplitude_mm", "4_mu_P_amplitude",
                              "work_over_energy_minus_1", "loop_over_formula_minus_1"], table)
    write_measured(measured)
    figure("set xlabel 'motion of the shaker [mm]'\nset ylabel 'its force Q [N/mm]'\nset key center center\n"
           f"plot 'loop.csv' skip 1 using 1:2 with linespoints pt 7 ps 0.3 title 'second cycle, 160 increments', "
           f"{MU * P} with lines dt 2 lc 'black' title 'mu P', {-MU * P} with lines dt 2 lc 'black' notitle\n")


if __name__ == "__main__":
    main()
