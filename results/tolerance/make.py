#!/usr/bin/env python3
"""Tolerances of the cycle jump asked for, held and estimated: 42 short lives in gross and in partial slip."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from wear_case import figure, run, write_csv, write_measured  # noqa: E402

TOLERANCES = (0.03, 0.01, 0.003)
FIRST_ORDER = [('material = "steel"\nmesh', 'material = "steel"\norder = 1\nmesh')]
NO_LIMIT = [("[limit.life]\ncontact     = \"pad\"\ndepth_mm    = 1e-3\nstop        = true\nwear_factor = [0.5, 2.0]\n",
             "[remesh]\nautomatic = false\n")]


def life(cycles):
    return [("cycles = 2000\njump = 100", f"cycles = {cycles}\njump = JUMP")]


def partial(force, secondary, primary):
    """Driven by a tangential force below mu P, on elements that resolve the annulus of slip."""
    return [('x        = "fixed"\nrotation = "fixed"\ny        = { force_N_per_mm = -60.0',
             f'x        = {{ force_N_per_mm = {force}, history = "stroke" }}\nrotation = "fixed"\ny        = {{ force_N_per_mm = -60.0'),
            ('x        = { motion_mm = 0.02, history = "stroke" }', 'x        = "fixed"'),
            ("secondary_mm3_per_J = 3.0e-5", f"secondary_mm3_per_J = {secondary}"),
            ("primary_mm3_per_J = 2.0e-5", f"primary_mm3_per_J = {primary}"),
            ("half_width_mm = 0.12, depth_mm = 0.03, size_mm = 0.008", "half_width_mm = 0.045, depth_mm = 0.015, size_mm = 0.002")]


LIVES = {
    "gross_150": (150, []),
    "gross_300": (300, []),
    "gross_800": (800, []),
    "gross_2000": (2000, []),
    "partial_60_1000": (1000, partial(27, 6e-4, 4e-4)),
    "partial_60_3000": (3000, partial(27, 6e-4, 4e-4)),
    "partial_80_300": (300, partial(36, 3e-3, 0.0)),
}


def play(name, cycles, changes, jump, more=""):
    words = FIRST_ORDER + NO_LIMIT + life(cycles) + changes + [("JUMP", jump), ("[remesh]", more + "[remesh]")]
    return run("life_band", name, words)


def error_of(done, reference):
    """Both sides: profile in the mean over all that is worn, and largest depth; the larger one."""
    worst = 0.0
    for side in ("secondary", "primary"):
        rows, exact = done.last(side), reference.last(side)
        depth = max(r["wear_depth_mm"] for r in exact)
        if depth == 0.0:
            continue
        s = [r["arc_length_mm"] for r in exact]
        share = [0.5 * (s[min(i + 1, len(s) - 1)] - s[max(i - 1, 0)]) for i in range(len(s))]
        apart = sum(h * abs(a["wear_depth_mm"] - b["wear_depth_mm"]) for h, a, b in zip(share, rows, exact))
        worn = sum(h * b["wear_depth_mm"] for h, b in zip(share, exact))
        worst = max(worst, apart / worn, abs(max(r["wear_depth_mm"] for r in rows) - depth) / depth)
    return worst


def main():
    rows = []
    for name, (cycles, changes) in LIVES.items():
        short = cycles / 75
        reference = play(f"{name}_exact", cycles, changes, f"{{ tolerance = 0.2, first = 1, most = {short} }}")
        for newton in (30, 5):
            for tolerance in TOLERANCES:
                more = f"[solver]\nmax_newton = {newton}\n"
                done = play(f"{name}_{newton}_{tolerance}", cycles, changes, f"{{ tolerance = {tolerance} }}", more)
                estimate, error = done.summary["estimated_error"]["cycle_jump"], error_of(done, reference)
                said = any(w["kind"] == "tolerance" for w in done.summary["warnings"])
                counts = done.summary["counts"]
                rows.append((name, tolerance, newton, error, estimate, estimate / error, int(said), counts["cycles_solved"],
                             counts["refused_blocks"], counts["cutbacks"]))
                print(*rows[-1], flush=True)
    write_csv("tolerance.csv", ["life", "tolerance", "max_newton", "error", "estimate", "ratio", "warned", "cycles_solved",
                                "refused_blocks", "cutbacks"], rows)
    missed = [r for r in rows if r[3] > r[1]]
    write_measured({
        "runs": len(rows), "held": len(rows) - len(missed), "with_cutbacks": sum(r[9] > 0 for r in rows),
        "smallest_ratio": min(r[5] for r in rows), "largest_ratio": max(r[5] for r in rows),
        "missed_unsaid": sum(r[3] > r[1] and not r[6] for r in rows),
        "cycles_solved": sum(r[7] for r in rows)})
    figure("set logscale xy\nset xlabel 'true error'\nset ylabel 'estimate'\nset key top left notitle\n"
           "plot [1e-4:0.1] [1e-4:0.1] '< grep ^gross tolerance.csv' using 4:5 with points pt 7 title 'gross slip', "
           "'< grep ^partial tolerance.csv' using 4:5 with points pt 5 title 'partial slip', x with lines lc 'black' title 'equal', "
           "0.5*x with lines dt 2 lc 'black' title 'half', 5*x with lines dt 3 lc 'black' title 'five times'\n")


if __name__ == "__main__":
    main()
