#!/usr/bin/env python3
"""Remakes the cases under results/ and compares their figures; prints the table of a finished run.

  python3 apps/results.py compare CASE|all   remakes and compares; exit 1 when a figure is not as expected
  python3 apps/results.py renew CASE         writes the figures of the last compare into expected.json as "measured"
  python3 apps/results.py table-all          writes results/TABLE.md: every figure, what is expected, committed, and now
  python3 apps/results.py table DIR          depth, width, area of a run's output folder, and its files

A case is a folder results/CASE with make.sh or make.py, which runs the command (environment variable REYE) with
scratch space for its output (REYE_WORK), remakes CSVs and figures in the case's folder and writes measured.json there:
  {"name": number, ...}
and with expected.json (apps/expected.py says what may stand there), which names the same figures: one that is measured and
not expected fails, and so does one that is expected and not measured. A text in place of a number says why it was left out
here (a program to compare with is not installed), a text in place of all numbers why the whole case was: what is left out
neither passes nor fails, and is said. REYE_BUILD is the build that is used: its bin/reye and what lies beside it.
"""
import json
import os
import pathlib
import subprocess
import sys

import expected as ex

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = pathlib.Path(os.environ.get("REYE_BUILD", ROOT / "build")).resolve()


def read_json(path):
    return json.loads(path.read_text(encoding="utf-8"))


def write_expected(path, entries):
    """One line for each figure."""
    lines = [f"  {json.dumps(name)}: {json.dumps(entry, ensure_ascii=False)}" for name, entry in entries.items()]
    path.write_text("{\n" + ",\n".join(lines) + "\n}\n", encoding="utf-8")


def maker(case):
    """The command that remakes a case, or None."""
    for name, program in (("make.sh", "bash"), ("make.py", sys.executable)):
        if (case / name).is_file():
            return [program, str(case / name)]
    return None


def all_cases():
    return sorted(p for p in (ROOT / "results").iterdir() if p.is_dir() and maker(p))


def named(name):
    chosen = [case for case in all_cases() if name in ("all", case.name)]
    if not chosen:
        sys.exit(f"results: no case '{name}'; there are: {', '.join(c.name for c in all_cases()) or 'none'}")
    return chosen


def remake(case):
    """Runs the case afresh and returns what it measured; an old measurement never counts."""
    measured = case / "measured.json"
    measured.unlink(missing_ok=True)
    work = BUILD / "results" / case.name
    work.mkdir(parents=True, exist_ok=True)
    environment = dict(os.environ, REYE=str(BUILD / "bin" / "reye"), REYE_WORK=str(work))
    subprocess.run(maker(case), cwd=case, env=environment, check=True, stdin=subprocess.DEVNULL)
    return read_json(measured)


def expectations(case):
    """expected.json, of which every entry must make sense."""
    entries = read_json(case / "expected.json")
    for name, entry in entries.items():
        if fault := ex.fault(entry):
            raise ValueError(f"expected.json: {name}: {fault}")
    return entries


def judged(entries, measured):
    """(name, entry, number or None, complaints, why it is left out) of every figure that is expected or measured."""
    rows = []
    for name in [*entries, *(name for name in measured if name not in entries)]:
        entry, value = entries.get(name), measured.get(name)
        number = value if ex.is_number(value) else None
        if entry is None:
            rows.append((name, entry, number, ["measured, but expected.json does not name it"], ""))
        elif isinstance(value, str):
            rows.append((name, entry, None, [], value))
        else:
            rows.append((name, entry, number, ex.complaints(entry, value), ""))
    return rows


def shown(value):
    return "-" if value is None else f"{value:.7g}"


def compare_numbers(entries, measured):
    """Prints one line for each figure; (all as expected, why figures were left out)."""
    rows = judged(entries, measured)
    print(f"  {'name':44} {'expected':>26} {'committed':>14} {'measured':>14}")
    for name, entry, value, wrong, left_out in rows:
        verdict = f"left out: {left_out}" if left_out else "FAIL: " + "; ".join(wrong) if wrong else "ok"
        words, before, note = (ex.in_words(entry), shown(entry.get("measured")), ex.beside(entry, value)) if entry else ("-", "-", "")
        print(f"  {name:44} {words:>26} {before:>14} {shown(value):>14}  {verdict}{'; ' if note else ''}{note}")
    return not any(row[3] for row in rows), sorted({row[4] for row in rows if row[4]})


def compare_case(case):
    """("passed", "failed" or "left out", why figures or the case were left out)."""
    print(f"{case.name}:", flush=True)
    try:
        entries = expectations(case)
        measured = remake(case)
        if isinstance(measured, str):
            print(f"  left out: {measured}")
            return "left out", [measured]
        if not isinstance(measured, dict):
            raise ValueError("measured.json holds neither figures nor a text")
        good, absent = compare_numbers(entries, measured)
        if good and absent and all(isinstance(measured.get(name), str) for name in entries):
            return "left out", absent
        return "passed" if good else "failed", absent
    except (subprocess.CalledProcessError, OSError, ValueError, KeyError) as error:
        print(f"  FAIL: {error}")
        return "failed", []


