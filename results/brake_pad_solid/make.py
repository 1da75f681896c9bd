#!/usr/bin/env python3
"""A brake pad that wears to a wedge, beside a rigid pad in balance on the same disc (rigid.py)."""
import math
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent), str(HERE)]
import rigid  # noqa: E402
import wear_case as case  # noqa: E402

REVOLUTIONS, LIMIT = 1.0e5, 0.7
CORNERS = {f"{side}_{rim}": (x, y) for side, x in (("leading", 30.0), ("trailing", -30.0)) for rim, y in (("inner", 80.0), ("outer", 120.0))}

run = case.run("brake_pad_solid", "base")
contact = run.contact
wedges = rigid.worn(REVOLUTIONS)


def at(rows, x, y):
    """Depth at the node beside a place."""
    return min(rows, key=lambda r: math.hypot(r["x_mm"] - x, r["y_mm"] - y))["wear_depth_mm"]


def wedge_at(revolution):
    k = min(int(revolution / REVOLUTIONS * (len(wedges) - 1)), len(wedges) - 2)
    (a, low), (b, high) = wedges[k], wedges[k + 1]
    return [u + (revolution - a) / (b - a) * (v - u) for u, v in zip(low, high)]


deepest = rigid.depth(wedges[-1][1], *CORNERS["leading_inner"])
life = next(a + (LIMIT - low) / (high - low) * (b - a) for (a, low), (b, high) in
            zip(*[iter([(n, rigid.depth(w, *CORNERS["leading_inner"])) for n, w in wedges][k:]) for k in (0, 1)]) if low <= LIMIT <= high)
rows = run.last("secondary")
last = run.history[-1]
measured = {
    "ledger": contact["ledger_relative_error"],
    "balance": run.summary["balance"],
    "worn_volume_over_rigid": contact["secondary"]["worn_volume_mm3"] / (rigid.WIDTH * rigid.LENGTH * wedges[-1][1][0]),
    "worn_volume_over_alpha_E": contact["secondary"]["worn_volume_mm3"] / (rigid.ALPHA * contact["dissipated_energy_mJ"]),
    "life_over_rigid": run.summary["life_cycles"]["lining"] / life,
}
for name, (x, y) in CORNERS.items():
    measured[f"{name}_depth_off"] = abs(at(rows, x, y) - rigid.depth(wedges[-1][1], x, y)) / deepest
measured.update({
    "tangential_force_at_the_end_N": contact["tangential_force_N"],
    "cycles_solved": run.summary["counts"]["cycles_solved"],
    "remeshes": run.summary["counts"]["remeshes"],
    "cutbacks": run.summary["counts"]["cutbacks"],
})
case.write_measured(measured)
names = list(CORNERS)
case.write_csv("corners.csv", ["revolution"] + [f"{n}_mm" for n in names] + [f"rigid_{n}_mm" for n in names],
               [(c, *(at(r, *CORNERS[n]) for n in names), *(rigid.depth(wedge_at(c), *CORNERS[n]) for n in names))
                for c, r in run.frames("secondary")])
case.write_csv("pressure.csv", ["x_mm", "pressure_MPa", "rigid_MPa"],
               sorted((r["x_mm"], r["pressure_MPa"], rigid.pressure(rigid.rate(wedges[-1][1]), wedges[-1][1], r["x_mm"], 100.0))
                      for r in rows if abs(r["y_mm"] - 100.0) < 1.0))
plots = ", ".join(f"'corners.csv' every ::1 using ($1/1e3):{k + 2} with points pt 7 lc {k + 1} title '{n.replace('_', ', ')}', "
                  f"'corners.csv' every ::1 using ($1/1e3):{k + 6} with lines lc 0 {'title ' + repr('rigid pad') if k == 3 else 'notitle'}"
                  for k, n in enumerate(names))
case.figure(f"""
set multiplot layout 2,1
set xlabel 'thousand revolutions'; set ylabel 'depth at the corners [mm]'; set key top left
plot [0:100][0:1.4] {plots}
set xlabel 'x along the middle of the pad, leading edge at 30 [mm]'; set ylabel 'pressure at the end [MPa]'
plot [-31:31][0:3] 'pressure.csv' every ::1 using 1:2 with points pt 7 ps 0.6 title 'Reye', \\
     'pressure.csv' every ::1 using 1:3 with lines lc 0 title 'rigid pad'
unset multiplot
""")
