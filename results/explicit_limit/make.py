#!/usr/bin/env python3
"""Line contact in gross slip (B8) with jumps beyond the limit of explicit wear: the same increments implicit and explicit."""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import wear_case as case

H, K, E = 0.0018, 3.0e-8, 200e3 / (2.0 * (1.0 - 0.3 ** 2))     # element [mm], both coefficients [1/MPa], E* [MPa]
SLIDING = 0.021756417                                          # of a cycle [mm]
LIMIT = 4.0 * H / (math.pi * K * E)                            # sliding per increment that explicit wear stands [mm]
JUMPS = [20, 100, 500]


def jitter(rows):
    """Largest |p_j - (p_(j-1) + p_(j+1)) / 2| over the mean pressure, three elements inside the contact; unloaded nodes there."""
    p = [r["pressure_MPa"] for r in rows]
    loaded = [i for i, v in enumerate(p) if v > 0.0]
    first, last = loaded[0] + 3, loaded[-1] - 3
    mean = sum(p[first:last]) / (last - first)
    return max(abs(p[i] - 0.5 * (p[i - 1] + p[i + 1])) for i in range(first, last)) / mean, p[first:last].count(0.0)


measured, rows, profiles = {"limit_mm": LIMIT}, [], []
for jump in JUMPS:
    for implicit in ("true", "false"):
        name = "implicit" if implicit == "true" else "explicit"
        run = case.run("line_contact_gross_slip", f"{name}_{jump}",
                       [("imposed_sliding_mm", f"implicit = {implicit}\nimposed_sliding_mm"),
                        ("cycles = 4500\njump = 100", f"cycles = 4500\njump = {jump}")])
        last = run.last("secondary")
        value, gaps = jitter(last)
        rows.append((name, jump, jump * SLIDING / LIMIT, value, gaps, run.contact["peak_pressure_MPa"]))
        measured[f"{name}_{jump}_jitter"] = value
        if jump == 100:
            profiles.append([(r["x_mm"], r["pressure_MPa"]) for r in last if abs(r["x_mm"]) <= 0.1])
case.write_measured(measured)
case.write_csv("jitter.csv", ["wear", "jump", "sliding_over_limit", "jitter", "unloaded_inside", "peak_MPa"], rows)
case.write_csv("pressure.csv", ["x_mm", "implicit_MPa", "explicit_MPa"], [(a[0], a[1], b[1]) for a, b in zip(*profiles)])
case.figure("""
set xlabel 'x [mm]'; set ylabel 'p [MPa], jump 3.1 times the limit'
plot 'pressure.csv' every ::1 using 1:3 with linespoints pt 7 ps 0.3 title 'explicit', \\
     'pressure.csv' every ::1 using 1:2 with lines lw 2 title 'implicit'
""")
