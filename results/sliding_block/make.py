#!/usr/bin/env python3
"""Block on block, sliding imposed (references B5): depth, volume and energy in either role, on either mesh."""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from wear_case import figure, run, write_csv, write_measured  # noqa: E402

SWAP = [('secondary = "slider_bottom"\nprimary   = ["base_top"]', 'secondary = "base_top"\nprimary   = ["slider_bottom"]')]
BESIDE = "".join(
    f'[load.{name}]\nedge = "base_top"\ninterval_mm = {interval}\ntraction_MPa = [3.0, -10.0]\nhistory = "press"\n\n'
    for name, interval in (("left", "[0.0, 5.0]"), ("right", "[15.0, 20.0]")))
WIDER = [("blocks.geo", "wider_base.geo"), ("[history]\n", BESIDE + "[history]\n")]
# Soft enough that the shallow ends of the scar are pressed flat again.
SOFT = [("E_MPa = 200e6", "E_MPa = 2e3"), ("motion_mm = 3.0e-7", "motion_mm = 0.03")]
SIZES = (0.6, 0.3, 0.15)


def coefficients(secondary, primary):
    return [("secondary_mm3_per_J = 1.0e-4, primary_mm3_per_J = 0.5e-4",
             f"secondary_mm3_per_J = {secondary}, primary_mm3_per_J = {primary}")]


def size(h):
    return [("far_size_mm = 0.5", f"far_size_mm = {h}"), ("far_size_mm = 0.7", f"far_size_mm = {h}")]


def depth_error(result, side, depth):
    return max(abs(row["wear_depth_mm"] / depth - 1.0) for row in result.last(side))


def exact_cases(measured):
    both = {"secondary": 3e-4, "primary": 1.5e-4}
    cases = {
        "non_matching": ([], both),
        "matching": ([("far_size_mm = 0.7", "far_size_mm = 0.5")], both),
        "roles_exchanged": (SWAP, both),
        "wider_base_narrow_secondary": (WIDER + coefficients(1e-4, 0.0), {"secondary": 3e-4}),
        "wider_base_narrow_primary": (WIDER + SWAP + coefficients(0.0, 1e-4), {"primary": 3e-4}),
    }
    for name, (replacements, worn) in cases.items():
        result = run("sliding_block", name, replacements)
        for side, depth in worn.items():
            measured[f"{name}_{side}_depth_error"] = depth_error(result, side, depth)
            measured[f"{name}_{side}_volume_mm2"] = result.contact[side]["worn_area_mm2"]
        measured[f"{name}_energy_mJ_per_mm"] = result.contact["dissipated_energy_mJ_per_mm"]
        measured[f"{name}_ledger"] = result.contact["ledger_relative_error"]


def end_effect(rows, parts=400):
    """Mean |depth - exact| over the worn length, in parts of the exact depth."""
    total = 0.0
    for a, b in zip(rows, rows[1:]):
        for k in range(parts):
            t = (k + 0.5) / parts
            x = a["x_mm"] + t * (b["x_mm"] - a["x_mm"])
            w = a["wear_depth_mm"] + t * (b["wear_depth_mm"] - a["wear_depth_mm"])
            total += abs(w - (3e-4 if 0.0 < x < 10.0 else 0.0)) * (b["x_mm"] - a["x_mm"]) / parts
    return total / 3e-3


def end_cases(measured):
    table, profiles = [], []
    for side, roles in (("secondary", SWAP + coefficients(1e-4, 0.0)), ("primary", coefficients(0.0, 1e-4))):
        errors = []
        for h in SIZES:
            result = run("sliding_block", f"wider_wears_{side}_{h}", WIDER + SOFT + roles + size(h))
            rows = result.last(side)
            errors.append(end_effect(rows))
            table.append([side, h, errors[-1], result.contact["ledger_relative_error"]])
            measured[f"wider_wears_{side}_ledger_{h}"] = result.contact["ledger_relative_error"]
            profiles += [[side, h, r["x_mm"], 1e3 * r["wear_depth_mm"]] for r in rows if -2.0 < r["x_mm"] < 3.0]
        measured[f"wider_wears_{side}_end_effect_slope"] = math.log(errors[0] / errors[-1]) / math.log(SIZES[0] / SIZES[-1])
    write_csv("end_effect.csv", ["wearing_side", "size_mm", "mean_error", "ledger"], table)
    write_csv("profiles.csv", ["wearing_side", "size_mm", "x_mm", "depth_um"], profiles)


def main():
    measured = {}
    exact_cases(measured)
    end_cases(measured)
    write_measured(measured)
    lines = ", ".join(
        f"'< grep ^secondary,{h}, profiles.csv' using 3:4 with linespoints pt 7 ps 0.5 title 'h = {h} mm'" for h in SIZES)
    figure("set xlabel 'x [mm]'\nset ylabel 'depth [um]'\nset key bottom right notitle\n"
           f"set title 'wider block wears: the end of its scar'\nplot {lines}, x < 0 ? 0 : 0.3 with steps lc 'black' title 'exact'\n")


if __name__ == "__main__":
    main()
