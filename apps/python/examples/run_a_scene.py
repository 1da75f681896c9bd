"""Runs the first cycles of the fretting demo, in memory, and prints how the wear grows."""
import pathlib

import reye

geo = pathlib.Path(__file__).resolve().parents[3] / "geo"

scene = reye.Scene(geo / "fretting_demo/scene.toml")
scene["step[2].cycles"] = 3600  # of 18 000


def show(progress):
    print(f"  {progress.step}: cycle {progress.cycle:g} of {progress.cycles:g}, {1e3 * progress.depth_max_mm:.3f} um deep")


run = scene.run(callback=show)

pad = run.summary["contacts"]["pad"]
print(f"{run.status}: peak pressure {pad['peak_pressure_MPa']:.0f} MPa, energy {pad['dissipated_energy_mJ_per_mm']:.3g} mJ/mm")
print("cycle    deepest um   worn width mm")
for frame in run.surfaces["pad", "secondary"]:
    worn = frame["wear_depth_mm"] > 0
    width = frame["x_mm"][worn].max() - frame["x_mm"][worn].min() if worn.any() else 0
    print(f"{frame.cycle:5.0f} {1e3 * frame['wear_depth_mm'].max():12.4f} {width:15.3f}")
