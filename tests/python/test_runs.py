"""A run from Python and one of the command leave the same bytes, but for times."""
import os
import pathlib
import shutil
import subprocess
import sys
import unittest

import numpy

import places
import reye


class Runs(places.Place):
    def test_folder_is_that_of_the_command(self):
        """A folder written from Python holds what the command writes, file by file."""
        scene = self.saved(places.small_scene(cad=True))
        run = scene.run(out="python")
        told = places.command("run", scene.path, "--out", "command", "--quiet")
        self.assertEqual(told.returncode, 0, told.stderr)
        self.assert_same_results("python", "command")
        self.assertEqual((run.status, len(run.frames)), ("done", len(run.surfaces["pad", "secondary"])))

    def test_solids(self):
        """Solids do so, too, and their tables in memory are those of the folder."""
        scene = self.saved(places.small_solid())
        run = scene.run(out="python")
        self.assertEqual(places.command("run", scene.path, "--out", "command", "--quiet").returncode, 0)
        self.assert_same_results("python", "command")
        kept = scene.run()
        for file in ("history.csv", "surface_pad_secondary.csv"):
            self.assertEqual(kept.tables[file], run.tables[file])
        self.assertGreater(kept.surfaces["pad", "secondary"][-1]["pressure_MPa"].max(), 100)

    def test_in_memory(self):
        """A run without a folder writes nothing and has the tables and the summary of one with a folder, run after run in
        one process."""
        scene = self.saved(places.small_scene())
        before = sorted(os.walk("."))
        first, second = scene.run(), scene.run(threads=1)
        self.assertEqual(sorted(os.walk(".")), before)
        folder = scene.run(out="out")
        for run in (first, second):
            self.assertEqual(sorted(run.tables), sorted(folder.tables))
            for file in run.tables:
                if file == "summary.json":
                    self.assertEqual(places.without_times(run.tables[file]), places.without_times(folder.tables[file]))
                else:
                    self.assertEqual(run.tables[file], folder.tables[file])

    def test_arrays_are_the_tables(self):
        """Arrays hold the numbers of the tables; frames divide them."""
        run = self.saved(places.small_scene()).run()
        lines = run.tables["history.csv"].splitlines()
        self.assertEqual(list(run.history), lines[0].split(","))
        self.assertEqual([f"{step},{cycle:g}" for step, cycle in zip(run.history["step"], run.history["cycle"])],
                         [",".join(line.split(",")[:2]) for line in lines[1:]])
        surface = run.surfaces["pad", "secondary"]
        self.assertEqual(list(surface.cycles[-2:]), [200, 400])
        self.assertEqual(sum(len(frame["x_mm"]) for frame in surface),
                         len(run.tables["surface_pad_secondary.csv"].splitlines()) - 1)
        depth = max(frame["wear_depth_mm"].max() for frame in surface)
        self.assertEqual(depth, run.summary["contacts"]["pad"]["secondary"]["max_depth_mm"])
        self.assertEqual(list(run.surfaces), [("pad", "primary"), ("pad", "secondary")])
        for key in (("bad", "secondary"), "pad"):
            with self.assertRaisesRegex(KeyError, "there are: .'pad', 'primary'"):
                run.surfaces[key]

    def test_stop_and_restart(self):
        """A run that its callback stops, resumed, leaves the bytes of an unbroken one; blocks come in their order."""
        scene = self.saved(places.small_scene())
        scene.run(out="unbroken")
        seen = []

        def until_200(progress):
            seen.append(progress)
            return numpy.bool_(progress.cycle < 200)

        half = scene.run(out="out", callback=until_200)
        self.assertEqual((half.status, seen[-1].cycle, seen[-1].cycles), ("interrupted", 200, 400))
        self.assertGreater(seen[-1].depth_max_mm, 0)
        self.assertEqual(scene.run(out="out", restart=True).status, "done")
        self.assert_same_results("out", "unbroken")

    def test_exception_in_a_callback(self):
        """An exception of a callback ends the run and is raised as it was; the folder resumes."""
        scene = self.saved(places.small_scene())

        def fail(progress):
            raise LookupError("of the callback")

        with self.assertRaisesRegex(LookupError, "of the callback"):
            scene.run(out="out", callback=fail)
        self.assertEqual(reye.read("out").status, "interrupted")
        self.assertEqual(scene.run(out="out", restart=True).status, "done")
        with self.assertRaisesRegex(LookupError, "of the callback"):
            scene.run(callback=fail)

    def test_a_run_within_a_callback(self):
        """A callback may itself run a scene; both end with their own results."""
        scene, inner = self.saved(places.small_scene()), []
        outer = scene.run(callback=lambda progress: inner.append(scene.run()) if not inner else None)
        self.assertEqual(inner[0].tables["history.csv"], outer.tables["history.csv"])

    def test_a_failed_run(self):
        """A run that fails is raised with the reason of the command, and has its results so far."""
        scene = places.small_scene()
        scene["support.holder.y.force_N_per_mm"] = 5.0  # lifts off
        scene = self.saved(scene)
        with self.assertRaises(reye.RunError) as caught:
            scene.run()
        told = places.command("run", scene.path, "--out", "command", "--quiet")
        self.assertEqual(told.returncode, 1)
        self.assertIn(str(caught.exception), told.stderr)
        self.assertEqual(caught.exception.run.status, "failed")

    def test_threads_of_others_are_left(self):
        """After a run numpy multiplies as before."""
        a = numpy.random.default_rng(1).random((200, 200))
        before = a @ a
        self.saved(places.small_scene()).run()
        self.assertTrue((a @ a == before).all())

    def test_installed_elsewhere(self):
        """The package finds what reads geometry under any prefix, whatever the working folder is; without it, it says so."""
        prefix, build = pathlib.Path("prefix").absolute(), pathlib.Path(places.COMMAND).parents[1]
        package = prefix / "lib/python3/dist-packages"
        shutil.copytree(pathlib.Path(reye.__file__).parent, package / "reye")
        shutil.copytree(build / "lib", prefix / "lib", dirs_exist_ok=True)
        scene = self.saved(places.small_scene(cad=True))
        code = "import os, reye; os.chdir('/'); print(reye.check(%r).lines[0])" % os.path.abspath(scene.path)
        told = subprocess.run([sys.executable, "-c", code], env={"PYTHONPATH": os.path.relpath(package)},
                              capture_output=True, text=True)
        self.assertIn("holds bin/reye-import", told.stderr)
        (prefix / "bin").mkdir()
        shutil.copy(build / "bin/reye-import", prefix / "bin")
        told = subprocess.run([sys.executable, "-c", code], env={"PYTHONPATH": os.path.relpath(package)},
                              capture_output=True, text=True)
        self.assertTrue(told.stdout.startswith("body cylinder"), told.stderr)

    def test_bad_options(self):
        """Options that mean nothing are refused before anything is written."""
        scene = self.saved(places.small_scene())
        for options in ({"restart": True}, {"out": ""}, {"out": "out", "threads": 0}):
            with self.assertRaises(ValueError):
                scene.run(**options)
        with self.assertRaisesRegex(TypeError, "callback = 3"):
            scene.run(callback=3)
        with self.assertRaisesRegex(reye.InputError, "no checkpoint"):
            scene.run(out="out", restart=True)
        self.assertFalse(os.path.exists("out"))


if __name__ == "__main__":
    unittest.main()
