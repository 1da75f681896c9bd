"""Scenes: read, changed, checked, planned and run."""
import json
import os
import re
import threading
import tomllib
import warnings
from typing import NamedTuple

import numpy

from . import _reye
from .errors import RunError, RunWarning
from .results import Run, bytes_of, read

_one_at_a_time = threading.RLock()  # the number of cores belongs to the process


class Progress(NamedTuple):
    """A run at the end of a block of cycles, as its callback receives it.

    step                        name of the step
    cycle, cycles               cycles done, and of all steps
    fraction                    of the step, in [0, 1]
    depth_max_mm                largest wear depth of all contacts [mm]
    increments, increments_left increments solved so far, and an estimate of those to be solved
    """

    step: str
    cycle: float
    cycles: float
    fraction: float
    depth_max_mm: float
    increments: float
    increments_left: float


class Plan(NamedTuple):
    """What a run will take; its str() is what `reye plan` prints.

    lines     a sentence per body and contact, and per decision
    skipped   what is skipped, and why
    warnings  what to know before the run
    forecast  numbers by name: blocks, cycles, increments, seconds, spread (the time lies between seconds / spread and
              seconds * spread), memory_MB; without seconds where the time is not known. Of solids increments alone
    in_words  the forecast as sentences
    """

    lines: list
    skipped: list
    warnings: list
    forecast: dict
    in_words: list

    def __str__(self):
        return "\n".join(self.lines + [f"skipped: {text}" for text in self.skipped] + self.in_words)


class Check(NamedTuple):
    """What a scene holds; its str() is what `reye check` prints.

    lines     a line per body, boundary and contact, with lengths in mm, areas in mm^2, volumes in mm^3
    warnings  what to know before the run
    """

    lines: list
    warnings: list

    def __str__(self):
        return "\n".join(self.lines)


