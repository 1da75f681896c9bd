#!/usr/bin/env python3
"""The error that a scene asks for (`accuracy`) against the one it gets: Hertz, Cattaneo-Mindlin, gross slip (B8), fretting (C1)."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import contact_case as cc  # noqa: E402
from mesh_case import (A, A0, C, LOW_A, LOW_P0, MU, ONLY_LOADING, P0, SAME_BLOCKS, SECOND, TO_ONE, mindlin_norm,  # noqa: E402
                       traction_error, wear_error)
from wear_case import figure, run, write_csv, write_measured  # noqa: E402


def asking(accuracy, size):
    return [("title    = ", f"accuracy = {accuracy}\ntitle    = "), (f", size_mm = {size}", "")]


def hertz():
    for accuracy in (0.05, 0.02, 0.01, 0.005):
        for width in (0.26, 0.3):
            done = run("hertz_halfplane", f"hertz_{accuracy}_{width}",
                       asking(accuracy, "0.010") + [("half_width_mm = 0.26", f"half_width_mm = {width}"), ("increments = 5", "increments = 1")])
            yield accuracy, done, traction_error(done.last("secondary"), lambda x: cc.hertz(x, LOW_A, LOW_P0), lambda x: 0.0,
                                                 LOW_P0 * (4.0 * LOW_A / 3.0) ** 0.5)


def cattaneo_mindlin():
    for accuracy in (0.02, 0.01):
        done = run("cattaneo_mindlin", f"shear_{accuracy}", asking(accuracy, "0.0045") + ONLY_LOADING)
        yield accuracy, done, traction_error(done.last("secondary"), lambda x: cc.hertz(x, A, P0),
                                             lambda x: cc.mindlin(x, A, C, MU * P0), mindlin_norm())


def gross_slip():
    reference = run("line_contact_gross_slip", "line_fine", TO_ONE + SAME_BLOCKS + cc.zone("0.0018", 2.0 * A0 / 80, 0.0) + [SECOND])
    for accuracy in (0.05, 0.02, 0.01):
        done = run("line_contact_gross_slip", f"line_{accuracy}", TO_ONE + SAME_BLOCKS + asking(accuracy, "0.0018"))
        yield accuracy, done, wear_error(done, reference)


def fretting():
    blocks = "jump = { tolerance = 0.01 }"
    reference = run("fretting_mccoll_tolerance", "fretting_fine",
                    [(blocks, "jump = { tolerance = 0.002 }"), ("size_mm = 0.010", "size_mm = 0.005")])
    for accuracy in (0.05, 0.02, 0.01):
        done = run("fretting_mccoll_tolerance", f"fretting_{accuracy}", asking(accuracy, "0.010") + [(blocks, "")])
        yield accuracy, done, wear_error(done, reference)


def main():
    rows, measured = [], {}
    for case in (hertz, cattaneo_mindlin, gross_slip, fretting):
        ratios = []
        for accuracy, done, error in case():
            spent = done.summary["room_seconds"]
            pilot = spent["pilot"] / (sum(spent.values()) - spent["pilot"])
            ratios.append(error / accuracy)
            rows.append((case.__name__, accuracy, error, ratios[-1], done.summary["estimated_error"]["discretisation"], pilot))
        measured[f"{case.__name__}_smallest"], measured[f"{case.__name__}_largest"] = min(ratios), max(ratios)
    write_csv("accuracy.csv", ["case", "accuracy", "error", "error_over_accuracy", "estimate", "pilot_over_run"], rows)
    write_measured(measured)
    points = ", ".join(f"'< grep ^{case}, accuracy.csv' using 2:3 with points pt {pt} title '{case.replace('_', ' ')}'"
                       for case, pt in (("hertz", 1), ("cattaneo_mindlin", 2), ("gross_slip", 7), ("fretting", 5)))
    figure("set logscale xy\nset xlabel 'accuracy asked for'\nset ylabel 'true error'\nset key top left notitle\n"
           f"plot [0.003:0.1] {points}, x with lines lc 'black' title 'equal'\n")


if __name__ == "__main__":
    main()
