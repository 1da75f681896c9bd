#!/usr/bin/env python3
"""C1 carried on until the flat is 0.1 mm deep; the same with half the element, with half the jump, and with triangles."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import remesh_case as meshes  # noqa: E402
import wear_case as case  # noqa: E402

SCENE, CYCLE, REACH = "fretting_deep", 3.4e6, 1.9
VARIANTS = {"base": [],
            "half_h": [("size_mm = 0.010", "size_mm = 0.005"), ("far_size_mm = 0.8", "far_size_mm = 0.4")],
            "half_jump": [(f"jump = {n}\n", f"jump = {n // 2}\n") for n in (100, 600, 6000, 50000)],
            "triangles": [('element = "quad"', 'element = "tri"')]}


def scar(run, side, cycle=CYCLE):
    return [p for p in meshes.outline(meshes.at_cycle(run.frames(side), cycle)) if abs(p[0]) < 2.5 and abs(p[1]) < 3.0]


def deepest(run, side):
    return max(r["wear_depth_mm"] for r in meshes.at_cycle(run.frames(side), CYCLE))


runs = {name: case.run(SCENE, name, words) for name, words in VARIANTS.items()}
base = runs["base"]
flat, disc = base.contact["secondary"], base.contact["primary"]
measured = {
    "life_cycles": base.summary["life_cycles"]["deep"],
    "worn_area_ratio": disc["worn_area_mm2"] / flat["worn_area_mm2"],
    "ledger": max(r.contact["ledger_relative_error"] for r in runs.values()),
    "scar_width_flat_mm": flat["scar_width_mm"],
    "remeshes": base.summary["counts"]["remeshes"],
    "cutbacks_over_increments": base.summary["counts"]["cutbacks"] / base.summary["counts"]["increments"],
}
for name, run in runs.items():
    measured[f"scaled_jacobian_{name}"] = meshes.poorest_scaled_jacobian(run)
    measured[f"most_nodes_{name}"] = meshes.most_nodes(run)
    if run is base:
        continue
    measured[f"life_{name}"] = run.summary["life_cycles"]["deep"] / base.summary["life_cycles"]["deep"]
    measured[f"depth_{name}"] = deepest(run, "secondary") / deepest(base, "secondary")
    for side, body in (("secondary", "flat"), ("primary", "cylinder")):
        largest, rms = meshes.difference(scar(run, side), scar(base, side), REACH, deepest(base, side))
        measured[f"profile_{body}_{name}"], measured[f"profile_{body}_{name}_rms"] = largest, rms
case.write_measured(measured)
CYCLES = (200000.0, 1e6, 2e6, CYCLE)
case.write_csv("profiles.csv", ["cycle", "body", "x_mm", "y_um"],
               [(c, body, x, 1e3 * y) for body, side in (("flat", "secondary"), ("cylinder", "primary"))
                for c in CYCLES for x, y in scar(base, side, c) + [(float("nan"), float("nan"))] if not abs(x) > 1.9])
case.write_csv("profile_half_h.csv", ["x_mm", "y_um"], [(x, 1e3 * y) for x, y in scar(runs["half_h"], "secondary") if abs(x) < 1.9][::4])
case.write_csv("remeshes.csv", ["cycle", "body", "nodes_after", "scaled_jacobian_after"],
               [(r["cycle"], r["body"], r["nodes_after"], r["scaled_jacobian_after"]) for r in meshes.remeshes(base)])
case.figure("""
set multiplot layout 2,1
set xlabel 'x [mm]'; set ylabel 'y [um]'; set key bottom left
plot [-1.9:1.9][-140:20] "< grep flat profiles.csv" using 3:4 with lines lw 2 title 'flat after 0.2, 1, 2 and 3.4 million cycles', \\
     'profile_half_h.csv' every ::1 using 1:2 with points pt 7 ps 0.25 lc rgb '#e08030' title 'half the element'
set key top center
plot [-1.9:1.9][0:330] "< grep cylinder profiles.csv" using 3:4 with lines lw 2 title 'cylinder', \\
     1e3 * (6 - sqrt(36 - x * x)) with lines lc 0 title 'as it was'
unset multiplot
""")
