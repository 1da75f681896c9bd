#!/usr/bin/env python3
"""The round end of a pin worn on a disc over 1000 m, beside the cap that is cut off a ball."""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import wear_case as case  # noqa: E402

P, K, R, TRACK, REVOLUTIONS, E_STAR = 20.0, 7.0e-9, 5.0, 20.0, 8000.0, 3600.0 / (1.0 - 0.4 ** 2)
TURN = 2.0 * math.pi * TRACK                           # mm of sliding in a revolution


def height(a):
    return R - math.sqrt(R * R - a * a)


def cap(volume):
    """Radius and depth of the cap of that volume; and of the scar that is flat under even pressure on a half-space, whose
    deflection is 4 p a E(r / a) / (pi E*)."""
    def radius(lost):
        low, high = 0.0, 3.0
        for _ in range(60):
            a = 0.5 * (low + high)
            low, high = (a, high) if lost(a) < volume else (low, a)
        return low
    rigid = radius(lambda a: math.pi * height(a) ** 2 * (3.0 * R - height(a)) / 3.0)
    bulge = P / (math.pi * E_STAR)                     # p a / E* times a
    soft = radius(lambda a: math.pi * height(a) ** 2 * (3.0 * R - height(a)) / 3.0 - math.pi * a * (16.0 / 3.0 - 4.0) / math.pi * bulge)
    return rigid, height(rigid), soft, height(soft) - (2.0 - 4.0 / math.pi) * bulge / soft


run = case.run("pin_on_disc", "base")
contact = run.contact
worn = contact["secondary"]
rows = run.last("secondary")
sliding = REVOLUTIONS * TURN
a, d, soft_a, soft_d = cap(K * P * sliding)
inner = [r["pressure_MPa"] for r in rows if math.hypot(r["x_mm"], r["y_mm"]) < 0.7 * soft_a]
measured = {
    "ledger": contact["ledger_relative_error"],
    "balance": run.summary["balance"],
    "worn_volume_over_k_P_s": worn["worn_volume_mm3"] / (K * P * sliding),
    "depth_over_rigid_cap": worn["max_depth_mm"] / d,
    "depth_over_cap": worn["max_depth_mm"] / soft_d,
    "contact_radius_over_cap": math.sqrt(contact["contact_area_mm2"] / math.pi) / soft_a,
    "a2_over_2R_over_rigid_cap": contact["contact_area_mm2"] / math.pi / (2.0 * R) / d,
    "mean_pressure_inside_over_even": sum(inner) / len(inner) / (P / (math.pi * soft_a ** 2)),
    "tangential_force_over_mu_P": contact["tangential_force_N"] / (0.35 * P),
    "life_over_cap": run.summary["life_cycles"]["allowed"] * TURN / next(
        s for s in (1e3 * n for n in range(1, 2000)) if cap(K * P * s)[3] >= 0.08),
    "cycles_solved": run.summary["counts"]["cycles_solved"],
    "remeshes": run.summary["counts"]["remeshes"],
    "cutbacks": run.summary["counts"]["cutbacks"],
}
case.write_measured(measured)
case.write_csv("depth.csv", ["sliding_m", "depth_um", "cap_um", "rigid_cap_um"],
               [(1e-3 * r["cycle"] * TURN, 1e3 * r["pin_depth_max_secondary_mm"], 1e3 * max(cap(K * P * r["cycle"] * TURN)[3], 0.0),
                 1e3 * cap(K * P * r["cycle"] * TURN)[1]) for r in run.history if r["step"] == "turn"])
case.write_csv("profile.csv", ["r_mm", "depth_um", "pressure_MPa"],
               sorted((math.hypot(r["x_mm"], r["y_mm"]), 1e3 * r["wear_depth_mm"], r["pressure_MPa"]) for r in rows
                      if math.hypot(r["x_mm"], r["y_mm"]) < 1.3)[::3])
case.figure(f"""
set multiplot layout 2,1
set xlabel 'sliding [m]'; set ylabel 'depth [um]'; set key bottom right
plot [0:1010][0:100] 'depth.csv' every ::1 using 1:2 with points pt 7 ps 0.6 title 'Reye', \\
     'depth.csv' every ::1 using 1:3 with lines lc 0 title 'cap, flat under load', \\
     'depth.csv' every ::1 using 1:4 with lines dt 2 lc 0 title 'rigid cap'
set xlabel 'distance from the pin axis [mm]'; set ylabel 'depth [um]'; set y2label 'pressure [MPa]'; set y2tics; set key top right
plot [0:1.3][0:100] 'profile.csv' every ::1 using 1:2 with points pt 7 ps 0.4 title 'depth', \\
     x < {a} ? 1e3 * ({d} - x * x / (2 * {R})) : 0 with lines dt 2 lc 0 title 'rigid cap', \\
     'profile.csv' every ::1 using 1:3 axes x1y2 with points pt 6 ps 0.4 lc rgb '#e08030' title 'pressure'
unset multiplot
""")
