"""Runs a scene for every combination of values of two keys and prints the table.

  sweep_two_keys.py [FOLDER]
"""
import pathlib
import sys

import reye

geo = pathlib.Path(__file__).resolve().parents[3] / "geo"
folder = sys.argv[1] if len(sys.argv) > 1 else "two_keys.sweep"

scene = reye.Scene(geo / "fretting_demo/scene.toml")
scene["step[2].cycles"] = 1200

frictions, forces = "contact.pad.friction", "support.holder.y.force_N_per_mm"
sweep = reye.sweep(scene, {frictions: [0.6, 0.9], forces: [-15.0, -20.0]}, out=folder)

print("friction  force N/mm  status  depth um")
for friction, force, status, depth in zip(sweep[frictions], sweep[forces], sweep["status"],
                                          sweep["contacts.pad.secondary.max_depth_mm"]):
    print(f"{friction:8}  {force:10}  {status:6}  {1e3 * depth:8.4f}")
print("all columns:", ", ".join(sweep.table))
