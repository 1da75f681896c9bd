"""Runs a scene into a folder, stops half way, resumes, and reads the folder.

  read_a_run.py [FOLDER]
"""
import pathlib
import sys

import reye

geo = pathlib.Path(__file__).resolve().parents[3] / "geo"
folder = sys.argv[1] if len(sys.argv) > 1 else "half_way.out"

scene = reye.Scene(geo / "fretting_demo/scene.toml")
scene["step[2].cycles"] = 2400
print(scene.plan(trial_s=0.1))

half = scene.run(out=folder, callback=lambda progress: progress.cycle < 1200)  # False ends the run
print(half)
scene.run(out=folder, restart=True)

run = reye.read(folder)  # of any run, also of one that the command has made
print(run)
print("frames for ParaView:", len(run.frames))
print("columns of the history:", ", ".join(run.history))
last = run.surfaces["pad", "secondary"][-1]
print(last)
print("largest pressure", last["pressure_MPa"].max(), "MPa at", last["x_mm"][last["pressure_MPa"].argmax()], "mm")
