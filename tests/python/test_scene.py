"""Scenes are read and changed by their keys, and their errors are those of the command."""
import os
import pathlib
import unittest

import numpy

import places
import reye


class Scenes(places.Place):
    def test_values(self):
        """A value that is put at a key is read there; the text keeps all else."""
        scene = reye.Scene(places.SOURCE / "geo/fretting_demo/scene.toml")
        before = scene.text
        self.assertEqual((scene["contact.pad.friction"], scene["step[2].jump"]), (0.9, {"tolerance": 0.01}))
        for key, value in {"contact.pad.friction": 0.5, "step[2].jump": {"tolerance": 0.02}, "title": 'a "b" \\ µ\n',
                           "support.holder.x": "free", "contact.pad.primary": ["round"], "limit.life.stop": True,
                           "history.press": [[0.0, 0.0], [1.0, 1.0]], "step[2].cycles": 10**6}.items():
            scene[key] = value
            self.assertEqual(scene[key], value, key)
        scene["contact.pad.friction"] = numpy.float64(0.25)
        scene["step[0].increments"] = numpy.int64(3)
        self.assertEqual((scene["contact.pad.friction"], scene["step[0].increments"]), (0.25, 3))
        self.assertEqual(len(before.splitlines()) + 1, len(scene.text.splitlines()))  # limit.life.stop
        self.assertIn("limit.life.stop", scene)
        self.assertNotIn("limit.life.wear_factor", scene)
        self.assertEqual(pathlib.Path(scene.path).read_text(), before)

    def test_unknown_keys(self):
        """An unknown key is refused with the one that was meant; so is one that is left to its default."""
        scene = places.small_scene()
        before = scene.text
        with self.assertRaisesRegex(reye.InputError, "did you mean friction") as caught:
            scene["contact.pad.frction"] = 0.5
        self.assertEqual(caught.exception.issues[0].key, "contact.pad.frction")
        for key, why in (("contact.pad.frction", "did you mean friction"), ("step[9].jump", r"no step\[9\]"),
                         ("limit.life.wear_factor", "default"), ("contact.pad.friction.x", "")):
            with self.assertRaisesRegex(KeyError, why):
                scene[key]
        with self.assertRaises(TypeError):
            scene["title"] = object()
        self.assertEqual(scene.text, before)

    def test_solids_have_their_keys(self):
        """Keys of solids are those of solids."""
        scene = places.small_solid()
        self.assertEqual(scene["contact.pad.fine_zone.size_mm"], 0.6)
        with self.assertRaises(reye.InputError):
            scene["boundary.top"] = {"body": "ball", "type": "line"}

    def test_saved_elsewhere(self):
        """A saved scene has the geometry of the first, in any folder."""
        scene = places.small_scene(cad=True)
        saved = self.saved(scene, "deep/down")
        self.assertEqual(saved["geometry"], [str(places.SOURCE / "geo/fretting_demo/cylinder_on_flat.step")])
        self.assertEqual(str(saved.check()), str(scene.check()))
        again = reye.Scene("deep/down/scene.toml")
        again.save("deep/down/other.toml")
        self.assertEqual(pathlib.Path("deep/down/other.toml").read_bytes(), saved.text.encode())

    def test_errors_are_those_of_the_command(self):
        """All errors come at once, with file, line, key, value and rule, and the text of the command."""
        scene = places.small_scene()
        scene["material.steel.nu"] = 0.7
        scene["contact.pad.friction"] = -1
        scene.save("bad.toml")
        told = places.command("run", "bad.toml")
        self.assertEqual(told.returncode, 2)
        with self.assertRaises(reye.InputError) as caught:
            reye.Scene("bad.toml")
        self.assertEqual(str(caught.exception), told.stderr.rstrip("\n"))
        issues = caught.exception.issues
        self.assertEqual([(i.file, i.key, i.value) for i in issues],
                         [("bad.toml", "material.steel.nu", "0.7"), ("bad.toml", "contact.pad.friction", "-1")])
        lines = pathlib.Path("bad.toml").read_text().splitlines()
        for issue in issues:
            self.assertIn(issue.value, lines[issue.line - 1])
            self.assertTrue(issue.rule)
        for ask in (scene.run, scene.check, scene.plan, lambda: scene.run(out="out")):
            with self.assertRaises(reye.InputError) as again:
                ask()
            self.assertEqual(len(again.exception.issues), 2)
        self.assertFalse(os.path.exists("out"))

    def test_errors_of_geometry(self):
        """What only the geometry shows has its line, too."""
        scene = places.small_scene()
        scene["boundary.face.nearest_mm"] = [900.0, 0.0]
        scene["body.flat.at"] = [50.0, 50.0]
        with self.assertRaises(reye.InputError) as caught:
            scene.check()
        self.assertTrue(all(issue.line and issue.file == scene.path for issue in caught.exception.issues))

    def test_no_scene(self):
        """A file that does not exist, or is no scene, says so."""
        with self.assertRaises(FileNotFoundError):
            reye.Scene("nowhere.toml")
        pathlib.Path("broken.toml").write_bytes(b"title = [\xff\n")
        with self.assertRaisesRegex(reye.InputError, "is not TOML") as caught:
            reye.Scene("broken.toml")
        self.assertEqual(caught.exception.issues[0].line, 1)

    def test_plan_and_check(self):
        """They say what the command prints, and write nothing."""
        scene = self.saved(places.small_scene())
        told = places.command("check", scene.path)
        self.assertEqual(told.stdout, str(reye.check(scene)) + "\nok\n")
        plan = reye.plan(scene.path, trial_s=0.05)
        told = places.command("plan", scene.path, "--trial", "0")
        self.assertEqual(told.stdout.splitlines(), str(reye.plan(scene, trial_s=0)).splitlines())
        self.assertGreater(plan.forecast["increments"], 30)
        self.assertIn("seconds", plan.forecast)
        self.assertEqual(os.listdir("."), ["scene"])
        solid = self.saved(places.small_solid(), "solid")
        self.assertEqual(places.command("check", solid.path).stdout, str(solid.check()) + "\nok\n")
        self.assertEqual(solid.plan().forecast, {"increments": 6})


if __name__ == "__main__":
    unittest.main()
