#!/usr/bin/env python3
"""Two crossed wires that fret: worn depths of both beside half-spaces computed on their own (half_space.py)."""
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent), str(HERE)]
import half_space  # noqa: E402
import wear_case as case  # noqa: E402

ALPHA, CYCLES, STROKE = 2.0e-8, 5000.0, 0.05          # mm3/mJ of either wire; mm
LIMIT = 0.005                                          # mm of both wires together
LATER = 500.0                                          # from here on the scar is wide enough for the cells of the half-spaces

run = case.run("crossed_wires", "base")
contact, counts = run.contact, run.summary["counts"]
upper, lower = contact["secondary"], contact["primary"]
energy = 2.0 * contact["dissipated_energy_mJ"]                    # of both halves
slid = energy / (4.0 * half_space.MU * half_space.P * CYCLES)   # the stroke less what the wires give way by
rows, wires = half_space.worn(slid, ALPHA, CYCLES)
together = [(c, u + w) for c, u, w in rows]
own = [case.Line([(c, d[k]) for c, *d in rows]) for k in (0, 1)]
ends = [r for r in run.history if r["step"] == "fretting" and abs(r["progress"] - 1.0) < 1e-9 and r["cycle"] < CYCLES]
depths = [(r["cycle"], r["crossing_depth_max_secondary_mm"], r["crossing_depth_max_primary_mm"]) for r in ends]
depths.append((CYCLES, upper["max_depth_mm"], lower["max_depth_mm"]))
depths.sort()


def off(k):
    """Largest difference of a wire's depth from that of the half-spaces, relative, and that at the end."""
    shares = [abs(d[k] / own[k](c) - 1.0) for c, *d in depths if LATER < c < CYCLES]
    return max(shares), abs(depths[-1][k + 1] / rows[-1][k + 1] - 1.0)


measured = {
    "ledger": contact["ledger_relative_error"],
    "balance": run.summary["balance"],
    "worn_volume_over_alpha_E": max(abs(s["worn_volume_mm3"] / (ALPHA * contact["dissipated_energy_mJ"]) - 1.0) for s in (upper, lower)),
    "slid_over_stroke": slid / STROKE,
    "upper_depth_off": off(0)[0],
    "upper_depth_off_at_the_end": off(0)[1],
    "lower_depth_off": off(1)[0],
    "lower_depth_off_at_the_end": off(1)[1],
    "life_over_half_spaces": run.summary["life_cycles"]["allowed"] / next(
        a + (LIMIT - low) / (high - low) * (b - a) for (a, low), (b, high) in zip(together, together[1:]) if low <= LIMIT <= high),
    "life_cycles": run.summary["life_cycles"]["allowed"],
    "cycles_solved": counts["cycles_solved"],
    "remeshes": counts["remeshes"],
}
case.write_measured(measured)
case.write_csv("depth.csv", ["cycle", "upper_um", "lower_um", "half_space_upper_um", "half_space_lower_um"],
               [(c, 1e3 * u, 1e3 * w, 1e3 * own[0](min(c, CYCLES - 1e-6)), 1e3 * own[1](min(c, CYCLES - 1e-6))) for c, u, w in depths])


def middle(side):
    """Depth along x at the plane of symmetry."""
    return sorted((r["x_mm"], 1e3 * r["wear_depth_mm"]) for r in run.last(side) if r["y_mm"] < 1e-6 and abs(r["x_mm"]) < 0.22)


case.write_csv("profiles.csv", ["wire", "x_mm", "depth_um"],
               [(name, *p) for name, side in (("upper", "secondary"), ("lower", "primary")) for p in middle(side)]
               + [("half_" + name, x, 1e3 * w[0]) for name, grid in (("upper", wires.upper), ("lower", wires.lower))
                  for x, w in zip(wires.x, grid)])
case.figure("""
set multiplot layout 2,1
set xlabel 'cycle'; set ylabel 'depth [um]'; set key bottom right
plot [0:5000][0:5] 'depth.csv' every ::1 using 1:2 with points pt 7 ps 0.5 title 'upper wire', \\
     'depth.csv' every ::1 using 1:3 with points pt 7 ps 0.5 lc rgb '#e08030' title 'lower wire', \\
     'depth.csv' every ::1 using 1:4 with lines lc 0 title 'half-spaces', 'depth.csv' every ::1 using 1:5 with lines lc 0 notitle
set xlabel 'x [mm]'; set ylabel 'depth [um]'; set key top right
plot [-0.2:0.2][5:0] "< grep '^upper' profiles.csv" using 2:3 with lines lw 2 title 'upper wire', \\
     "< grep '^lower' profiles.csv" using 2:3 with lines lw 2 lc rgb '#e08030' title 'lower wire', \\
     "< grep '^half_' profiles.csv" using 2:3 with points pt 6 ps 0.4 lc 0 title 'half-spaces'
unset multiplot
""")
