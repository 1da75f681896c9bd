"""Memory stays flat over many runs in one process: by default 30, or as many as REYE_PYTHON_RUNS says."""
import ctypes
import gc
import os
import statistics
import unittest

import places


class Allocated(ctypes.Structure):
    """mallinfo2 of glibc"""
    _fields_ = [(name, ctypes.c_size_t) for name in ("arena", "ordblks", "smblks", "hblks", "hblkhd", "usmblks", "fsmblks",
                                                     "uordblks", "fordblks", "keepcost")]


def allocated_MB():
    """What is allocated and not freed. Resident memory scatters by 5 MB with what the allocator keeps for later."""
    gc.collect()   # tables refer to each other until then
    mallinfo2 = ctypes.CDLL(None).mallinfo2
    mallinfo2.restype = Allocated
    info = mallinfo2()
    return (info.uordblks + info.hblkhd) / 2**20


class Memory(places.Place):
    def test_flat(self):
        """The last third of the runs holds no more memory than the third before; every fifth reads CAD."""
        runs = int(os.environ.get("REYE_PYTHON_RUNS", "30"))
        scenes = [places.small_scene(cad=i == 0) for i in range(5)]
        for scene in scenes:
            scene["step[2].cycles"] = 100
        sizes = []
        for i in range(runs):
            self.assertEqual(scenes[i % len(scenes)].run().status, "done")
            sizes.append(allocated_MB())
        before = statistics.median(sizes[runs // 3:2 * runs // 3])
        at_end = statistics.median(sizes[2 * runs // 3:])
        print(f"{runs} runs: {sizes[0]:.2f} MB after the first, {before:.2f} in the second third, {at_end:.2f} in the last")
        self.assertLess(at_end, before + 0.1)


if __name__ == "__main__":
    unittest.main()
