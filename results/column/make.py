#!/usr/bin/env python3
"""Confined column under fixed compression (references B6): implicit steps are exact for every step size."""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from wear_case import figure, run, write_csv, write_measured  # noqa: E402

K = 2e5 * 0.7 / (1.3 * 0.4) / 10.0   # M / H
k, compression = 1e-7, 0.01
p0 = K * compression


def sweep(measured):
    """One increment of kappa = k K ds for several factors of the complementarity function."""
    table = []
    for kappa in (0.27, 2.7, 2.7e3):
        worst = 0.0
        for c0 in (0.1, 1.0, 10.0):
            result = run("column", f"kappa_{kappa:g}_c0_{c0:g}", [
                ("increments = 10", "increments = 1"),
                ("imposed_sliding_mm = 1000.0", f"imposed_sliding_mm = {kappa / (k * K)!r}\nc_normal = {c0}")])
            p = result.last("secondary")[0]["pressure_MPa"]
            error = abs(p / (p0 / (1.0 + kappa)) - 1.0)
            worst = max(worst, error)
            table.append([kappa, c0, p, p0 / (1.0 + kappa), error, int(result.history[-1]["newton"])])
        measured[f"one_step_error_kappa_{kappa:g}"] = worst
    write_csv("sweep.csv", ["kappa", "c0", "pressure_MPa", "backward_euler_MPa", "relative_error", "newton"], table)


def main():
    measured = {}
    result = run("column", "ten_steps")
    steps = [row for row in result.history if row["step"] == "slide"]
    measured["pressure_MPa"] = result.last("secondary")[0]["pressure_MPa"]
    measured["depth_mm"] = result.contact["secondary"]["max_depth_mm"]
    measured["pressure_error"] = measured["pressure_MPa"] / (p0 / (1.0 + 100.0 * k * K) ** 10) - 1.0
    measured["ledger"] = result.contact["ledger_relative_error"]
    one = run("column", "one_step", [("increments = 10", "increments = 1")])
    measured["one_step_pressure_MPa"] = one.last("secondary")[0]["pressure_MPa"]
    rows = [[0.0, p0, p0, p0]]
    for n, row in enumerate(steps, 1):
        s = 100.0 * n
        rows.append([s, row["pressure_max_MPa"], p0 / (1.0 + 100.0 * k * K) ** n, p0 * math.exp(-k * K * s)])
    write_csv("pressure.csv", ["sliding_mm", "reye_MPa", "backward_euler_MPa", "exact_MPa"], rows)
    sweep(measured)
    write_measured(measured)
    figure("set xlabel 'sliding [mm]'\nset ylabel 'pressure [MPa]'\nset logscale y\n"
           "plot 'pressure.csv' skip 1 using 1:4 with lines title 'exact', '' skip 1 using 1:3 with lines title 'backward Euler', "
           "'' skip 1 using 1:2 with points pt 7 title 'Reye'\n")


if __name__ == "__main__":
    main()
