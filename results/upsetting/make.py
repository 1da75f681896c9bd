#!/usr/bin/env python3
"""Upsetting a billet: the die's force on a mesh renewed as it deforms, against the same mesh carried through, at two sizes."""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from wear_case import figure, run, write_csv, write_measured  # noqa: E402

SIZES = (0.8, 0.4)   # mm
NO_FRAMES = ("frames = { every_increment = true }", "")


def curve(name, size, words=()):
    done = run("upsetting_remesh", name, [("far_size_mm = 0.8", f"far_size_mm = {size}"), NO_FRAMES, *words])
    return done, {round(row["progress"], 6): -row["die_force_y_N_per_mm"] for row in done.history}


def difference(reference, other):
    """Largest, root mean square, and work; relative, at the ends of the planned increments."""
    pairs = [(force, other[t]) for t, force in reference.items() if t in other]
    squares = sum((b - a) ** 2 for a, b in pairs) / sum(a * a for a, _ in pairs)
    return (max(abs(b / a - 1.0) for a, b in pairs), math.sqrt(squares),
            sum(b - a for a, b in pairs) / sum(a for a, _ in pairs))


def main():
    measured, curves = {}, {}
    for size in SIZES:
        plain, carried = curve(f"plain_{size}", size, [("[remesh]", "[remesh]\nautomatic = false")])
        renewed, fresh = curve(f"renewed_{size}", size)
        curves[size] = (carried, fresh)
        largest, rms, work = difference(carried, fresh)
        measured |= {f"largest_{size}": largest, f"rms_{size}": rms, f"work_{size}": work,
                     f"remeshes_{size}": renewed.summary["counts"]["remeshes"]}
    times = [t for t in curves[SIZES[0]][0] if all(t in c for pair in curves.values() for c in pair)]
    write_csv("force.csv", ["progress", *(f"{name}_{size}_N_per_mm" for size in SIZES for name in ("carried", "renewed"))],
              [[t, *(c[t] for size in SIZES for c in curves[size])] for t in times])
    write_measured(measured)
    figure("set xlabel 'way of the die [mm]'\nset ylabel 'force on the die [N/mm]'\nset key top left notitle\n"
           "set title 'upsetting to 60 % of the height'\n"
           "plot 'force.csv' skip 1 using (6*$1):2 with lines dt 2 title '0.8 mm, one mesh', "
           "'' skip 1 using (6*$1):3 with lines title '0.8 mm, renewed', "
           "'' skip 1 using (6*$1):4 with lines dt 2 lw 2 title '0.4 mm, one mesh', "
           "'' skip 1 using (6*$1):5 with lines lw 2 title '0.4 mm, renewed'\n")


if __name__ == "__main__":
    main()
