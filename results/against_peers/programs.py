"""Runs of the three programs on one core, with the CPU time that the whole command took (user and system, seconds)."""
import hashlib
import json
import os
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from wear_case import REYE, WORK, Run  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
ONE_CORE = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1", CCX_NPROC_STIFFNESS="1",
                CCX_NPROC_RESULTS="1", CCX_NPROC_EQUATION_SOLVER="1")
DEBIAN_PYTHON = "/usr/bin/python3"
TAKEN_OVER = []    # names of the peers' runs that were there already


def cpu_seconds(command, log):
    """Runs a command to its end; its output goes to `log`."""
    with open(log, "w", encoding="utf-8") as output:
        child = subprocess.Popen(command, cwd=WORK, env=ONE_CORE, stdout=output, stderr=subprocess.STDOUT)
        _, status, usage = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode != 0:
        raise RuntimeError(f"{' '.join(map(str, command))} ended with {child.returncode}, see {log}")
    return usage.ru_utime + usage.ru_stime


def first_line(command):
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    lines = [line.strip() for line in (done.stdout + done.stderr).splitlines() if line.strip()]
    return lines[0] if lines else ""


def package_version(name):
    """Version of an installed Debian package, or None."""
    done = subprocess.run(["dpkg-query", "-W", "-f=${db:Status-Status} ${Version}", name],
                          capture_output=True, text=True, check=False)
    words = done.stdout.split()
    return words[1] if words[:1] == ["installed"] else None


def versions():
    """{program: version or None when it is not installed}."""
    return {"Reye": first_line([REYE, "--version"]), "CalculiX": package_version("calculix-ccx"),
            "GetFEM": package_version("python3-getfem")}


def reye(name, scene, repeats=1):
    """(median CPU of the whole command, CPU of the run without start and meshing, Run)."""
    file = WORK / f"{name}.toml"
    file.write_text(scene, encoding="utf-8")
    command = [REYE, "run", str(file), "--out", str(WORK / name), "--threads", "1", "--force", "--quiet"]
    whole, inner = [], []
    for _ in range(repeats):
        whole.append(cpu_seconds(command, WORK / f"{name}.log"))
        run = Run(WORK / name)
        inner.append(run.summary["cpu_s"])
    return sorted(whole)[repeats // 2], sorted(inner)[repeats // 2], run


def peer(name, text, command):
    """CPU of a peer's run. With REYE_PEERS_REUSE set, a run with the same input that is already there counts: so an interrupted comparison resumes."""
    stamp, key = WORK / f"{name}.cpu", hashlib.sha256(text.encode()).hexdigest()
    if os.environ.get("REYE_PEERS_REUSE") and stamp.is_file():
        kept_key, kept_cpu = stamp.read_text(encoding="ascii").split()
        if kept_key == key:
            TAKEN_OVER.append(name)
            return float(kept_cpu)
    stamp.unlink(missing_ok=True)
    cpu = cpu_seconds(command, WORK / f"{name}.log")
    stamp.write_text(f"{key} {cpu}\n", encoding="ascii")
    return cpu


def calculix(name, deck):
    """CPU of the whole command; results lie in WORK/name.dat and .frd."""
    (WORK / f"{name}.inp").write_text(deck, encoding="ascii")
    return peer(name, deck, ["ccx", name])


def getfem(name, case, script=HERE / "getfem_contact.py"):
    """(CPU of the whole command, what the script wrote)."""
    text = json.dumps(case)
    (WORK / f"{name}.case.json").write_text(text, encoding="utf-8")
    cpu = peer(name, text, [DEBIAN_PYTHON, str(script), f"{name}.case.json", f"{name}.json"])
    return cpu, json.loads((WORK / f"{name}.json").read_text(encoding="utf-8"))
