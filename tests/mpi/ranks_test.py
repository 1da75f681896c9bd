"""Runs on two ranks are those of one process; a rank that is killed ends the run with a reason, and it resumes.

  ranks_test.py BUILD      where BUILD/bin/reye was built with REYE_MPI
"""
import csv
import json
import math
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

BUILD = pathlib.Path(sys.argv.pop(1)).resolve()
REYE = BUILD / "bin" / "reye"
GEO = pathlib.Path(__file__).resolve().parents[2] / "geo"
MPIRUN = ["mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none", "-n", "2"]


def run(scene, out, *words, ranks=True):
    return subprocess.run([*(MPIRUN if ranks else []), REYE, "run", GEO / scene / "scene.toml", "--out", out, "--quiet", *words],
                          capture_output=True, text=True, timeout=600)


def rows(folder):
    with open(folder / "history.csv", newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def apart(a, b):
    """Largest difference of two columns of numbers, in their largest value."""
    size = max(map(abs, a), default=0.0)
    return max((abs(x - y) for x, y in zip(a, b)), default=0.0) / size if size else 0.0


def children(pid):
    told = subprocess.run(["ps", "-o", "pid=", "--ppid", str(pid)], capture_output=True, text=True).stdout
    return [int(word) for word in told.split()]


class Ranks(unittest.TestCase):
    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.place = pathlib.Path(kept.name)

    def test_increments_are_those_of_one_process(self):
        """Every number of the history of a ball that is pressed and slides agrees to 1e-10 of its column."""
        for name, ranks in (("one", False), ("two", True)):
            done = run("sliding_ball", self.place / name, ranks=ranks)
            self.assertEqual(done.returncode, 0, done.stderr)
        one, two = rows(self.place / "one"), rows(self.place / "two")
        self.assertEqual(len(one), len(two))
        for column in one[0]:
            try:
                a, b = ([float(row[column] or "nan") for row in table] for table in (one, two))
            except ValueError:
                continue
            if column.endswith("_s") or any(map(math.isnan, a + b)):
                continue   # times
            self.assertLess(apart(a, b), 1e-10, column)

    def test_a_life_is_that_of_one_process(self):
        """Depth and volume after a thousand cycles by tolerance agree within it, with remeshes on the way."""
        told = []
        for name, ranks in (("one", False), ("two", True)):
            done = run("ball_worn_flat_solid", self.place / name, ranks=ranks)
            self.assertEqual(done.returncode, 0, done.stderr)
            told.append(json.loads((self.place / name / "summary.json").read_text()))
        for contact, summary in told[0]["contacts"].items():
            for key, value in summary["secondary"].items():
                if isinstance(value, float):
                    self.assertAlmostEqual(told[1]["contacts"][contact]["secondary"][key], value, delta=0.01 * abs(value), msg=key)

    def lost(self, rank):
        """Kills a rank once a checkpoint is there; the run ends within a minute, says so, and resumes."""
        out = self.place / f"lost{rank}"
        command = subprocess.Popen([*MPIRUN, REYE, "run", GEO / "ball_worn_flat_solid" / "scene.toml", "--out", out, "--quiet"],
                                   stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        deadline = time.monotonic() + 300
        while time.monotonic() < deadline and not list(out.glob("checkpoint/current.bin")):
            time.sleep(0.2)
        self.assertTrue(list(out.glob("checkpoint/current.bin")), "no checkpoint within five minutes")
        os.kill(sorted(children(command.pid))[rank], signal.SIGKILL)
        told, _ = command.communicate(timeout=60)
        self.assertNotEqual(command.returncode, 0)
        self.assertIn("signal 9", told)
        done = run("ball_worn_flat_solid", out, "--restart")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(json.loads((out / "summary.json").read_text())["status"], "done")

    def test_the_first_rank_is_lost(self):
        self.lost(0)

    def test_another_rank_is_lost(self):
        self.lost(1)


if __name__ == "__main__":
    unittest.main()