def compare(name):
    ends = {case.name: compare_case(case) for case in named(name)}
    failed = [case for case, (end, _) in ends.items() if end == "failed"]
    left_out = [case for case, (end, _) in ends.items() if end == "left out"]
    print(f"{len(ends) - len(failed) - len(left_out)} of {len(ends)} cases as expected"
          + (f"; not: {', '.join(failed)}" if failed else ""))
    for case, (end, reasons) in ends.items():
        if reasons:
            print(f"left out{'' if end == 'left out' else ' in part'}: {case} ({'; '.join(reasons)})")
    return 1 if failed else 0


def renew(name):
    """A promise stays as it is: only what was measured is written down."""
    for case in named(name):
        entries, file = expectations(case), case / "measured.json"
        if not file.is_file():
            if name == "all":
                continue
            sys.exit(f"results: {name} has not been measured here: compare it first")
        measured = read_json(file)
        numbers = {key: value for key, value in measured.items() if ex.is_number(value)} if isinstance(measured, dict) else {}
        if strangers := sorted(set(numbers) - set(entries)):
            print(f"{case.name}: measured, but expected.json does not name: {', '.join(strangers)}")
        write_expected(case / "expected.json", {key: ex.renewed(entry, numbers[key]) if key in numbers else entry
                                                for key, entry in entries.items()})
    return 0


def committed(entry):
    """What was measured when the case was last committed; bold where that was not as expected."""
    if "measured" not in entry:
        return "-"
    least, largest = ex.bounds(entry)
    kept, rounding = entry["measured"], 5e-7 * abs(entry["measured"])   # seven digits are kept
    return shown(kept) + ("" if least - rounding <= kept <= largest + rounding else " **not as expected**")


def table_rows(case):
    """Rows of a case for the table of all; what was not measured here has no figure of now."""
    entries, file = expectations(case), case / "measured.json"
    measured = read_json(file) if file.is_file() else None
    if not isinstance(measured, dict):
        why = "-" if measured is None else f"left out: {measured}"
        return [(case.name, name, ex.in_words(entry), committed(entry), why) for name, entry in entries.items()]
    rows = []
    for name, entry, value, wrong, left_out in judged(entries, measured):
        now = f"left out: {left_out}" if left_out else shown(value) + (f" **{'; '.join(wrong)}**" if wrong else "")
        note = ex.beside(entry, value) if entry else ""
        rows.append((case.name, name, ex.in_words(entry) if entry else "-", committed(entry) if entry else "-",
                     f"{now} ({note})" if note else now))
    return rows


TABLE = """# Every figure of every case

Written by `python3 apps/results.py table-all`. *Expectation*: a promise (>=, <=, from to), a reference and how near to it the
figure must come (+-), or a record, which promises nothing. *Committed*: what was measured when the case was last committed.
*Now*: what the last `compare` in this clone measured, - where there was none. What is not as expected is bold. Where an
expectation comes from is written in the case's `expected.json`.

{}

"""


def table_all():
    rows = [row for case in all_cases() for row in table_rows(case)]
    here = [row for row in rows if row[4] != "-" and not row[4].startswith("left out")]
    summary = (f"{len(rows)} figures of {len({row[0] for row in rows})} cases; {len(here)} figures of {len({row[0] for row in here})} "
               f"cases measured in this clone, {sum('**' in row[4] for row in here)} of them not as expected.")
    head = ("case", "figure", "expectation", "committed", "now")
    lines = ["| " + " | ".join(row) + " |" for row in (head, ["---"] * len(head), *rows)]
    (ROOT / "results" / "TABLE.md").write_text(TABLE.format(summary) + "\n".join(lines) + "\n", encoding="utf-8")
    print(f"results/TABLE.md: {summary}")
    return 0


def short(value):
    return "-" if value is None else f"{value:.5g}"


def table(folder):
    """Depth, width and area of each worn side, then where to look."""
    folder = pathlib.Path(folder)
    summary = read_json(folder / "summary.json")
    print(f"\n{summary['title']}: {summary['status']} at cycle {short(summary['cycles'])}")
    print(f"  {'contact':12} {'side':10} {'depth mm':>12} {'width mm':>12} {'area mm2':>12}")
    for name, contact in summary["contacts"].items():
        for side in ("secondary", "primary"):
            worn = contact.get(side) or {}
            size = worn.get("worn_area_mm2", worn.get("worn_volume_mm3"))
            print(f"  {name:12} {side:10} {short(worn.get('max_depth_mm')):>12} "
                  f"{short(worn.get('scar_width_mm')):>12} {short(size):>12}")
    print()
    for what, file in (("page with pictures", "report.html"), ("ParaView series", "series.pvd"),
                       ("tables", "history.csv"), ("summary", "summary.json")):
        print(f"  {what:20} {folder / file}{'' if (folder / file).exists() else '   (not written)'}")
    return 0


def main(arguments):
    commands = {"compare": compare, "renew": renew, "table": table, "table-all": table_all}
    command = commands.get(arguments[0]) if arguments else None
    if command and len(arguments) == (1 if command is table_all else 2):
        return command(*arguments[1:])
    print(__doc__, file=sys.stderr)
    return 2


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
