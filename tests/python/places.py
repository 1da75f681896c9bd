"""What the tests of the Python module share: a small scene, the command, and results without times."""
import atexit
import functools
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import reye

SOURCE = pathlib.Path(__file__).resolve().parents[2]
COMMAND = os.environ["REYE_COMMAND"]
TIMES = ("wall_s", "cpu_s", "peak_rss_MB", "room_seconds", "phase_seconds")


@functools.cache
def _mesh():
    """The mesh of the small scene as a file: reading CAD takes longer than running on it."""
    folder = tempfile.TemporaryDirectory()
    atexit.register(folder.cleanup)
    command("mesh", SOURCE / "geo/fretting_demo/scene.toml", "--out", folder.name)
    return f"{folder.name}/mesh.vtu"


def small_scene(cad=False):
    """A wearing contact of four blocks, in some tenths of a second; on a mesh from a file, or from CAD."""
    scene = reye.Scene(SOURCE / "geo/fretting_demo/scene.toml")
    if not cad:
        scene["geometry"] = [_mesh()]
    scene["step[0].increments"] = 2
    scene["step[1].increments"] = 4
    scene["step[2].increments"] = 8
    scene["step[2].cycles"] = 400
    scene["step[2].jump"] = 100
    scene["output.frames.every_cycles"] = 200
    scene["output.checkpoint_s"] = 0
    return scene


def small_solid():
    """A ball on a flat in space, on some tetrahedra."""
    scene = reye.Scene(SOURCE / "geo/ball_on_flat/scene.toml")
    for body in ("ball", "flat"):
        scene[f"body.{body}.mesh"] = {"far_size_mm": 20.0}
    scene["contact.pad.fine_zone.size_mm"] = 0.6
    scene["contact.pad.wear"] = {"law": "energy", "secondary_mm3_per_J": 1e-5}
    scene["step[0].increments"] = 2
    scene["step[1].increments"] = 4
    return scene


def without_times(summary):
    return {key: value for key, value in json.loads(summary).items() if key not in TIMES}


def results(folder):
    """All files of an output folder by name, with times left out: what must not depend on when and how it ran."""
    folder = pathlib.Path(folder)
    files = {str(file.relative_to(folder)): file.read_bytes() for file in folder.rglob("*") if file.is_file()}
    for changing in ("log.txt", "report.html"):
        files.pop(changing)
    files["summary.json"] = without_times(files["summary.json"])
    return files


def command(*words):
    return subprocess.run([COMMAND, *map(str, words)], capture_output=True, text=True)


class Place(unittest.TestCase):
    """A test with a folder of its own, in which it works."""

    def setUp(self):
        self._kept = tempfile.TemporaryDirectory()
        self.addCleanup(self._kept.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self._kept.name)

    def assert_same_results(self, one, other):
        a, b = results(one), results(other)
        self.assertEqual(sorted(a), sorted(b))
        self.assertEqual([], [file for file in a if a[file] != b[file]])

    def saved(self, scene, folder="scene"):
        """The scene as a file of this place, read again."""
        os.makedirs(folder, exist_ok=True)
        scene.save(f"{folder}/scene.toml")
        return reye.Scene(f"{folder}/scene.toml")
