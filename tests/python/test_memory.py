"""Memory stays flat over many runs in one process: by default 30, or as many as REYE_PYTHON_RUNS says."""
import ctypes
import gc
import os
import statistics
import unittest

import places


class Allocated(ctypes.Structure):
    """mallinfo2 of glibc."""
    _fields_ = [(name, ctypes.c_size_t) for name in ("arena", "ordblks", "smblks", "hblks", "hblkhd", "usmblks", "fsmblks",
                                                     "uordblks", "fordblks", "keepcost")]


def held_MB():
    """What is allocated, and what is resident: without garbage, and without what the allocator keeps for later."""
    libc = ctypes.CDLL(None)
    gc.collect()
    libc.malloc_trim(0)
    libc.mallinfo2.restype = Allocated
    info = libc.mallinfo2()
    with open("/proc/self/statm", encoding="ascii") as file:
        resident = int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")
    return (info.uordblks + info.hblkhd) / 2**20, resident / 2**20


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
            sizes.append(held_MB())
        for what, more, of_runs in zip(("allocated", "resident"), (0.1, 3), zip(*sizes)):
            before = statistics.median(of_runs[runs // 3:2 * runs // 3])   # resident memory of single runs scatters by 3 MB
            at_end = statistics.median(of_runs[2 * runs // 3:])
            print(f"{what} in {runs} runs: {of_runs[0]:.2f} MB after the first, {before:.2f} in the second third, "
                  f"{at_end:.2f} in the last")
            self.assertLess(at_end, before + more, what)


if __name__ == "__main__":
    unittest.main()
