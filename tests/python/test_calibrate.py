"""Calibrations from Python find what the command finds, and refuse what it refuses."""
import json
import pathlib
import subprocess
import tempfile
import unittest

import numpy

import reye
from places import COMMAND, small_scene

KEY = "contact.pad.wear.secondary_mm3_per_J"


def write_scar(folder):
    """The scar of the flat in a run with 1.25 times the coefficients, as a profilometer with an offset has it."""
    truth = small_scene()
    for key in (KEY, KEY.replace("secondary", "primary")):
        truth[key] = 1.25 * truth[key]
    last = truth.run().surfaces["pad", "secondary"][-1]
    inside = numpy.abs(last["x_mm"]) < 0.3
    rows = numpy.column_stack([last["x_mm"][inside], 1e3 * last["wear_depth_mm"][inside] + 5.0])
    path = folder / "scar.csv"
    numpy.savetxt(path, rows, delimiter=",", header="x_mm,depth_um", comments="", fmt="%.12g")
    return path


class Calibrations(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.folder = pathlib.Path(place.name)

    def test_equals_the_command(self):
        """A calibration gives the values of the command's, and the scene with them."""
        scene, scar = small_scene(), write_scar(self.folder)
        fit = reye.calibrate(scene, scar, self.folder / "fit", at=400, side="secondary", threads=1)
        self.assertAlmostEqual(fit[KEY]["fitted"] / (1.25 * scene[KEY]), 1.0, delta=0.02)
        self.assertLess(fit[KEY]["low_95"], fit[KEY]["fitted"])
        self.assertIsNone(fit.poor)
        self.assertAlmostEqual(fit.scene[KEY] / fit[KEY]["fitted"], 1.0, delta=1e-5)
        scene.save(self.folder / "scene.toml")
        subprocess.run([COMMAND, "calibrate", self.folder / "scene.toml", "--measured", scar, "--at", "400", "--side", "secondary",
                        "--out", self.folder / "command", "--quiet"], check=True, capture_output=True)
        told = json.loads((self.folder / "command" / "calibration.json").read_text(encoding="utf-8"))
        self.assertEqual(told["values"], fit.summary["values"])

    def test_bad_input(self):
        """What cannot be read is an InputError with all issues, before anything is written."""
        (self.folder / "scar.csv").write_text("x_mm,depth\n1,2\n", encoding="utf-8")
        with self.assertRaises(reye.InputError) as caught:
            reye.calibrate(small_scene(), self.folder / "scar.csv", self.folder / "fit")
        rules = " ".join(issue.rule for issue in caught.exception.issues)
        self.assertIn("both sides of contact \"pad\" wear", rules)
        self.assertIn("--at CYCLES", rules)
        self.assertFalse((self.folder / "fit").exists())


if __name__ == "__main__":
    unittest.main()
