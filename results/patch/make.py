#!/usr/bin/env python3
"""Contact patch (references C3): straight and turned by 30 degrees, either side secondary."""
import math
import os
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from wear_case import ROOT, WORK, figure, run, write_csv, write_measured  # noqa: E402

SWAP = [('secondary = "upper_bottom"\nprimary   = ["lower_top"]', 'secondary = "lower_top"\nprimary   = ["upper_bottom"]')]
ANGLE = 30.0


def turned(x, y):
    c, s = math.cos(math.radians(ANGLE)), math.sin(math.radians(ANGLE))
    return c * x - s * y, s * x + c * y


def pair(x, y):
    return "[{:.17g}, {:.17g}]".format(*turned(x, y))


def turned_mesh():
    """The mesh with all its nodes turned, as a file of its own."""
    head, nodes, tail = re.split(r"(?<=\$Nodes\n)|(?=\$EndNodes)", (ROOT / "geo/patch/two_blocks.msh").read_text())
    lines = []
    for line in nodes.splitlines():
        words = line.split()
        lines.append("{:.17g} {:.17g} 0".format(*turned(float(words[0]), float(words[1]))) if len(words) == 3 else line)
    WORK.mkdir(parents=True, exist_ok=True)
    path = WORK / "turned.msh"
    path.write_text(head + "\n".join(lines) + "\n" + tail)
    return path


def turning():
    """Supports, load and probe of the scene in the turned axes."""
    angle = f"\nangle_deg = {ANGLE}"
    points = [(f"point_mm = [3.0, {y}]", f"point_mm = {pair(3.0, y)}{angle}") for y in (0.0, 6.0, 10.0)]
    return points + [('edge = "lower_bottom"', f'edge = "lower_bottom"{angle}'),
                     ("traction_MPa = [0.0, -100.0]", f"traction_MPa = {pair(0.0, -100.0)}"),
                     ("at_mm = [9.0, 10.0]", f"at_mm = {pair(9.0, 10.0)}"),
                     ('geometry = ["two_blocks.msh"]', f'geometry = ["{os.path.relpath(turned_mesh(), ROOT / "geo/patch")}"]')]


def main():
    measured, table = {}, []
    for name, changes, exact in (("straight", [], (0.24, -1.0)), ("swapped", SWAP, (0.24, -1.0)),
                                 ("turned", turning(), turned(0.24, -1.0)), ("turned_swapped", turning() + SWAP, turned(0.24, -1.0))):
        result = run("patch", name, changes)
        loaded = [r for r in result.last("secondary") if r["status"] != "inactive"]
        corner = result.summary["probes"]["corner"]
        measured[f"{name}_corner_error_mm"] = math.hypot(corner["u_x_mm"] - exact[0], corner["u_y_mm"] - exact[1])
        measured[f"{name}_force_error"] = result.contact["normal_force_N_per_mm"] / 600.0 - 1.0
        # A node of the larger side covered by less than half reports its force over its full length.
        whole = loaded if "swapped" not in name else loaded[2:-2]
        measured[f"{name}_pressure_error"] = max(abs(r["pressure_MPa"] / 100.0 - 1.0) for r in whole)
        table += [[name, r["arc_length_mm"], r["pressure_MPa"]] for r in loaded]
    write_csv("pressure.csv", ["case", "arc_length_mm", "pressure_MPa"], table)
    write_measured(measured)
    lines = ", ".join(f"'< grep ^{n}, pressure.csv' using 2:3 with linespoints title '{n}' noenhanced"
                      for n in ("straight", "swapped", "turned", "turned_swapped"))
    figure(f"set yrange [0:120]\nset xlabel 'arc length [mm]'\nset ylabel 'p [MPa]'\nset key bottom center notitle\nplot {lines}\n")


if __name__ == "__main__":
    main()
