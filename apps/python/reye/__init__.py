"""Reye: how frictional contacts wear, from CAD and a load cycle to the worn shape and the wear life.

    import reye

    scene = reye.Scene("geo/fretting_demo/scene.toml")
    scene["contact.pad.friction"] = 0.6
    run = scene.run(out="my_run")
    print(run.summary["contacts"]["pad"]["peak_pressure_MPa"], "MPa")
    print(run.history["cycle"], run.history["depth_max_secondary_mm"])
    print(run.surfaces["pad", "secondary"][-1]["wear_depth_mm"].max(), "mm")

`Scene` holds a scene file and changes, checks and runs it; `read` opens the output folder of any run; `sweep` runs a
scene for every combination of values; `calibrate` finds wear coefficients from measured scars; `plan` and `check` report what a run will take and what a scene holds.

Units are fixed and are part of every key and column: mm, N, MPa, mJ = N mm, wear in mm^3/J or 1/MPa. Plane problems count
forces, energies and areas per mm of thickness, axisymmetric ones over the whole circumference.

Results equal those of the command `reye` to the last digit. One run computes at a time in a process, on all of its cores
(`threads`); other threads of Python continue meanwhile. Processes that multiprocessing forks after a run must not run
scenes themselves: let them begin by "spawn", or use `sweep`.
"""
from . import _reye
from .calibrate import Calibration, calibrate
from .errors import InputError, Issue, RunError, RunWarning
from .results import Frame, Run, Surface, Surfaces, read
from .scene import Check, Plan, Progress, Scene, check, plan
from .sweep import Sweep, sweep

__version__ = _reye.version
__all__ = ["Calibration", "Check", "Frame", "InputError", "Issue", "Plan", "Progress", "Run", "RunError", "RunWarning", "Scene", "Surface",
           "Surfaces", "Sweep", "calibrate", "check", "plan", "read", "sweep"]
