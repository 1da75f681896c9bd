"""Folders of runs and of sweeps are read as they are, and damage is refused."""
import pathlib
import unittest
import warnings

import numpy

import places
import reye


class Folders(places.Place):
    def test_read(self):
        """A run of the command is read whole: summary, history, surfaces, frames."""
        scene = self.saved(places.small_scene())
        self.assertEqual(places.command("run", scene.path, "--out", "out", "--quiet").returncode, 0)
        run, own = reye.read("out"), scene.run()
        self.assertEqual(run.status, "done")
        for name, column in run.history.items():
            self.assertTrue((column == own.history[name]).all(), name)
        self.assertTrue(run.history["newton"].dtype == int and run.history["step"][0] == "press")
        self.assertTrue(all(frame.is_file() for frame in run.frames))
        self.assertEqual(run.remeshes, {})

    def test_damage(self):
        """What is missing or cut is named."""
        with self.assertRaisesRegex(reye.InputError, "holds no run"):
            reye.read(".")
        self.saved(places.small_scene()).run(out="out")
        history = pathlib.Path("out/history.csv")
        text = history.read_text()
        for damaged, why in ((text[:-3], "cut"), (text + "1,2\n", "cells"), (text.replace("0.5", "x", 1), "not a number")):
            history.write_text(damaged)
            with self.assertRaisesRegex(reye.InputError, f"history.csv is damaged.*{why}"):
                reye.read("out").history
        history.unlink()
        with self.assertRaisesRegex(reye.InputError, "history.csv is damaged: it is missing"):
            reye.read("out").history
        pathlib.Path("out/summary.json").write_text("{")
        with self.assertRaisesRegex(reye.InputError, "summary.json is damaged"):
            reye.read("out")

    def test_another_run_is_not_replaced(self):
        """A folder of another scene is refused as by the command; force takes it over."""
        scene = self.saved(places.small_scene())
        scene.run(out="out")
        scene["contact.pad.friction"] = 0.4
        with self.assertRaises(reye.InputError) as caught:
            scene.run(out="out")
        self.assertEqual((caught.exception.issues[0].key, caught.exception.issues[0].line), ("--out", None))
        self.assertEqual(scene.run(out="out", force=True).status, "done")

    def test_sweep(self):
        """A sweep has a row per combination, its members are runs of the scene with these values, and it is that of the
        command."""
        scene = places.small_scene()
        scene["contact.pad.friction"] = 0.7  # in memory only
        sweep = reye.sweep(scene, {"contact.pad.friction": [0.3, 0.6], "step[2].jump": "50,100"}, out="out")
        self.assertEqual(list(sweep["contact.pad.friction"]), [0.3, 0.3, 0.6, 0.6])
        self.assertEqual(list(sweep["step[2].jump"]), [50, 100, 50, 100])
        self.assertEqual(set(sweep["status"]), {"done"})
        self.assertTrue(numpy.isnan(sweep["life_cycles.life"]).all())
        scene["contact.pad.friction"] = 0.6
        alone = scene.run()
        self.assertEqual(sweep.run(3).tables["history.csv"], alone.tables["history.csv"])
        self.assertEqual(sweep["contacts.pad.peak_pressure_MPa"][3], alone.summary["contacts"]["pad"]["peak_pressure_MPa"])
        told = places.command("sweep", self.saved(scene, "fretting_demo").path, "--vary", "contact.pad.friction=0.3,0.6",
                              "--vary", "step[2].jump=50,100", "--out", "command", "--quiet")
        self.assertEqual(told.returncode, 0, told.stderr)
        of_command = reye.Sweep("command")
        for name in sweep.table:
            if name not in places.TIMES:
                self.assertTrue(numpy.array_equal(sweep[name], of_command[name], equal_nan=sweep[name].dtype == float), name)

    def test_members_that_fail(self):
        """A member that fails is a warning and a row with the reason; bad values of any member are refused before."""
        scene = places.small_scene()
        force = "support.holder.y.force_N_per_mm"
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            sweep = reye.sweep(scene, {force: [-18.5, 5.0]}, out="out")
        self.assertEqual(list(sweep["status"]), ["done", "failed"])
        self.assertTrue(sweep["reason"][1])
        self.assertTrue(any("member_001" in str(w.message) and w.category is reye.RunWarning for w in caught))
        with self.assertRaisesRegex(reye.InputError, "member_001.*friction"):
            reye.sweep(scene, {"contact.pad.friction": [0.5, -1]}, out="bad")
        with self.assertRaisesRegex(reye.InputError, "did you mean"):
            reye.sweep(scene, {"contact.pad.frction": [0.5]}, out="bad")
        self.assertFalse(pathlib.Path("bad").exists())


if __name__ == "__main__":
    unittest.main()
