"""Changes a key of a scene and compares the results."""
import pathlib

import reye

geo = pathlib.Path(__file__).resolve().parents[3] / "geo"

scene = reye.Scene(geo / "fretting_demo/scene.toml")
scene["step[2].cycles"] = 3600

print("friction  energy mJ/mm  depth um")
for friction in (0.6, 0.9):
    scene["contact.pad.friction"] = friction
    history = scene.run().history
    print(f"{friction:8}  {history['energy_mJ_per_mm'][-1]:12.4g}  {1e3 * history['depth_max_secondary_mm'].max():8.4f}")

scene["contact.pad.friction"] = -1  # an error is found when the scene is run, planned or checked
try:
    scene.check()
except reye.InputError as error:
    for issue in error.issues:
        print(f"line {issue.line}: {issue.key} = {issue.value}: {issue.rule}")
