#!/usr/bin/env python3
"""Runs the mutations of mutations.json; see run.sh.

A mutation is {"name", "file", "find", "replace", "tests": {executable: gtest filter}}: `find` stands exactly once in
`file`; with `replace` in its place every executable named must fail under its filter (a crash or a hang counts).
The same filters pass before anything is changed, so that only the mutation can be what is seen.
"""
import hashlib
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
COPIED = ("CMakeLists.txt", "cmake", "src", "apps", "tests", "geo", "results")
TIME_LIMIT_S = 300


def place_lost(mutation):
    """Why the mutation cannot be applied; empty when it can."""
    file = ROOT / mutation["file"]
    if not file.is_file():
        return f"no file {mutation['file']}"
    count = file.read_text(encoding="utf-8").count(mutation["find"])
    return "" if count == 1 else f"'{mutation['find']}' stands {count} times in {mutation['file']}"


def check_places(mutations):
    lost = [(m["name"], why) for m in mutations if (why := place_lost(m))]
    for name, why in lost:
        print(f"  place lost  {name}: {why}")
    return not lost


def copy_file(source, target):
    """Only when the content differs, and then with a new time: a kept object of a mutated file must not look fresh."""
    if not (pathlib.Path(target).is_file() and pathlib.Path(target).read_bytes() == pathlib.Path(source).read_bytes()):
        shutil.copyfile(source, target)


def copy_tree(scratch):
    """The working tree as it is now; a mutation that an interrupted run left in the copy is undone."""
    for name in COPIED:
        source = ROOT / name
        if source.is_file():
            copy_file(source, scratch / name)
        elif source.is_dir():
            shutil.copytree(source, scratch / name, dirs_exist_ok=True, copy_function=copy_file,
                            ignore=shutil.ignore_patterns("*.out"))


def quiet(command, **options):
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL,
                          text=True, **options)


def build(scratch, executables):
    """The compiler's words when the build fails, else empty."""
    done = quiet(["ninja", "-C", str(scratch / "build"), *sorted(executables)])
    return "" if done.returncode == 0 else done.stdout[-3000:]


def passes(scratch, executable, pattern):
    """True when at least one test ran and all passed."""
    try:
        done = quiet([str(scratch / "build" / "bin" / executable), f"--gtest_filter={pattern}"], timeout=TIME_LIMIT_S)
    except subprocess.TimeoutExpired:
        return False
    if "Running 0 tests" in done.stdout:
        raise SystemExit(f"{executable}: no test is named {pattern}")
    return done.returncode == 0


def compiler_cache():
    """What configures ccache where it is there: a mutation that is undone then costs no second compilation."""
    if not shutil.which("ccache"):
        return []
    os.environ.setdefault("CCACHE_SLOPPINESS", "pch_defines,time_macros")
    return ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"]


def prepare(scratch, mutations):
    done = quiet(["cmake", "-S", str(scratch), "-B", str(scratch / "build"), "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                  *compiler_cache()])
    if done.returncode:
        raise SystemExit(done.stdout[-3000:])
    if words := build(scratch, {e for m in mutations for e in m["tests"]}):
        raise SystemExit(f"the tree does not build unchanged:\n{words}")
    for mutation in mutations:
        for executable, pattern in mutation["tests"].items():
            if not passes(scratch, executable, pattern):
                raise SystemExit(f"{executable} fails under {pattern} before anything is changed")


def survivors(scratch, mutation):
    """The executables that still pass with the mutation in place; None where it does not build."""
    file = scratch / mutation["file"]
    whole = file.read_text(encoding="utf-8")
    file.write_text(whole.replace(mutation["find"], mutation["replace"]), encoding="utf-8")
    try:
        if words := build(scratch, mutation["tests"]):
            print(words)
            return None
        return [e for e, pattern in mutation["tests"].items() if passes(scratch, e, pattern)]
    finally:
        file.write_text(whole, encoding="utf-8")


def fingerprint(scratch):
    """Of everything that was copied: what was caught in one tree says nothing about another."""
    total = hashlib.sha256()
    for name in COPIED:
        for file in sorted([scratch / name] if (scratch / name).is_file() else (scratch / name).rglob("*")):
            if file.is_file():
                total.update(str(file.relative_to(scratch)).encode() + b"\0" + file.read_bytes())
    return total.hexdigest()


def caught_before(record, tree):
    """Names of the mutations that an interrupted run of the same tree has caught."""
    try:
        kept = json.loads(record.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return []
    return kept["caught"] if kept["tree"] == tree else []


def run(scratch, mutations):
    copy_tree(scratch)
    record, tree = scratch / "caught.json", fingerprint(scratch)
    caught = caught_before(record, tree)
    left = [m for m in mutations if m["name"] not in caught]
    print(f"{len(mutations) - len(left)} of {len(mutations)} were caught by an earlier run", flush=True)
    if left:
        prepare(scratch, left)
    missed = 0
    for mutation in left:
        alive = survivors(scratch, mutation)
        missed += alive != []
        end = "DOES NOT BUILD" if alive is None else "MISSED by " + ", ".join(alive) if alive else "caught"
        print(f"  {end}  {mutation['name']}", flush=True)
        if alive == []:
            caught.append(mutation["name"])
            record.write_text(json.dumps({"tree": tree, "caught": caught}), encoding="utf-8")
    print(f"{len(mutations) - missed} of {len(mutations)} mutations caught")
    return 1 if missed else 0


def main(arguments):
    mutations = json.loads((HERE / "mutations.json").read_text(encoding="utf-8"))
    check_only = "--check" in arguments
    words = [a for a in arguments if a != "--check"]
    chosen = [m for m in mutations if not words or any(w in m["name"] for w in words)]
    if not check_places(chosen) or not chosen:
        return 1
    if check_only:
        print(f"{len(chosen)} mutations find their place")
        return 0
    if kept := os.environ.get("REYE_MUTATIONS"):
        scratch = pathlib.Path(kept)
        scratch.mkdir(parents=True, exist_ok=True)
        return run(scratch, chosen)
    with tempfile.TemporaryDirectory(prefix="reye-mutations-") as scratch:
        return run(pathlib.Path(scratch), chosen)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
