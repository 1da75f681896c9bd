#!/usr/bin/env python3
"""Remakes the cases under results/ and compares their numbers; prints the table of a finished run.

  python3 apps/results.py compare CASE|all   exit 1 when a number is missing or outside its tolerance
  python3 apps/results.py table DIR          depth, width, area of a run's output folder, and its files

A case is a folder results/CASE with make.sh or make.py, which runs the command (environment variable REYE) with
scratch space for its output (REYE_WORK), remakes CSVs and figures in the case's folder and writes measured.json there:
  {"name": number, ...}
and with expected.json, of which every name must be measured:
  {"name": {"value": v, "tolerance": t, "source": "where v comes from"}}
The tolerance is absolute, or with "relative_tolerance" in its place a share of |v|. A promise says "at_least", "at_most" or
both in place of value and tolerance. In measured.json a text in place of a number says why it was left out here.
"""
import json
import math
import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = pathlib.Path(os.environ.get("REYE_BUILD", ROOT / "build")).resolve()


def read_json(path):
    return json.loads(path.read_text(encoding="utf-8"))


def maker(case):
    """The command that remakes a case, or None."""
    for name, program in (("make.sh", "bash"), ("make.py", sys.executable)):
        if (case / name).is_file():
            return [program, str(case / name)]
    return None


def remake(case):
    """Runs the case afresh and returns what it measured; an old measurement never counts."""
    measured = case / "measured.json"
    measured.unlink(missing_ok=True)
    work = BUILD / "results" / case.name
    work.mkdir(parents=True, exist_ok=True)
    environment = dict(os.environ, REYE=str(BUILD / "bin" / "reye"), REYE_WORK=str(work))
    subprocess.run(maker(case), cwd=case, env=environment, check=True, stdin=subprocess.DEVNULL)
    return read_json(measured)


def bounds(entry):
    """The least and the largest number that is as expected."""
    if "value" not in entry:
        if not {"at_least", "at_most"} & set(entry):
            raise ValueError("an expected number needs a value, at_least or at_most")
        return entry.get("at_least", -math.inf), entry.get("at_most", math.inf)
    value = entry["value"]
    tolerance = entry["relative_tolerance"] * abs(value) if "relative_tolerance" in entry else entry["tolerance"]
    return value - tolerance, value + tolerance


def in_words(entry):
    """What is expected, for the table."""
    if "value" in entry:
        return f"{entry['value']:.7g} +- {bounds(entry)[1] - entry['value']:.1e}"
    return ", ".join(f"{word} {entry[key]:.7g}" for key, word in (("at_least", ">="), ("at_most", "<=")) if key in entry)


def compare_numbers(expected, measured):
    """Prints one line for each expected number; True when all are within their tolerance. A word in place of a number
    says why it could not be measured here (a program to compare with is not installed): it counts neither way."""
    good = True
    print(f"  {'name':44} {'expected':>26} {'measured':>14}")
    for name, entry in expected.items():
        value = measured.get(name)
        if isinstance(value, str):
            print(f"  {name:44} {in_words(entry):>26} {'-':>14}  left out: {value}")
            continue
        if not isinstance(value, (int, float)) or not math.isfinite(value):
            print(f"  {name:44} {in_words(entry):>26} {'missing':>14}  FAIL")
            good = False
            continue
        least, largest = bounds(entry)
        within = least <= value <= largest
        good = good and within
        print(f"  {name:44} {in_words(entry):>26} {value:14.7g}  {'ok' if within else 'FAIL'}")
    return good


def compare_case(case):
    print(f"{case.name}:", flush=True)
    try:
        return compare_numbers(read_json(case / "expected.json"), remake(case))
    except (subprocess.CalledProcessError, OSError, ValueError, KeyError) as error:
        print(f"  FAIL: {error}")
        return False


def compare(name):
    cases = sorted(p for p in (ROOT / "results").iterdir() if p.is_dir() and maker(p))
    chosen = cases if name == "all" else [c for c in cases if c.name == name]
    if not chosen:
        sys.exit(f"results: no case '{name}'; there are: {', '.join(c.name for c in cases) or 'none'}")
    failed = [case.name for case in chosen if not compare_case(case)]
    print(f"{len(chosen) - len(failed)} of {len(chosen)} cases as expected"
          + (f"; not: {', '.join(failed)}" if failed else ""))
    return 1 if failed else 0


def number(value):
    return "-" if value is None else f"{value:.5g}"


def table(folder):
    """Depth, width and area of each worn side, then where to look."""
    folder = pathlib.Path(folder)
    summary = read_json(folder / "summary.json")
    print(f"\n{summary['title']}: {summary['status']} at cycle {number(summary['cycles'])}")
    print(f"  {'contact':12} {'side':10} {'depth mm':>12} {'width mm':>12} {'area mm2':>12}")
    for name, contact in summary["contacts"].items():
        for side in ("secondary", "primary"):
            worn = contact.get(side) or {}
            size = worn.get("worn_area_mm2", worn.get("worn_volume_mm3"))
            print(f"  {name:12} {side:10} {number(worn.get('max_depth_mm')):>12} "
                  f"{number(worn.get('scar_width_mm')):>12} {number(size):>12}")
    print()
    for what, file in (("page with pictures", "report.html"), ("ParaView series", "series.pvd"),
                       ("tables", "history.csv"), ("summary", "summary.json")):
        print(f"  {what:20} {folder / file}{'' if (folder / file).exists() else '   (not written)'}")
    return 0


def main(arguments):
    if len(arguments) == 2 and arguments[0] in ("compare", "table"):
        return {"compare": compare, "table": table}[arguments[0]](arguments[1])
    print(__doc__, file=sys.stderr)
    return 2


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
