#!/usr/bin/env python3
"""C7: a half-round ring worn for 3 s on a flat ring; the same with half the element and with half the jump."""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import remesh_case as meshes  # noqa: E402
import wear_case as case  # noqa: E402

SCENE = "ring_on_ring_axisymmetric"
FORCE, R, CENTRE, COEFFICIENT = 150796320.0, 30.0, 100.0, 1e-12
SLIDING = 2.0 * math.pi * 1e5 * 100.0 * 3.0
FINER = [("size_mm = 1.0 ", "size_mm = 0.5 "), ("far_size_mm = 3.0", "far_size_mm = 1.5"), ("far_size_mm = 5.0", "far_size_mm = 2.5")]


def mean_pressure(rows):
    """Mean over the plan area of the facets whose two nodes are loaded."""
    force = area = 0.0
    for a, b in zip(rows, rows[1:]):
        ring = math.pi * abs(b["x_mm"] ** 2 - a["x_mm"] ** 2)
        if a["pressure_MPa"] > 0.0 and b["pressure_MPa"] > 0.0:
            force, area = force + 0.5 * (a["pressure_MPa"] + b["pressure_MPa"]) * ring, area + ring
    return force / area


base = case.run(SCENE, "base")
finer = case.run(SCENE, "half_h", FINER)
half_jump = case.run(SCENE, "half_jump", [("jump = 3", "jump = 1.5")])

rows, worn = base.last("secondary"), base.contact["secondary"]
depth, reach = worn["max_depth_mm"], 0.5 * worn["scar_width_mm"]
outline = meshes.outline(rows)
to_finer = meshes.difference(outline, meshes.outline(finer.last("secondary")), reach, depth, CENTRE)
to_half_jump = meshes.difference(outline, meshes.outline(half_jump.last("secondary")), reach, depth, CENTRE)
width = 2.0 * base.contact["contact_half_width_mm"]
measured = {
    "force_N": base.history[-1]["piston_force_y_N"],
    "worn_volume_over_k_F_s": worn["worn_volume_mm3"] / (COEFFICIENT * FORCE * SLIDING),
    "ledger": max(r.contact["ledger_relative_error"] for r in (base, finer, half_jump)),
    "mean_pressure_over_F_2_pi_100_b": mean_pressure(rows) / (FORCE / (2.0 * math.pi * CENTRE * width)),
    "remeshes": base.summary["counts"]["remeshes"],
    "depth_mm": depth,
    "half_h_profile": to_finer[0],
    "half_h_profile_rms": to_finer[1],
    "half_jump_profile": to_half_jump[0],
    "scaled_jacobian": min(map(meshes.poorest_scaled_jacobian, (base, finer, half_jump))),
    "most_nodes": max(map(meshes.most_nodes, (base, finer, half_jump))),
}
case.write_measured(measured)
case.write_csv("profiles.csv", ["r_mm", "y_mm", "size_mm"],
               [(x, y, h) for h, run in ((1.0, base), (0.5, finer)) for x, y in meshes.outline(run.last("secondary")) if abs(x - CENTRE) <= 20.0])
case.write_csv("pressure.csv", ["r_mm", "pressure_MPa", "size_mm"],
               [(r["x_mm"], r["pressure_MPa"], h) for h, run in ((1.0, base), (0.5, finer)) for r in run.last("secondary")
                if abs(r["x_mm"] - CENTRE) <= 20.0])
case.figure(f"""
set multiplot layout 2,1
set xlabel 'r [mm]'; set ylabel 'y [mm]'; set samples 401; set key top center
plot [80:120][0:8] 'profiles.csv' every ::1 using 1:($3 == 1 ? $2 : 1/0) with points pt 7 ps 0.5 title 'worn ring, h = 1 mm', \\
     'profiles.csv' every ::1 using 1:($3 < 1 ? $2 : 1/0) with points pt 6 ps 0.3 title 'h = 0.5 mm', \\
     30 - sqrt(900 - (x - 100)**2) with lines lc 0 title 'as it was'
set ylabel 'p [MPa]'; set key bottom center
plot [80:120][0:11000] 'pressure.csv' every ::1 using 1:($3 == 1 ? $2 : 1/0) with linespoints pt 7 ps 0.4 title 'pressure after 3 s, h = 1 mm', \\
     'pressure.csv' every ::1 using 1:($3 < 1 ? $2 : 1/0) with points pt 6 ps 0.3 title 'h = 0.5 mm'
unset multiplot
""")
