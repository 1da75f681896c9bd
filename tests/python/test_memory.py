"""Memory stays flat over many runs in one process: by default 30, or as many as REYE_PYTHON_RUNS says."""
import os
import statistics
import unittest

import places


def resident_MB():
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 2**20


class Memory(places.Place):
    def test_flat(self):
        """The last third of the runs takes no more memory than the third before; every fifth reads CAD."""
        runs = int(os.environ.get("REYE_PYTHON_RUNS", "30"))
        scenes = [places.small_scene(cad=i == 0) for i in range(5)]
        for scene in scenes:
            scene["step[2].cycles"] = 100
        sizes = []
        for i in range(runs):
            self.assertEqual(scenes[i % len(scenes)].run().status, "done")
            sizes.append(resident_MB())
        before = statistics.median(sizes[runs // 3:2 * runs // 3])   # single ones scatter by 4 MB with the allocator's pools
        at_end = statistics.median(sizes[2 * runs // 3:])
        print(f"{runs} runs: {sizes[0]:.1f} MB after the first, {before:.1f} in the second third, {at_end:.1f} in the last")
        self.assertLess(at_end, before + 3)


if __name__ == "__main__":
    unittest.main()
