#!/usr/bin/env python3
"""C1 with 40 um elements: blocks chosen by tolerance and blocks of one size, against the run extrapolated from jumps 20, 10, 5."""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import wear_case as case

COARSE = [("size_mm = 0.010", "size_mm = 0.040")]
TOLERANCES = [0.03, 0.01, 0.003, 0.001]
BESIDE = [0.0016, 0.0013, 0.0011, 0.0008]  # for the slope: where a node at the rim begins to wear decides single errors of 0.1 %
JUMPS = [2000, 1000, 500, 200, 100]
SIDES = ["secondary", "primary"]


def depths(run):
    """Both sides' (arc length, depth) at the end."""
    return {side: [(r["arc_length_mm"], r["wear_depth_mm"]) for r in run.last(side)] for side in SIDES}


def area(rows, f=lambda w: w):
    return sum(0.5 * (f(a[1]) + f(b[1])) * (b[0] - a[0]) for a, b in zip(rows, rows[1:]))


def width(rows):
    """Arc length where the depth exceeds 0.5 % of its largest, ends by linear interpolation."""
    bound = 0.005 * max(w for _, w in rows)
    ends = [a[0] + (b[0] - a[0]) * (bound - a[1]) / (b[1] - a[1])
            for a, b in zip(rows, rows[1:]) if (a[1] - bound) * (b[1] - bound) < 0.0]
    return ends[-1] - ends[0]


def measures(rows):
    return {"depth": max(w for _, w in rows), "area": area(rows), "width": width(rows)}


def errors(found, exact):
    """Of depth, area and width, the larger side's, and of the profile: int |w - w'| over the worn area."""
    worst = {}
    for side in SIDES:
        a, b = measures(found[side]), measures(exact[side])
        here = {key: abs(a[key] / b[key] - 1.0) for key in b}
        here["profile"] = area([(s, abs(w - v)) for (s, w), (_, v) in zip(found[side], exact[side])]) / b["area"]
        for key, value in here.items():
            worst[key] = max(worst.get(key, 0.0), value)
    return worst


def extrapolated(runs):
    """From jumps 4 d, 2 d, d with error c1 d + c2 d^2."""
    w = [depths(run) for run in runs]
    return {side: [(a[0], a[1] / 3.0 - 2.0 * b[1] + 8.0 / 3.0 * c[1])
                   for a, b, c in zip(*(each[side] for each in w))] for side in SIDES}


def slope(points):
    x, y = [math.log(a) for a, _ in points], [math.log(b) for _, b in points]
    mx, my = sum(x) / len(x), sum(y) / len(y)
    return sum((a - mx) * (b - my) for a, b in zip(x, y)) / sum((a - mx) ** 2 for a in x)


ENDS = [("frames = { every_cycles = 1000 }", "frames = { per_step = 0 }")]  # frames on the way would be levelled
fixed = {jump: case.run("fretting_mccoll", f"jump_{jump}", COARSE + [("jump = 100", f"jump = {jump}")])
         for jump in JUMPS + [20, 10, 5]}
exact = extrapolated([fixed[20], fixed[10], fixed[5]])
tolerated = {t: case.run("fretting_mccoll_tolerance", f"tolerance_{t}", COARSE + ENDS + [("tolerance = 0.01", f"tolerance = {t}")])
             for t in sorted(TOLERANCES + BESIDE, reverse=True)}

measured = {"ledger_relative_error": max(r.contact["ledger_relative_error"] for r in tolerated.values())}
rows = []
for t, run in tolerated.items():
    e, name = errors(depths(run), exact), f"tolerance_{t}"
    estimate, solved = run.summary["estimated_error"]["cycle_jump"], run.summary["counts"]["cycles_solved"] - 1
    rows.append(("tolerance", t, solved, run.summary["counts"]["refused_blocks"], estimate, *e.values(), run.summary["cpu_s"]))
    if t in BESIDE:
        continue
    measured[f"{name}_cycles_solved"] = solved
    measured[f"{name}_estimate"] = estimate
    measured[f"{name}_estimate_over_profile_error"] = estimate / e["profile"]
    measured[f"{name}_estimate_over_depth_error"] = estimate / max(e["depth"], e["area"])
    for key, value in e.items():
        measured[f"{name}_{key}_error"] = value
for jump in JUMPS:
    e = errors(depths(fixed[jump]), exact)
    rows.append(("jump", jump, 18000 / jump, 0, "", *e.values(), fixed[jump].summary["cpu_s"]))
measured["slope_tolerance"] = slope([(r[2], r[8]) for r in rows if r[0] == "tolerance"])
measured["slope_fixed"] = slope([(r[2], r[8]) for r in rows if r[0] == "jump"])
case.write_measured(measured)
header = ["blocks_by", "value", "cycles_solved", "refused", "estimate", "depth_error", "area_error", "width_error", "profile_error", "cpu_s"]
case.write_csv("errors.csv", header, rows)
for kind in ("tolerance", "jump"):
    case.write_csv(f"errors_{kind}.csv", header, [r for r in rows if r[0] == kind])
case.write_csv("reference.csv", ["side", "arc_length_mm", "depth_mm"],
               [(side, s, w) for side in SIDES for s, w in exact[side] if w != 0.0])
case.figure("""
set logscale xy; set xlabel 'cycles solved, of 18 000'; set ylabel 'error of the profile, int |w - w_0| / area'
plot 'errors_jump.csv' every ::1 using 3:9 with linespoints pt 7 title 'blocks of one size', \\
     'errors_tolerance.csv' every ::1 using 3:9 with linespoints pt 7 lw 2 title 'blocks by tolerances of 3 to 0.08 %', \\
     'errors_tolerance.csv' every ::1 using 3:5 with linespoints pt 6 dashtype 2 title 'its estimate', \\
     'errors_tolerance.csv' every ::1 using 3:6 with linespoints pt 5 title 'its error of the largest depth'
""")
