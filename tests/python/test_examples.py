"""The examples run as they stand and print results; the help names every part."""
import pathlib
import subprocess
import sys
import unittest

import places
import reye


class Examples(places.Place):
    def told(self, name, *words):
        file = places.SOURCE / "apps/python/examples" / name
        told = subprocess.run([sys.executable, "-W", "error", file, *words], capture_output=True, text=True)
        self.assertEqual(told.returncode, 0, told.stderr)
        return told.stdout

    def test_run_a_scene(self):
        """The depth grows from frame to frame."""
        rows = [line.split() for line in self.told("run_a_scene.py").split("worn width mm\n")[1].splitlines()]
        depths = [float(depth) for _, depth, _ in rows]
        self.assertTrue(len(depths) > 1 and depths == sorted(depths) and depths[-1] > depths[0], depths)

    def test_compare_frictions(self):
        """Two rows and the error of the third."""
        lines = self.told("compare_frictions.py").splitlines()
        self.assertEqual([line.split()[0] for line in lines[1:3]], ["0.6", "0.9"])
        self.assertRegex(lines[3], r"line \d+: contact.pad.friction = -1: ")

    def test_sweep_two_keys(self):
        """Four members are done."""
        self.assertEqual(self.told("sweep_two_keys.py").count("done"), 4)

    def test_read_a_run(self):
        """It stops half way, resumes and is done."""
        told = self.told("read_a_run.py")
        self.assertRegex(told, "(?s)run interrupted at cycle.*run done at cycle 2400.*largest pressure")

    def test_all_are_tested(self):
        """No example is without a test."""
        for file in (places.SOURCE / "apps/python/examples").glob("*.py"):
            self.assertTrue(hasattr(self, f"test_{file.stem}"), file.name)

    def test_help(self):
        """Everything that the package offers has a docstring."""
        for name in reye.__all__:
            part = getattr(reye, name)
            self.assertTrue(part.__doc__, name)
            for inner, value in vars(part).items() if isinstance(part, type) else ():
                if callable(value) and not inner.startswith("_"):
                    self.assertTrue(value.__doc__, f"{name}.{inner}")


if __name__ == "__main__":
    unittest.main()
