#!/usr/bin/env python3
"""The set of small scenes of solids at the rim of what can be asked (tests/stability): how each ends and what it costs,
against how it did when last looked at."""
import csv
import os
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from wear_case import WORK, program, read_csv, write_measured  # noqa: E402

MORE = 1.1   # iterations that count as no more than before


def play(file):
    """Every member's row; a member that fails the test is a row, too."""
    WORK.mkdir(parents=True, exist_ok=True)
    file.unlink(missing_ok=True)
    environment = dict(os.environ, REYE_SOLID_STABILITY=str(file), OPENBLAS_NUM_THREADS="1")
    ended = subprocess.run([program("test_stability"), "--gtest_brief=1", "--gtest_filter=Solids*"], env=environment,
                           stdout=subprocess.DEVNULL, check=False)
    if ended.returncode < 0:
        raise SystemExit(f"the set ended by signal {-ended.returncode}")
    return read_csv(file)


def worsened(row, before):
    """What is worse than before, in words; empty: nothing."""
    if row["status"] != before["status"]:
        return f"{before['status']} -> {row['status']}" if before["status"] == "done" else ""
    return ", ".join(f"{key} {before[key]} -> {row[key]}" for key in ("newton", "newton_most", "cutbacks")
                     if float(row[key]) > MORE * float(before[key]) + 1.0)


def main():
    rows = play(WORK / "members.csv")
    before = {row["member"]: row for row in read_csv("reference.csv")}
    found = [(row["member"], worsened(row, before[row["member"]])) for row in rows if row["member"] in before]
    worse = [(name, what) for name, what in found if what]
    worse += [(name, "missing") for name in sorted(set(before) - {row["member"] for row in rows})]
    for name, what in worse:
        print(f"  worse: {name}: {what}")
    with open("members.csv", "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    done = [row for row in rows if row["status"] == "done"]
    write_measured({
        "members": len(rows),
        "not_done": len(rows) - len(done),
        "worsened": len(worse),
        "iterations": sum(int(row["newton"]) for row in done),
        "iterations_an_increment": sum(int(row["newton"]) for row in done) / sum(int(row["increments"]) for row in done),
        "balance": max(float(row["balance"]) for row in rows),
        "negative_pressure": max(max(0.0, -float(row["least_pressure"])) for row in rows),
        "cutbacks": sum(int(row["cutbacks"]) for row in done),
        "cpu_s": sum(float(row["cpu_s"]) for row in rows)})


if __name__ == "__main__":
    main()
