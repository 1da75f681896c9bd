"""Wear coefficients, and other values, from measured scars."""
import json
import pathlib
import warnings

from . import _reye
from .errors import RunWarning
from .results import bytes_of
from .scene import Scene, _one_at_a_time, opened


class Calibration:
    """What the measurements say of a scene.

        fit["contact.pad.wear.secondary_mm3_per_J"]       # {"scene": ..., "fitted": ..., "low_95": ..., "high_95": ...}
        fit.scene                                          # the scene with the fitted values, a `Scene`
        fit.poor                                           # None, or why the fit is poor

    `values` holds an entry per value, in the unit of its key, `notes` what was assumed, `summary` all of
    calibration.json; `folder` has the page and its figures.
    """

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.summary = json.loads((self.folder / "calibration.json").read_text(encoding="utf-8"))
        self.values = {value["key"]: {name: value[name] for name in value if name != "key"} for value in self.summary["values"]}
        self.notes = self.summary["notes"]
        self.poor = self.summary["poor"]

    def __getitem__(self, key):
        return self.values[key]

    @property
    def scene(self):
        """The scene with the fitted values, and their interval as the scatter of its lives."""
        return Scene(self.folder / "scene.toml")

    def __repr__(self):
        return f"<calibration of {len(self.values)} values, {self.folder}>"


def calibrate(scene, measured, out, at=None, contact=None, side=None, free=None, threads=None, force=False,
              trust_geometry=False):
    """Finds the wear coefficients with which computed scars are as measured; a `Calibration`.

    scene           a `Scene`, with its changes, or the path of one; its coefficients are first guesses
    measured        a CSV file of a scar, or a TOML file of scars, loops and numbers, as geo/REFERENCE.md says
    out             output folder
    at              cycles after which those were measured that do not say it themselves
    contact, side   of those that do not name theirs; side "secondary" or "primary"
    free            bounds of further values to find by key: {"contact.pad.friction": (0.2, 0.9)}
    threads         cores to compute on; None: all physical ones
    force           write into a folder that holds something else
    trust_geometry  let geometry files do whatever gmsh can

    Raises InputError with all errors before anything runs, and RuntimeError with the reason where the measurements do not
    determine the values or a run fails; then nothing is written. A poor fit is given as a RunWarning.
    """
    words = [bytes_of(f"{key}={low}:{high}") for key, (low, high) in (free or {}).items()]
    with _one_at_a_time:
        folder, failure, texts = _reye.calibrate(opened(scene)._given(trust_geometry), bytes_of(str(measured)), words,
                                                 float(at or 0.0), bytes_of(contact or ""), bytes_of(side or ""),
                                                 bytes_of(str(out)), force, threads or 0)
    for text in texts:
        warnings.warn(text, RunWarning, stacklevel=2)
    if failure:
        raise RuntimeError(failure)
    return Calibration(folder)
