#!/usr/bin/env python3
"""C2: a block worn by a ring over 3600 m, beside the closed form of B8 at four distances."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import remesh_case as meshes  # noqa: E402
import wear_case as case  # noqa: E402

P, K, R, E_STAR = 10.833333333, 2.0e-9, 20.0, 210e3 / (2.0 * (1.0 - 0.3 ** 2))
A0_SQUARED = 4.0 * P * R / (3.141592653589793 * E_STAR)
DISTANCES_M = (800, 1600, 2400, 3600)


def closed_form(metres):
    """Half width and depth of the rigid limit, and the depth with the elastic term of the half-plane solution."""
    a = (1.5 * R * K * P * 1e3 * metres) ** (1.0 / 3.0)
    return a, a * a / (2.0 * R), (a * a - 0.1975 * A0_SQUARED) / (2.0 * R)


SECOND_ORDER = [('material = "steel"', 'material = "steel"\norder    = 2'), ("size_mm = 0.020", "size_mm = 0.040")]  # as many nodes

run = case.run("block_on_ring", "base")
second = case.run("block_on_ring", "second_order", SECOND_ORDER)
frames, second_frames = run.frames("secondary"), second.frames("secondary")
worn = run.contact["secondary"]
measured = {
    "ledger": run.contact["ledger_relative_error"],
    "worn_area_over_k_P_s": worn["worn_area_mm2"] / (K * P * 3.6e6),
    "remeshes": run.summary["counts"]["remeshes"],
    "scaled_jacobian": meshes.poorest_scaled_jacobian(run),
    "most_nodes": meshes.most_nodes(run),
    "depth_3600_m_um": 1e3 * worn["max_depth_mm"],
    "width_3600_m_mm": worn["scar_width_mm"],
    "cutbacks": run.summary["counts"]["cutbacks"],
    "second_order_ledger": second.contact["ledger_relative_error"],
    "second_order_cutbacks": second.summary["counts"]["cutbacks"],
}
for name in ("max_depth_mm", "scar_width_mm", "worn_area_mm2"):
    measured[f"second_order_over_first_{name}"] = second.contact["secondary"][name] / worn[name]
profiles = []
for metres in DISTANCES_M:
    rows = meshes.at_cycle(frames, metres)
    _, rigid, elastic = closed_form(metres)
    depth = max(r["wear_depth_mm"] for r in rows)
    measured[f"depth_over_rigid_{metres}_m"] = depth / rigid
    measured[f"depth_over_elastic_{metres}_m"] = depth / elastic
    deepest = max(r["wear_depth_mm"] for r in meshes.at_cycle(second_frames, metres))
    measured[f"second_order_over_first_depth_{metres}_m"] = deepest / depth
    for x, y in meshes.outline(rows):
        if abs(x) <= 1.6:
            profiles.append((metres, x, 1e3 * y))
    profiles.append(("", "", ""))
case.write_measured(measured)
case.write_csv("profiles.csv", ["sliding_m", "x_mm", "y_um"], profiles)
deepest_second = {c: max(r["wear_depth_mm"] for r in rows) for c, rows in second_frames}
case.write_csv("depth.csv", ["sliding_m", "depth_um", "rigid_um", "second_order_um"],
               [(c, 1e3 * max(r["wear_depth_mm"] for r in rows), 1e3 * closed_form(c)[1], 1e3 * deepest_second[c])
                for c, rows in frames if c > 0.0])
forms = ", ".join(f"(abs(x) < {a} ? 1e3 * (x * x / (2 * {R}) - {d}) : 0) with lines lw 0.7 lc 0 {title}"
                  for (a, d, _), title in zip(map(closed_form, DISTANCES_M), ["title 'closed form'"] + 3 * ["notitle"]))
case.figure(f"""
set multiplot layout 2,1
set xlabel 'x [mm]'; set ylabel 'y [um]'; set samples 801; set key top center horizontal
plot [-1.6:1.6][-50:12] 'profiles.csv' every ::1 using 2:3:1 with lines lw 3 lc rgb '#80b0e0' title 'worn block, 800, 1600, 2400, 3600 m', {forms}
set xlabel 'sliding [m]'; set ylabel 'depth [um]'; set key bottom right
set object 1 rectangle from 3540,44.5 to 3660,48.7 fillstyle solid 0.3 noborder fillcolor rgb '#e08030'
set label 1 'measured' at 3520,46.6 right
plot [0:3700][0:52] 'depth.csv' every ::1 using 1:2 with points pt 7 ps 0.4 title 'Reye', \\
     'depth.csv' every ::1 using 1:4 with points pt 6 ps 0.8 title 'second order', \\
     'depth.csv' every ::1 using 1:3 with lines lc 0 title 'closed form'
unset multiplot
""")
