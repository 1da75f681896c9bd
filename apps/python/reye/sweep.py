"""Sweeps: one scene with other values."""
import pathlib
import warnings

import numpy

from . import _reye
from .errors import RunWarning
from .results import bytes_of, read
from .scene import opened, toml


class Sweep:
    """The members of a sweep as a table.

        sweep["contact.pad.friction"]            # values of a key, one per member
        sweep["life_cycles.life"]                # numbers of the members' summaries; nan where one has none
        sweep.run(0)                             # all results of a member, a `Run`

    `table` holds all arrays by column; "member", "status" and "reason" are texts. `folder` holds sweep.csv, sweep.html and
    a folder per member.
    """

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        lines = (self.folder / "sweep.csv").read_text(encoding="utf-8", errors="surrogateescape").splitlines()
        rows = [_reye.cells(bytes_of(line)) for line in lines]
        self.table = {name: _array(name, cells) for name, *cells in zip(*rows)}

    def __getitem__(self, column):
        return self.table[column]

    def __len__(self):
        return len(self.table["member"])

    def run(self, number):
        """The results of a member, counted from 0."""
        return read(self.folder / str(self.table["member"][number]))

    def __repr__(self):
        done = int((self.table["status"] == "done").sum())
        return f"<sweep of {len(self)} members, {done} done, {self.folder}>"


def _array(name, cells):
    if name in ("member", "status", "reason"):
        return numpy.array(cells)
    try:
        return numpy.array([float(cell) if cell else numpy.nan for cell in cells])
    except ValueError:  # values of a key that are texts or lists
        return numpy.array(cells)


def sweep(scene, vary, out, jobs=None, force=False, trust_geometry=False):
    """Runs a scene for every combination of values and returns their table, a `Sweep`.

    scene           a `Scene`, with its changes, or the path of one
    vary            lists of values by key: {"contact.pad.friction": [0.3, 0.6], "step[1].jump": [50, 100]}; a text is
                    taken as the command takes it: "0.3:0.9:4", "log:1:100:3"
    out             folder of the sweep
    jobs            members that compute at once, on one core each; None: as many as there are cores
    force           run every member again, whatever its folder holds
    trust_geometry  let geometry files do whatever gmsh can

    Members are processes of the command `reye`, so that a crash ends one member alone. A sweep that is called again
    continues: finished members are not rerun, interrupted ones resume. A member that is not done is given as a RunWarning
    and by its status. Raises InputError with all errors of all members, before anything is written; Ctrl-C ends the
    members and is raised.
    """
    if jobs is not None and jobs < 1:
        raise ValueError(f"jobs = {jobs}: must be at least 1")
    words = [bytes_of(f"{key}={values if isinstance(values, str) else ','.join(map(toml, values))}")
             for key, values in vary.items()]
    for text in _reye.sweep(opened(scene)._given(trust_geometry), words, bytes_of(str(out)), jobs or 0, force):
        warnings.warn(text, RunWarning, stacklevel=2)
    return Sweep(out)
