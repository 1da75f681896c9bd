"""Memory stays flat over many runs in one process: by default 30, or as many as REYE_PYTHON_RUNS says."""
import os
import unittest

import places


def resident_MB():
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 2**20


class Memory(places.Place):
    def test_flat(self):
        """After a third of the runs the process takes no more memory; every fifth reads CAD."""
        runs = int(os.environ.get("REYE_PYTHON_RUNS", "30"))
        scenes = [places.small_scene(cad=i == 0) for i in range(5)]
        for scene in scenes:
            scene["step[2].cycles"] = 100
        sizes = []
        for i in range(runs):
            self.assertEqual(scenes[i % len(scenes)].run().status, "done")
            sizes.append(resident_MB())
        print(f"{runs} runs: {sizes[0]:.1f} MB after the first, {sizes[runs // 3]:.1f} after a third, {sizes[-1]:.1f} at the end")
        self.assertLess(sizes[-1], sizes[runs // 3] + 4)


if __name__ == "__main__":
    unittest.main()
