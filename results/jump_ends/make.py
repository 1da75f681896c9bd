#!/usr/bin/env python3
"""The end of worn contacts under a tolerance of the cycle jump, beside that of the same scenes in short blocks of one size."""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import wear_case as case

TOLERANCE = "jump = { tolerance = 0.01 }"
# scene: jumps as they stand there, and short ones; the last ones are chosen by the tolerance in the other run
SCENES = {
    "ball_worn_flat": [(5, 1)],
    "pin_in_hole": [(2, 1)],
    "block_on_ring": [(25, 8)],
    "pin_worn_flat": [(25, 8)],
    "fretting_deep": [(100, 50), (600, 300), (6000, 2000), (50000, 4000)],
}


def pressures(rows):
    """In the middle of what carries, and the peak inside nine tenths of that."""
    carrying = [r for r in rows if r["pressure_MPa"] > 0.0]
    ends = [r["arc_length_mm"] for r in carrying]
    middle, half = 0.5 * (max(ends) + min(ends)), 0.5 * (max(ends) - min(ends))
    inside = [r["pressure_MPa"] for r in carrying if abs(r["arc_length_mm"] - middle) < 0.9 * half]
    centre = min(carrying, key=lambda r: abs(r["arc_length_mm"] - middle))["pressure_MPa"]
    return {"p0": centre, "peak": max(inside)}


def end(run):
    return {"depth": run.contact["secondary"]["max_depth_mm"], **pressures(run.last("secondary"))}


def on_the_way(scene, short, chosen):
    """Frames before the end, once a tenth of the cycles is done, beside the middle pressure of the short blocks at the
    same cycle, and the largest difference; nothing where there are none."""
    def shown(run):
        return [(cycle, *pressures(rows).values()) for cycle, rows in run.frames("secondary")[:-1] if cycle > 0.0]

    frames, finely = shown(chosen), shown(short)
    if len(finely) < 2:
        return [], {}
    p0 = case.Line([(cycle, p) for cycle, p, _ in finely])
    late = [(cycle, p, peak, p0(cycle)) for cycle, p, peak in frames if cycle > 0.1 * frames[-1][0] and p0(cycle) > 0.0]
    if not late:
        return [], {}
    return [[scene, *row] for row in late], {f"{scene}_frames": max(abs(p / q - 1.0) for _, p, _, q in late)}


def conforming(depth, radius=5.0, force=40.0):
    """Mean pressure of a pin worn flat to `depth`: nearly that of its middle."""
    return force / (2.0 * math.sqrt(radius**2 - (radius - depth) ** 2))


def conforming_ball(depth, radius=5.0, force=20.0):
    """Mean pressure of a ball worn flat to `depth`."""
    return force / (math.pi * (radius**2 - (radius - depth) ** 2))


CLOSED_FORMS = {"pin_worn_flat": conforming, "ball_worn_flat": conforming_ball}


def main():
    rows, frames, measured = [], [], {}
    ledger = 0.0
    for scene, jumps in SCENES.items():
        short = case.run(scene, f"{scene}_short", [(f"jump = {a}\n", f"jump = {b}\n") for a, b in jumps])
        chosen = case.run(scene, f"{scene}_tolerance", [(f"jump = {a}\n", TOLERANCE + "\n") for a, _ in jumps])
        a, b = end(short), end(chosen)
        apart = {key: abs(b[key] / a[key] - 1.0) for key in a}
        for run, figures in (short, a), (chosen, b):
            ledger = max(ledger, run.contact["ledger_relative_error"])
            rows.append([scene, run.folder.name.removeprefix(scene + "_"), *figures.values(),
                         run.summary["counts"]["blocks"], run.summary["counts"]["remeshes"], run.summary["cpu_s"]])
        measured |= {f"{scene}_{key}": value for key, value in apart.items()}
        late, apart_there = on_the_way(scene, short, chosen)
        frames += late
        measured |= apart_there
        if scene in CLOSED_FORMS:
            for name, figures in ("short", a), ("tolerance", b):
                measured[f"{scene}_{name}_closed_form"] = abs(figures["p0"] / CLOSED_FORMS[scene](figures["depth"]) - 1.0)
        print(scene, *(f"{key} {100 * value:.2f} %" for key, value in apart.items()))
    measured["ledger"] = ledger
    case.write_csv("ends.csv", ["scene", "blocks_by", "depth_mm", "p0_MPa", "peak_inside_MPa", "blocks", "remeshes", "cpu_s"], rows)
    case.write_csv("frames.csv", ["scene", "cycle", "p0_MPa", "peak_inside_MPa", "p0_of_short_blocks_MPa"], frames)
    case.write_measured(measured)


main()
