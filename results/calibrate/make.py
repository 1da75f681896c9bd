#!/usr/bin/env python3
"""Wear coefficients from scars: those of runs with coefficients that are known, and the scar that McColl et al. measured."""
import bisect
import csv
import json
import pathlib
import random
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from wear_case import REYE, ROOT, WORK, run, write_measured  # noqa: E402

SCENE = "fretting_demo"
SECONDARY, PRIMARY = 3.222e-5, 2.111e-5
TRUE = {"secondary": 1.37 * SECONDARY, "primary": 1.6 * PRIMARY}


def scar_file(result, side, name, noise):
    """A profile as an instrument has it: offset, tilt and origin of its own, noise of a share of its depth."""
    rows = sorted((row["x_mm"], row["wear_depth_mm"]) for row in result.last(side) if abs(row["x_mm"]) < 2.0 and row["y_mm"] < 3.0)
    places = [x for x, _ in rows]
    deepest = max(depth for _, depth in rows)
    rng = random.Random(1860)
    lines = []
    for i in range(800):
        x = -0.6 + 1.15 * i / 799
        k = bisect.bisect(places, x)
        share = (x - places[k - 1]) / (places[k] - places[k - 1])
        depth = (1.0 - share) * rows[k - 1][1] + share * rows[k][1]
        lines.append((x + 0.013, 1e3 * (depth + 0.004 + 0.002 * x + rng.gauss(0.0, noise * deepest))))
    with open(WORK / name, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(["x_mm", "depth_um"])
        writer.writerows([f"{x:.6f}", f"{depth:.6f}"] for x, depth in lines)


def calibrate(scene, measured, *options):
    """calibration.json of a scene of geo/."""
    out = WORK / ("calibrated_" + pathlib.Path(measured).stem)
    subprocess.run([REYE, "calibrate", str(ROOT / "geo" / scene / "scene.toml"), "--measured", str(WORK / measured),
                    "--out", str(out), "--threads", "1", "--force", "--quiet", *options], check=True)
    return json.loads((out / "calibration.json").read_text(encoding="utf-8")), out


def note(measured, name, result, truth):
    """Errors over half intervals, and half intervals, of the values in a result."""
    for key, value in truth.items():
        fitted = next(v for v in result["values"] if key in v["key"])
        half = 0.5 * (fitted["high_95"] - fitted["low_95"])
        measured[f"{name}_{key}_error"] = abs(fitted["fitted"] / value - 1.0)
        measured[f"{name}_{key}_error_over_half_interval"] = abs(fitted["fitted"] - value) / half
        measured[f"{name}_{key}_half_interval"] = half / fitted["fitted"]


def main():
    WORK.mkdir(parents=True, exist_ok=True)
    measured = {}
    common = run(SCENE, "common", [("= 3.222e-5", f"= {TRUE['secondary']:.6g}"), ("= 2.111e-5", f"= {1.37 * PRIMARY:.6g}")])
    scar_file(common, "secondary", "one.csv", 0.03)
    one, _ = calibrate(SCENE, "one.csv", "--at", "18000", "--side", "secondary")
    note(measured, "one_side", one, {"secondary": TRUE["secondary"]})
    measured["one_side_increments_over_a_run"] = one["increments"] / common.summary["counts"]["increments"]

    other = run(SCENE, "other", [("= 3.222e-5", f"= {TRUE['secondary']:.6g}"), ("= 2.111e-5", f"= {TRUE['primary']:.6g}")])
    for side in TRUE:
        scar_file(other, side, f"{side}.csv", 0.03)
    (WORK / "both.toml").write_text("".join(
        f'[[scar]]\nfile = "{side}.csv"\nside = "{side}"\ncycles = 18000\n' for side in TRUE), encoding="utf-8")
    both, out = calibrate(SCENE, "both.toml")
    note(measured, "both_sides", both, TRUE)
    measured["both_sides_increments_over_a_run"] = both["increments"] / other.summary["counts"]["increments"]

    # Fig. 11a of the paper: deepest 2.9 um with a noise of 0.3, width 0.50 to 0.58 mm.
    (WORK / "mccoll.toml").write_text(
        '[[figure]]\nside = "secondary"\ncycles = 18000\ndepth_mm = 0.0029\nscatter = 0.1034\n'
        '[[figure]]\nside = "secondary"\ncycles = 18000\nwidth_mm = 0.54\nscatter = 0.0428\n', encoding="utf-8")
    paper, _ = calibrate("fretting_mccoll", "mccoll.toml")
    flat = next(v for v in paper["values"] if "secondary" in v["key"])
    measured["mccoll_flat_mm3_per_J"] = flat["fitted"]
    measured["mccoll_flat_over_paper"] = flat["fitted"] / (2.9e-5 / 0.9)
    measured["mccoll_half_interval"] = 0.5 * (flat["high_95"] - flat["low_95"]) / flat["fitted"]
    write_measured(measured)
    for name in ("scar-0", "scar-1"):
        pathlib.Path(f"{name}.svg").write_text((out / "figures" / f"{name}.svg").read_text(encoding="utf-8"), encoding="utf-8")


if __name__ == "__main__":
    main()
