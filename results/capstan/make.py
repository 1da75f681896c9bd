#!/usr/bin/env python3
"""A belt pulled over a drum: tension and pressure against Euler and Eytelwein, and Newton's iterations."""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import wear_case as case  # noqa: E402

SLACK, FRICTION, RADIUS, THICKNESS = 5.0, 0.2, 50.0, 2.0
TIGHTENED = 10   # frame at the end of the first step
RATE = FRICTION * RADIUS / (RADIUS + 0.5 * THICKNESS)   # friction acts at the drum, tension in the middle of the belt

EVERY = ("increments = 30", "increments = 30\n\n[output]\nframes = { every_increment = true }")

run = case.run("capstan", "belt", [EVERY])
tight = abs(run.history[-1]["tight_force_y_N_per_mm"])
frames = [rows for _, rows in run.frames("secondary")]
tightened, pulled = frames[TIGHTENED], frames[-1]   # slip is the way so far: first towards the slack end, then the tight one
slid = [now["slip_mm"] - 2.0 * then["slip_mm"] for then, now in zip(tightened, pulled)]
angles = [math.atan2(r["y_mm"], r["x_mm"]) + way / RADIUS for r, way in zip(pulled, slid)]   # tables give X
profile = sorted((math.degrees(a), r["pressure_MPa"], SLACK / RADIUS * math.exp(RATE * a), abs(r["shear_MPa"]))
                 for a, r in zip(angles, pulled))
inside = [r for r in profile if 20.0 < r[0] < 160.0]
case.write_csv("profile.csv", ["angle_deg", "pressure_MPa", "closed_form_MPa", "shear_MPa"], profile)
case.write_measured({
    "tension_ratio_over_closed_form": tight / SLACK / math.exp(RATE * math.pi),
    "pressure_error_inside": max(abs(p / exact - 1.0) for _, p, exact, _ in inside),
    "pressure_error_inside_rms": math.sqrt(sum((p / exact - 1.0) ** 2 for _, p, exact, _ in inside) / len(inside)),
    "ledger": run.contact["ledger_relative_error"],
    "iterations_an_increment": run.summary["counts"]["newton_iterations"] / run.summary["counts"]["increments"],
    "cut_backs": run.summary["counts"]["cutbacks"],
})
case.figure("set xlabel 'angle from the slack end [degrees]'\nset ylabel 'pressure [MPa]'\nset key top left\n"
            "plot 'profile.csv' using 1:2 with lines title 'Reye', '' using 1:3 with lines dt 2 lc 'black' title 'T(angle) / R'\n")
