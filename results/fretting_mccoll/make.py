#!/usr/bin/env python3
"""C1: 18 000 fretting cycles in 180 blocks; the same with sides swapped, with half the jump; its first tenth with half the element."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import wear_case as case

SCENE = "fretting_mccoll"
LAST = [("frames = { every_cycles = 1000 }", "frames = { every_cycles = 1000, last_block = true }")]
SWAPPED = [('secondary = "face"', 'secondary = "round"'), ('primary   = ["round"]', 'primary   = ["face"]'),
           ("secondary_mm3_per_J = 3.2222222222e-5, primary_mm3_per_J = 2.1111111111e-5",
            "secondary_mm3_per_J = 2.1111111111e-5, primary_mm3_per_J = 3.2222222222e-5"),
           ('side     = "secondary"', 'side     = "primary"')]
INCREMENTS = 40


def jitter(rows, inside):
    """Largest |p_j - (p_(j-1) + p_(j+1)) / 2| over the mean pressure, more than `inside` elements inside the contact."""
    p = [r["pressure_MPa"] for r in rows]
    loaded = [i for i, v in enumerate(p) if v > 0.0]
    mean = sum(p[i] for i in loaded) / len(loaded)
    inner = [i for i in loaded if i - loaded[0] > inside and loaded[-1] - i > inside]
    return max((abs(p[i] - 0.5 * (p[i - 1] + p[i + 1])) for i in inner), default=0.0) / mean


base = case.run(SCENE, "base", LAST)
swapped = case.run(SCENE, "swapped", SWAPPED)
finer = case.run(SCENE, "jump_50", [("jump = 100", "jump = 50")])
EARLY = LAST + [("cycles = 18000", "cycles = 1800")]
early = case.run(SCENE, "early_h", EARLY)
half = case.run(SCENE, "early_half_h", EARLY + [("size_mm = 0.010", "size_mm = 0.005")])

cycle = base.frames("secondary")[-INCREMENTS:]
flat, disc = base.contact["secondary"], base.contact["primary"]
depth = flat["max_depth_mm"]
measured = {
    "cycles": base.summary["cycles"],
    "worn_area_ratio": disc["worn_area_mm2"] / flat["worn_area_mm2"],
    "ledger_relative_error": max(r.contact["ledger_relative_error"] for r in (base, swapped, finer, early, half)),
    "depth_flat_mm": depth,
    "scar_width_flat_mm": flat["scar_width_mm"],
    "swapped_depth_change": abs(swapped.contact["primary"]["max_depth_mm"] / depth - 1.0),
    "jump_50_depth_change": abs(finer.contact["secondary"]["max_depth_mm"] / depth - 1.0),
    "early_half_h_depth_change": abs(half.contact["secondary"]["max_depth_mm"] / early.contact["secondary"]["max_depth_mm"] - 1.0),
    "cutbacks": base.summary["counts"]["cutbacks"],
    "jitter_phase_0": jitter(cycle[-1][1], 3),
    "jitter_all_increments": max(jitter(rows, 8) for _, rows in cycle),
    "solves_per_increment": base.summary["counts"]["newton_iterations"] / base.summary["counts"]["increments"],
}
case.write_measured(measured)

profile = [(a["x_mm"], 1e3 * a["wear_depth_mm"]) for a in base.last("secondary") if abs(a["x_mm"]) <= 0.4]
other = [(a["x_mm"], 1e3 * a["wear_depth_mm"]) for a in base.last("primary") if abs(a["x_mm"]) <= 0.4]
case.write_csv("profile_flat.csv", ["x_mm", "depth_um"], profile)
case.write_csv("profile_cylinder.csv", ["x_mm", "depth_um"], other)


def end_of_stroke(run):
    """Pressure where the stroke ends: a quarter of the last cycle."""
    rows = run.frames("secondary")[-INCREMENTS:][INCREMENTS // 4 - 1][1]
    return [(r["x_mm"], r["pressure_MPa"]) for r in rows if abs(r["x_mm"]) <= 0.4]


case.write_csv("pressure_end_of_stroke_h.csv", ["x_mm", "pressure_MPa"], end_of_stroke(early))
case.write_csv("pressure_end_of_stroke_half_h.csv", ["x_mm", "pressure_MPa"], end_of_stroke(half))
seconds = base.summary["room_seconds"]
total = sum(seconds.values())
case.write_csv("time_by_room.csv", ["room", "share"], sorted(((k, v / total) for k, v in seconds.items()), key=lambda r: -r[1]))
case.figure("""
set multiplot layout 2,1
set xlabel 'x [mm]'; set ylabel 'depth [um]' ; set yrange [*:*] reverse
set arrow 1 from -0.29,2.9 to 0.29,2.9 nohead dashtype 2
set label 1 'McColl et al. 2004: about 2.9 um deep, 0.50 to 0.58 mm wide' at -0.28,3.15
plot [-0.4:0.4][3.4:-0.2] 'profile_flat.csv' every ::1 using 1:2 with lines lw 2 title 'flat, 18 000 cycles', \\
     'profile_cylinder.csv' every ::1 using 1:2 with lines lw 2 title 'cylinder'
unset arrow 1; unset label 1
set ylabel 'p [MPa], end of stroke, cycle 1800'; set yrange [*:*] noreverse
plot [-0.4:0.4] 'pressure_end_of_stroke_h.csv' every ::1 using 1:2 with linespoints pt 7 ps 0.3 title 'h = 10 um', \\
     'pressure_end_of_stroke_half_h.csv' every ::1 using 1:2 with lines title 'h = 5 um'
unset multiplot
""")
