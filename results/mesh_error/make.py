#!/usr/bin/env python3
"""The estimated error of the mesh (`output.estimate_error`) against the true one: Hertz, Cattaneo-Mindlin (references B1, B2),
gross slip (B8), fretting (C1)."""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import contact_case as cc  # noqa: E402
from mesh_case import (A, A0, C, LOW_A, LOW_P0, MU, ONLY_LOADING, P0, SAME_BLOCKS, SECOND, TO_ONE, mindlin_norm,  # noqa: E402
                       traction_error, wear_error)
from wear_case import figure, read_csv, run, write_csv, write_measured  # noqa: E402

ASKED = ("[output]\n", "[output]\nestimate_error = true\n")


def meshes(a, old_size):
    """(order, intervals per half width, position, words of the scene) of all meshes."""
    for order in (1, 2):
        for n in (5, 10, 20):
            for shift in range(cc.SHIFTS):
                size = order * a / n
                yield order, n, shift, cc.zone(old_size, size, shift * size / cc.SHIFTS) + ([SECOND] if order == 2 else [])


def hertz():
    for order, n, shift, words in meshes(LOW_A, "0.010"):
        done = run("hertz_halfplane", f"hertz_{order}_{n}_{shift}",
                   words + [("increments = 5", "increments = 1\n\n[output]\nestimate_error = true")])
        yield order, n, shift, done, traction_error(done.last("secondary"), lambda x: cc.hertz(x, LOW_A, LOW_P0), lambda x: 0.0,
                                                    LOW_P0 * (4.0 * LOW_A / 3.0) ** 0.5)


def cattaneo_mindlin():
    for order, n, shift, words in meshes(A, "0.0045"):
        done = run("cattaneo_mindlin", f"shear_{order}_{n}_{shift}", words + ONLY_LOADING + [ASKED])
        yield order, n, shift, done, traction_error(done.last("secondary"), lambda x: cc.hertz(x, A, P0),
                                                    lambda x: cc.mindlin(x, A, C, MU * P0), mindlin_norm())


def gross_slip():
    def played(name, order, n, words):
        return run("line_contact_gross_slip", name, TO_ONE + SAME_BLOCKS + cc.zone("0.0018", order * A0 / n, 0.0) + words)
    reference = played("line_fine", 2, 80, [SECOND])
    for order, n in ((1, 5), (1, 10), (1, 20), (1, 40), (2, 5), (2, 10), (2, 20)):
        done = played(f"line_{order}_{n}", order, n, [ASKED] + ([SECOND] if order == 2 else []))
        yield order, n, 0, done, wear_error(done, reference)


def fretting():
    blocks = [("jump = 100", "jump = 500")]
    reference = run("fretting_mccoll", "fretting_fine", blocks + [("size_mm = 0.010", "size_mm = 0.005")])
    rows = []
    for size in (0.04, 0.02, 0.01):
        done = run("fretting_mccoll", f"fretting_{size}", blocks + [("size_mm = 0.010", f"size_mm = {size}"), ASKED])
        rows += [(size, cycle, wear_error(done, reference, k))
                 for k, (cycle, _) in enumerate(done.frames("secondary")) if cycle > 0.0]
        yield 1, size, 0, done, wear_error(done, reference)
    write_csv("errors_over_cycles.csv", ["size_mm", "cycle", "error"], rows)


def main():
    rows, measured = [], {}
    for case in (hertz, cattaneo_mindlin, gross_slip, fretting):
        name, ratios, costs = case.__name__, [], []
        for order, mesh, shift, done, error in case():
            found = done.summary["estimated_error"]
            if found["discretisation"] is None:  # too few elements touch on the coarse mesh
                rows.append((name, order, mesh, shift, error, "", "", found["energy_norm"], ""))
                continue
            ratios.append(found["discretisation"] / error)
            spent = done.summary["room_seconds"]["error"]
            costs.append(spent / (done.summary["wall_s"] - spent))
            rows.append((name, order, mesh, shift, error, found["discretisation"], ratios[-1], found["energy_norm"], costs[-1]))
        measured[f"{name}_smallest_ratio"], measured[f"{name}_largest_ratio"] = min(ratios), max(ratios)
        measured[f"{name}_estimates"] = len(ratios)
        measured[f"{name}_cost_of_finest"] = costs[-1]
        measured[f"{name}_mean_ratio"] = math.exp(sum(map(math.log, ratios)) / len(ratios))
    fine = [float(r["error"]) for r in read_csv("errors_over_cycles.csv") if float(r["size_mm"]) == 0.01]
    measured["fretting_error_after_1000_cycles_over_that_at_the_end"] = fine[0] / fine[-1]
    write_csv("estimates.csv", ["case", "order", "mesh", "position", "error", "estimate", "ratio", "energy_norm", "time_over_run"], rows)
    write_measured(measured)
    points = ", ".join(f"'< grep ^{case}, estimates.csv' using 5:6 with points pt {pt} title '{case.replace('_', ' ')}'"
                       for case, pt in (("hertz", 1), ("cattaneo_mindlin", 2), ("gross_slip", 7), ("fretting", 5)))
    figure("set logscale xy\nset format xy '%.0e'\nset xlabel 'true error'\nset ylabel 'estimated error'\nset key top left notitle\n"
           f"plot {points}, x with lines lc 'black' title 'equal', 3*x with lines dt 2 lc 'black' title 'a factor 3', "
           "x/3 with lines dt 2 lc 'black' notitle\n")


if __name__ == "__main__":
    main()
