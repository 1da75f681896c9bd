#!/usr/bin/env python3
"""A shaft that spins a thousand turns, and what an increment of a body that turns costs beside one that slides."""
import math
import pathlib
import statistics
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import wear_case as case  # noqa: E402

SCENE, FORCE, FRICTION, COEFFICIENT, RADIUS = "spinning_shaft", 40.0, 0.2, 1e-9, 10.0
TURN = 'rotation = { motion_rad = 6.283185307179586, history = "turn" }'
# Back and forth over five facets, either way: the rim by turning, or the whole shaft without.
SHORT = [("cycles     = 1000", "cycles     = 20"), ("increments = 24", "increments = 40"),
         ("turn  = [[0, 0], [1, 1]]", "turn  = [[0, 0], [0.25, 1], [0.75, -1], [1, 0]]")]
TURNING = SHORT + [(TURN, 'rotation = { motion_rad = 0.05, history = "turn" }')]
SLIDING = SHORT + [(TURN, 'rotation = "fixed"'), ('x        = "fixed"', 'x        = { motion_mm = 0.5, history = "turn" }')]


def cost(run):
    return run.summary["room_seconds"]["solver"] / run.summary["counts"]["increments"]


thousand = case.run(SCENE, "thousand")
turns = [row for row in thousand.history if row["step"] == "turns"]
slid = 2.0 * math.pi * RADIUS * thousand.summary["cycles"]
ratios = [cost(case.run(SCENE, "turning", TURNING)) / cost(case.run(SCENE, "sliding", SLIDING)) for _ in range(5)]
case.write_csv("turns.csv", ["cycle", "normal_N_per_mm", "drive_N_per_mm", "pressure_max_MPa", "depth_um"],
               [(r["cycle"], r["housing_force_y_N_per_mm"], r["housing_force_x_N_per_mm"], r["pressure_max_MPa"],
                 1e3 * r["depth_max_secondary_mm"]) for r in turns if r["progress"] == 1.0 and r["cycle"] % 10 == 0])
case.write_csv("cost.csv", ["turning_over_sliding"], [(r,) for r in ratios])
case.write_measured({
    "turns": thousand.summary["cycles"],
    "normal_force_drift": max(abs(abs(r["housing_force_y_N_per_mm"]) / FORCE - 1.0) for r in turns),
    "drive_over_friction": max(abs(abs(r["housing_force_x_N_per_mm"]) / (FRICTION * FORCE) - 1.0) for r in turns),
    "area_over_closed_form": thousand.contact["secondary"]["worn_area_mm2"] / (COEFFICIENT * FORCE * slid),
    "ledger": thousand.contact["ledger_relative_error"],
    "cost_turning_over_sliding": statistics.median(ratios),
})