class Scene:
    """A scene file, whose values can be read and changed by the keys of geo/REFERENCE.md.

        scene = reye.Scene("geo/hertz/scene.toml")
        scene["contact.pad.friction"]            # 0.5
        scene["step[1].jump"] = {"tolerance": 0.01}
        "limit.life.depth_mm" in scene

    The file must be a scene without errors, else InputError is raised. The file is left alone; `save` writes the text as
    changed, and lines in errors count in `text`. Values are those of TOML: numbers, texts, truth values, lists and tables (dicts), in the units of their keys.
    """

    def __init__(self, path):
        """Reads the scene at `path`; raises InputError with all errors of the scene, FileNotFoundError without a file."""
        self._path = os.fspath(path)
        with open(path, encoding="utf-8", errors="surrogateescape", newline="") as file:
            self._text = file.read()
        self._given().read()

    @property
    def path(self):
        """The file that was read; paths of geometry count from it."""
        return self._path

    @property
    def text(self):
        """The scene as TOML, with all changes."""
        return self._text

    def __repr__(self):
        return f"reye.Scene({self._path!r})"

    def __getitem__(self, key):
        """The value that the scene has at a key. Raises KeyError where there is no such key, or where the scene leaves it
        to its default (geo/REFERENCE.md)."""
        value = tomllib.loads(self._text)
        try:
            for name, index in re.findall(r"([^.\[\]]+)|\[(\d+)\]", key) or [("", -1)]:
                value = value[name] if name else value[int(index)]
        except (KeyError, IndexError, TypeError):
            rule = _reye.rule_of_key(self._given(), bytes_of(key))
            raise KeyError(f"{key}: {rule or 'is not written in this scene: its default holds'}") from None
        return value

    def __contains__(self, key):
        try:
            self[key]
        except KeyError:
            return False
        return True

    def __setitem__(self, key, value):
        """Puts a value at a key; one that the scene lacks is added. Raises InputError for an unknown key. The value is
        checked together with all others, by `check`, `plan` or `run`: rules join several keys."""
        self._text = _reye.text_with(self._given(), bytes_of(key), bytes_of(toml(value)))

    def save(self, path):
        """Writes the text to a file, whole. In another folder its geometry is named by absolute paths."""
        same_folder = os.path.realpath(os.path.dirname(path) or ".") == os.path.realpath(os.path.dirname(self._path) or ".")
        text = self._text if same_folder else _reye.with_absolute_paths(self._given())
        _reye.write(os.fsencode(path), bytes_of(text))

    def check(self, trust_geometry=False):
        """Reads scene and geometry and meshes in memory; a `Check`. Raises InputError with all errors."""
        with _one_at_a_time:
            return Check(*_reye.check(self._given(trust_geometry)))

    def plan(self, trial_s=2.0, threads=None, trust_geometry=False):
        """A `Plan`: each body and contact, and what the run will take. Plane scenes are played for `trial_s` seconds to
        judge their time (0: not at all). Raises InputError with all errors."""
        with _one_at_a_time:
            return Plan(**_reye.plan(self._given(trust_geometry), trial_s, threads or 0))

    def run(self, out=None, callback=None, threads=None, restart=False, force=False, trust_geometry=False):
        """Runs the scene and returns its results, a `Run`.

        out             output folder, with the files of `reye run --out`. None: nothing is written; summary, history and
                        surfaces are kept in memory, frames for ParaView and the report are left out
        callback        called with a `Progress` at the end of each block; where it returns False the run ends there
        threads         cores to compute on, which changes no digit of the results; None: all physical ones
        restart         resume from the last checkpoint in the folder `out`
        force           take over a folder that holds another scene's run
        trust_geometry  let geometry files do whatever gmsh can, and take what time and memory they take

        Raises InputError for bad input, before anything is written, and RunError where the run fails. Ctrl-C, or an
        exception in the callback, ends the run after the increment that is being solved and is raised; a run in a folder
        then resumes with restart=True. While the geometry is read and meshed Ctrl-C waits for that to end. Warnings of
        the results are given as RunWarning.
        """
        if out is None and restart:
            raise ValueError("restart needs the folder of the run: out=...")
        if threads is not None and not 1 <= threads <= 1024:
            raise ValueError(f"threads = {threads}: must lie in [1, 1024]")
        if callback is not None and not callable(callback):
            raise TypeError(f"callback = {callback!r}: must be a function of a Progress")
        folder = "" if out is None else os.fspath(out)
        if out is not None and not folder:
            raise ValueError("out is empty: name a folder, or None for a run in memory")
        with _one_at_a_time:
            tables, notes = _reye.run(self._given(trust_geometry), bytes_of(folder), restart, force, threads or 0,
                                      callback and (lambda *numbers: _says_stop(callback(Progress(*numbers)))))
        run = Run(tables) if out is None else read(folder)
        for text in notes + [f"{warning['kind']}: {warning['text']}" for warning in run.summary["warnings"]]:
            warnings.warn(text, RunWarning, stacklevel=2)
        if run.status == "failed":
            raise RunError(run.summary["reason"], run)
        return run

    def _given(self, trust_geometry=False):
        return _reye.Text(bytes_of(self._text), bytes_of(self._path), trust_geometry)


def _says_stop(answer):
    return isinstance(answer, (bool, numpy.bool_)) and not answer


def toml(value):
    """A value as TOML writes it."""
    if hasattr(value, "tolist"):  # of numpy
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, (str, os.PathLike)):
        return json.dumps(os.fspath(value), ensure_ascii=False)
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(toml, value)) + "]"
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{name} = {toml(entry)}" for name, entry in value.items()) + " }"
    raise TypeError(f"a scene holds numbers, texts, truth values, lists and dicts, no {type(value).__name__}")


def check(scene, **options):
    """What a scene (`Scene`, or the path of one) holds: see `Scene.check`."""
    return opened(scene).check(**options)


def plan(scene, **options):
    """What a run of a scene (`Scene`, or the path of one) will take: see `Scene.plan`."""
    return opened(scene).plan(**options)


def opened(scene):
    """The scene, or the one at this path."""
    return scene if isinstance(scene, Scene) else Scene(scene)
