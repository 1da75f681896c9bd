"""Results of a run, from its folder or from memory."""
import json
import os
import pathlib
from collections.abc import Mapping, Sequence

import numpy

from . import _reye
from .errors import InputError, Issue

_COUNTS = {"frame", "newton", "node", "nodes_before", "nodes_after", "fresh_facets"}


def bytes_of(text):
    """A text or path as the program takes it, whatever bytes it stands for."""
    return text.encode("utf-8", "surrogateescape")


def _damaged(file, what):
    return InputError(f"{file} is damaged: {what}", [Issue(file, None, "", "", what)])


def columns(text, file, ended=True):
    """Arrays by the names of the columns of a table. `ended`: its run has ended, so that a row that is cut is damage."""
    if ended and not text.endswith("\n"):
        raise _damaged(file, "its last row is cut")
    try:
        found = _reye.columns(bytes_of(text))
    except RuntimeError as error:
        raise _damaged(file, str(error)) from None
    return {name: numpy.array(cells) if isinstance(cells, list) else
            numpy.frombuffer(cells).astype(int if name in _COUNTS else float) for name, cells in found.items()}


class Frame(Mapping):
    """A surface at one moment: arrays by column, a value per node along the surface.

    Plane: arc_length_mm, x_mm, y_mm, pressure_MPa, shear_MPa, slip_mm, wear_depth_mm, status ("inactive", "stick",
    "slip"), body. Solids: node, x_mm, y_mm, z_mm, pressure_MPa, shear_x_MPa ..., slip_x_mm ..., area_mm2, wear_depth_mm,
    status, body. `cycle` is the moment; `number` counts frames from 0.
    """

    def __init__(self, table, rows):
        self._table, self._rows = table, rows
        self.cycle = float(table["cycle"][rows.start])
        self.number = int(table["frame"][rows.start])

    def __getitem__(self, column):
        return self._table[column][self._rows]

    def __iter__(self):
        return (name for name in self._table if name not in ("frame", "cycle"))

    def __len__(self):
        return len(self._table) - 2

    def __repr__(self):
        return f"<frame {self.number} at cycle {self.cycle:g}: {', '.join(self)}>"


class Surface(Sequence):
    """One side of a contact: its frames, in their order, the last one at [-1]."""

    def __init__(self, table):
        self._table = table
        starts = numpy.flatnonzero(numpy.diff(table["frame"], prepend=-1)) if len(table["frame"]) else []
        ends = [*starts[1:], len(table["frame"])]
        self._rows = [slice(int(start), int(end)) for start, end in zip(starts, ends)]

    @property
    def cycles(self):
        """The cycle of each frame."""
        return numpy.array([frame.cycle for frame in self])

    def __len__(self):
        return len(self._rows)

    def __getitem__(self, index):
        return Frame(self._table, self._rows[index])

    def __repr__(self):
        return f"<surface of {len(self)} frames>"


class Surfaces(Mapping):
    """Surfaces by contact and side: surfaces["pad", "secondary"]. The secondary side carries the contact tractions, the
    primary one is its partner; a bond has a secondary side alone."""

    def __init__(self, run):
        self._run = run
        self._read = {}

    def __getitem__(self, key):
        contact, side = key if isinstance(key, tuple) and len(key) == 2 else (str(key), "")
        file = f"surface_{_reye.file_part(bytes_of(contact))}_{side}.csv"
        if file not in self._run.tables:
            known = ", ".join(map(repr, self)) or "none"
            raise KeyError(f"there is no surface {key!r}; there are: {known}")
        if file not in self._read:
            self._read[file] = Surface(self._run.table(file))
        return self._read[file]

    def __iter__(self):
        names = (name[len("surface_"):-len(".csv")] for name in self._run.tables if name.startswith("surface_"))
        return (tuple(name.rsplit("_", 1)) for name in names)

    def __len__(self):
        return sum(1 for _ in self)


class Run:
    """The results of a run, finished or not.

    summary   the content of summary.json: status, cycles, contacts, probes, life_cycles, warnings, counts, times ...
              Contacts and bonds are found by name: summary["contacts"]["pad"]
    history   arrays by column, a value per increment: step, cycle, progress, newton, pressure_max_MPa,
              depth_max_secondary_mm, ..., and columns of each contact, support and bond with their units
    remeshes  arrays by column, a row per body remeshed; empty where none was
    surfaces  Surfaces by contact and side; each holds its frames
    frames    files of the frames for ParaView, in their order (none of a run in memory)
    folder    the folder; None of a run in memory
    status    "done", "interrupted", "failed", or "running" where the folder holds no end of the run: it still computes, or
              was killed
    """

    def __init__(self, tables, folder=None):
        self.tables = tables
        self.folder = folder
        self.summary = json.loads(tables["summary.json"]) if "summary.json" in tables else {}
        self.surfaces = Surfaces(self)
        self._history = self._remeshes = None

    @property
    def status(self):
        return self.summary.get("status", "running")

    @property
    def history(self):
        if self._history is None:
            self._history = self.table("history.csv")
        return self._history

    @property
    def remeshes(self):
        if self._remeshes is None:
            self._remeshes = self.table("remesh.csv") if "remesh.csv" in self.tables else {}
        return self._remeshes

    @property
    def frames(self):
        return sorted((self.folder / "frames").glob("bodies_*.vtu")) if self.folder else []

    def table(self, file):
        """Arrays by column of a table of the folder by its file name: "history.csv"."""
        if file not in self.tables:
            raise _damaged(str(self.folder / file), "it is missing") if self.folder else KeyError(file)
        return columns(self.tables[file], str(self.folder / file) if self.folder else file, self.status != "running")

    def __repr__(self):
        return f"<run {self.status} at cycle {self.summary.get('cycles', 0):g}, {self.folder or 'in memory'}>"


class _Files(Mapping):
    """The texts of the tables of a folder by file name, read when they are asked for."""

    def __init__(self, folder):
        self._folder = folder

    def __getitem__(self, name):
        try:
            return (self._folder / name).read_text(encoding="utf-8", errors="surrogateescape")
        except FileNotFoundError:
            raise KeyError(name) from None

    def __contains__(self, name):
        return (self._folder / name).is_file()

    def __iter__(self):
        return (file.name for pattern in ("*.csv", "summary.json") for file in sorted(self._folder.glob(pattern)))

    def __len__(self):
        return sum(1 for _ in self)


def read(folder):
    """The results in the output folder of a run, finished or not, a `Run`. Raises InputError where the folder holds none,
    or where a file is damaged."""
    folder = pathlib.Path(os.fspath(folder))
    if not (folder / ".reye.json").is_file():
        raise InputError(f"{folder} holds no run of reye", [Issue(str(folder), None, "", "", "holds no run of reye")])
    try:
        return Run(_Files(folder), folder)
    except ValueError as error:
        raise _damaged(str(folder / "summary.json"), str(error)) from None
