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
    return [int(word) for word in pathlib.Path(f"/proc/{pid}/task/{pid}/children").read_text().split()]


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
        compared = 0
        for column in one[0]:
            try:
                a, b = ([float(row[column] or "nan") for row in table] for table in (one, two))
            except ValueError:
                continue
            if column.endswith("_s") or any(map(math.isnan, a + b)):
                continue   # times
            self.assertLess(apart(a, b), 1e-10, column)
            compared += max(map(abs, a)) > 0
        self.assertGreater(compared, 10)

    def test_a_life_is_that_of_one_process(self):
        """Depth and volume after a thousand cycles by tolerance agree within it, with remeshes on the way."""
        told = []
        for name, ranks in (("one", False), ("two", True)):
            done = run("ball_worn_flat_solid", self.place / name, ranks=ranks)
            self.assertEqual(done.returncode, 0, done.stderr)
            told.append(json.loads((self.place / name / "summary.json").read_text()))
        [one], [two] = (summary["contacts"].values() for summary in told)
        for key in ("max_depth_mm", "worn_volume_mm3"):
            value = one["secondary"][key]
            self.assertGreater(value, 0)
            self.assertAlmostEqual(two["secondary"][key], value, delta=0.01 * value, msg=key)

    def lost(self, rank, resumed_on_ranks):
        """Kills a rank once a checkpoint is there; the run ends within a minute, says so, and resumes on any number of them."""
        out = self.place / f"lost{rank}"
        command = subprocess.Popen([*MPIRUN, REYE, "run", GEO / "ball_worn_flat_solid" / "scene.toml", "--out", out, "--quiet"],
                                   stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        deadline = time.monotonic() + 300
        while time.monotonic() < deadline and not list(out.glob("checkpoint/current.bin")):
            time.sleep(0.2)
        self.assertTrue(list(out.glob("checkpoint/current.bin")), "no checkpoint within five minutes")
        ranks = sorted(children(command.pid))
        os.kill(ranks[rank], signal.SIGKILL)
        deadline = time.monotonic() + 60
        told, _ = command.communicate(timeout=60)
        while any(pathlib.Path(f"/proc/{pid}").exists() for pid in ranks):   # mpirun may end a moment before the last of them
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.05)
        self.assertNotEqual(command.returncode, 0)
        self.assertIn("signal 9", told)
        done = run("ball_worn_flat_solid", out, "--restart", ranks=resumed_on_ranks)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(json.loads((out / "summary.json").read_text())["status"], "done")

    def test_the_first_rank_is_lost(self):
        self.lost(0, resumed_on_ranks=True)

    def test_another_rank_is_lost(self):
        self.lost(1, resumed_on_ranks=False)


if __name__ == "__main__":
    unittest.main()
