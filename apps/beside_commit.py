#!/usr/bin/env python3
"""What a run costs beside another commit of this repository: wall times of both, in turn, their medians and the ratio.

    python3 apps/beside_commit.py COMMIT PAIRS SCENE_THEN [SCENE_NOW] [reye run options]

builds the command of COMMIT in build/beside and that of this tree in build, then plays SCENE_THEN with the former and
SCENE_NOW (SCENE_THEN, where it is left out) with the latter. Options are those of the command of this tree.
"""
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent.parent


def built(source, build):
    """The command of a source tree, built where it is not."""
    if not (build / "build.ninja").exists():
        subprocess.run(["cmake", "-S", source, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release"], check=True,
                       stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", build, "--parallel", "--target", "reye"], check=True, stdout=sys.stderr)
    return build / "bin" / "reye"


def of_commit(commit):
    """The command of another commit, whose files are taken from git once."""
    name = subprocess.run(["git", "rev-parse", "--verify", commit + "^{commit}"], cwd=HERE, check=True,
                          capture_output=True, text=True).stdout.strip()
    source = HERE / "build" / "beside" / name
    if not source.exists():
        source.parent.mkdir(parents=True, exist_ok=True)
        files = subprocess.run(["git", "archive", name], cwd=HERE, check=True, capture_output=True).stdout
        with tempfile.TemporaryDirectory(dir=source.parent) as folder:
            begun = pathlib.Path(folder) / "files"
            begun.mkdir()
            subprocess.run(["tar", "-x", "-C", begun], input=files, check=True)
            begun.rename(source)  # whole, or not there
    return built(source, source / "build")


def seconds(command, scene, options=()):
    """Wall time of a run; its results are dropped. One that fails has no time, and ends the comparison."""
    with tempfile.TemporaryDirectory() as folder:
        start = time.monotonic()
        run = subprocess.run([command, "run", scene, "--out", pathlib.Path(folder) / "out", "--quiet", *options],
                             stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        took = time.monotonic() - start
    if run.returncode != 0:
        sys.exit(f"{command} run {scene} ended with {run.returncode}:\n{run.stderr}")
    return took


def main(commit, pairs, scene_then, *rest):
    given = bool(rest) and not rest[0].startswith("-")
    scene_now, options = rest[0] if given else scene_then, rest[given:]
    then, now = of_commit(commit), built(HERE, HERE / "build")
    took = {"then": [], "now": []}
    for pair in range(1, int(pairs) + 1):
        took["then"].append(seconds(then, scene_then))
        took["now"].append(seconds(now, scene_now, options))
        print(f"pair {pair}: {took['then'][-1]:.2f} s then, {took['now'][-1]:.2f} s now", flush=True)
    medians = {when: statistics.median(times) for when, times in took.items()}
    print(f"medians: {medians['then']:.2f} s then, {medians['now']:.2f} s now, ratio "
          f"{medians['now'] / medians['then']:.3f}")


if len(sys.argv) < 4 or not sys.argv[2].isdigit() or int(sys.argv[2]) == 0:
    sys.exit(__doc__)
main(*sys.argv[1:])
