#!/usr/bin/env python3
"""A pin worn to a fifth of its radius; the same with half the element, half the jump, both, and with triangles."""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import remesh_case as meshes  # noqa: E402
import wear_case as case  # noqa: E402

SCENE, R, AREA_PER_CYCLE, CYCLE = "pin_worn_flat", 5.0, 1e-7 * 0.3 * 40.0 * 1000.0, 3200.0
HALF_H = [(" size_mm = 0.02", " size_mm = 0.01"), ("far_size_mm = 0.5", "far_size_mm = 0.25"), ("far_size_mm = 0.8", "far_size_mm = 0.4")]
HALF_JUMP = [("jump = 5\n", "jump = 2.5\n"), ("jump = 25\n", "jump = 12.5\n")]
VARIANTS = {"base": [], "half_h": HALF_H, "half_jump": HALF_JUMP, "half_both": HALF_H + HALF_JUMP,
            "triangles": [('element = "quad"', 'element = "tri"')]}


def cut_depth(area):
    """Depth d at which a disc has lost this area: R^2 (t - sin t cos t), cos t = 1 - d / R."""
    low, high = 0.0, R
    for _ in range(60):
        d = 0.5 * (low + high)
        t = math.acos(1.0 - d / R)
        low, high = (d, high) if R * R * (t - math.sin(t) * math.cos(t)) < area else (low, d)
    return d


def tip(run, cycle):
    return meshes.outline([r for r in meshes.at_cycle(run.frames("secondary"), cycle) if r["y_mm"] < 2.0])


runs = {name: case.run(SCENE, name, words) for name, words in VARIANTS.items()}
base = runs["base"]
d = cut_depth(AREA_PER_CYCLE * CYCLE)
a = math.sqrt(2.0 * R * d - d * d)
disc = [(0.01 * k, max(d, R - math.sqrt(R * R - 1e-4 * k * k))) for k in range(-400, 401)]
facet = max(abs(q[0] - p[0]) for p, q in zip(tip(base, CYCLE), tip(base, CYCLE)[1:]) if abs(p[0]) < a)
measured = {
    "life_cycles": base.summary["life_cycles"]["fifth"],
    "ledger": max(r.contact["ledger_relative_error"] for r in runs.values()),
    "cutbacks": sum(r.summary["counts"]["cutbacks"] for r in runs.values()),
    "remeshes": base.summary["counts"]["remeshes"],
    "most_nodes": max(map(meshes.most_nodes, runs.values())),
    "depth_over_closed_form": meshes.value(tip(base, CYCLE), 0.0) / d,
}
for name, run in runs.items():
    measured[f"scaled_jacobian_{name}"] = meshes.poorest_scaled_jacobian(run)
    if run is not base:
        measured[f"life_{name}"] = run.summary["life_cycles"]["fifth"] / base.summary["life_cycles"]["fifth"]
for name, other in [("disc", disc)] + [(name, tip(run, CYCLE)) for name, run in runs.items() if name != "base"]:
    measured[f"profile_to_{name}_rms"] = meshes.difference(tip(base, CYCLE), other, 3.5, d)[1]
    measured[f"profile_to_{name}_but_for_corner"] = meshes.difference(tip(base, CYCLE), other, 3.5, d, corner=(a, facet))[0]
    measured[f"profile_to_{name}"] = meshes.difference(tip(base, CYCLE), other, 3.5, d)[0]
case.write_measured(measured)
case.write_csv("profiles.csv", ["cycle", "x_mm", "y_mm"],
               [(c, x, y) for c in (200.0, 800.0, 1600.0, 2400.0, CYCLE) for x, y in tip(base, c) if abs(x) < 3.7])
case.write_csv("remeshes.csv", ["cycle", "body", "nodes_after", "scaled_jacobian_after"],
               [(r["cycle"], r["body"], r["nodes_after"], r["scaled_jacobian_after"]) for r in meshes.remeshes(base)])
flat = " , ".join(f"(abs(x) < {math.sqrt(2 * R * v - v * v)} ? {v} : 5 - sqrt(25 - x * x)) with lines lw 0.7 lc 0 {title}"
                  for v, title in [(cut_depth(AREA_PER_CYCLE * c), "title 'disc cut off'" if c == 200.0 else "notitle")
                                   for c in (200.0, 800.0, 1600.0, 2400.0, CYCLE)])
case.figure(f"""
set multiplot layout 2,1
set xlabel 'x [mm]'; set ylabel 'y [mm]'; set samples 801; set key top center
plot [-3.7:3.7][-0.1:1.8] 'profiles.csv' every ::1 using 2:3 with points pt 7 ps 0.3 lc rgb '#4080c0' title 'worn pin, 200, 800, 1600, 2400, 3200 m', {flat}
set xlabel 'sliding [m]'; set ylabel 'nodes'; set key bottom left
plot [0:3500][0:1000] "< grep pin remeshes.csv" using 1:3 with linespoints pt 7 ps 0.4 title 'nodes of the pin after each remesh', \\
     "< grep plate remeshes.csv" using 1:3 with linespoints pt 6 ps 0.5 title 'nodes of the plate'
unset multiplot
""")
