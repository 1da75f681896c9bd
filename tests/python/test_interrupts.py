"""Ctrl-C ends a run where it can resume, and Python lives on beside a run."""
import os
import pathlib
import signal
import subprocess
import sys
import threading
import time
import unittest

import places
import reye

WITH_CTRL_C = """
import os, signal, sys, reye
scene = reye.Scene("scene/scene.toml")
before = [signal.getsignal(s) for s in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGCHLD)]
def callback(progress):
    if progress.cycle == 200:
        os.kill(os.getpid(), signal.SIGINT)
try:
    scene.run(out="out", callback=callback)
except KeyboardInterrupt:
    print(reye.read("out").status)
assert before == [signal.getsignal(s) for s in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGCHLD)]
scene.run(out="out", restart=True)
"""


class Interrupts(places.Place):
    def test_ctrl_c(self):
        """Ctrl-C raises KeyboardInterrupt with a folder that resumes to the bytes of an unbroken run; handlers stay."""
        scene = places.small_scene()
        scene["step[2].increments"] = 80  # a block takes longer than signals wait to be looked for
        self.saved(scene).run(out="unbroken")
        told = subprocess.run([sys.executable, "-c", WITH_CTRL_C], capture_output=True, text=True)
        self.assertEqual((told.returncode, told.stdout), (0, "interrupted\n"), told.stderr)
        self.assert_same_results("out", "unbroken")

    def test_handlers_of_python_act(self):
        """A signal handler of the caller is called while a run computes, and may end it by an exception."""
        scene = places.small_scene()
        scene["step[2].increments"] = 80
        calls = []

        def handler(number, frame):
            calls.append(number)
            if len(calls) == 2:
                raise TimeoutError("of the handler")

        before = signal.signal(signal.SIGALRM, handler)
        signal.setitimer(signal.ITIMER_REAL, 0.1, 0.1)
        try:
            with self.assertRaisesRegex(TimeoutError, "of the handler"):
                for _ in range(100):  # before the second signal a run may have ended
                    scene.run()
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
            signal.signal(signal.SIGALRM, before)

    def test_ctrl_c_in_a_sweep(self):
        """Ctrl-C ends the members of a sweep; called again it continues."""
        scene = places.small_scene()
        scene["step[2].cycles"] = 100000
        scene = self.saved(scene)
        script = "import reye; reye.sweep('scene/scene.toml', {'contact.pad.friction': [0.3, 0.6]}, out='out', jobs=1)"
        process = subprocess.Popen([sys.executable, "-c", script], stderr=subprocess.PIPE, text=True)
        started = pathlib.Path("out/member_000/checkpoint/current.bin")
        while not started.exists() and process.poll() is None:
            time.sleep(0.01)
        process.send_signal(signal.SIGINT)
        self.assertIn("KeyboardInterrupt", process.communicate()[1])
        self.assertEqual(reye.read("out/member_000").status, "interrupted")
        self.assertFalse(pathlib.Path("out/member_001/history.csv").exists())

    def test_other_threads_continue(self):
        """A thread of Python counts on while a run computes, and two threads run one after the other."""
        scene = places.small_scene()
        scene["step[2].increments"] = 40
        scene.run()
        stop, count = threading.Event(), [0]

        def work():
            while not stop.is_set():
                count[0] += 1
                time.sleep(0.001)

        counter = threading.Thread(target=work)
        counter.start()
        start = time.monotonic()
        runs = []
        runners = [threading.Thread(target=lambda: runs.append(scene.run())) for _ in range(2)]
        for runner in runners:
            runner.start()
        for runner in runners:
            runner.join()
        passed_s = time.monotonic() - start
        stop.set()
        counter.join()
        self.assertGreater(count[0], 20 * passed_s)  # of up to 1000 a second; none where the lock is held
        self.assertEqual(runs[0].tables["history.csv"], runs[1].tables["history.csv"])


if __name__ == "__main__":
    unittest.main()
