#!/usr/bin/env python3
"""The stability grid (tests/stability): how each member ends and what it costs, against how it did when last looked at."""
import csv
import os
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from wear_case import WORK, program, read_csv, write_measured  # noqa: E402

MORE = 1.1   # solves that count as no more than before


def play(file):
    """Every member's row; a member that fails the test is a row, too."""
    file.unlink(missing_ok=True)
    environment = dict(os.environ, REYE_STABILITY=str(file), OPENBLAS_NUM_THREADS="1")
    ended = subprocess.run([program("test_stability"), "--gtest_brief=1"], env=environment, stdout=subprocess.DEVNULL, check=False)
    if ended.returncode < 0:
        raise SystemExit(f"the grid ended by signal {-ended.returncode}")
    return read_csv(file)


def worsened(row, before):
    """What is worse than before, in words; empty: nothing."""
    if row["status"] != before["status"]:
        return f"{before['status']} -> {row['status']}" if before["status"] == "done" else ""
    return ", ".join(f"{key} {before[key]} -> {row[key]}" for key in ("newton", "factorisations", "newton_most", "cutbacks")
                     if float(row[key]) > MORE * float(before[key]) + 1.0)


def largest(rows, key):
    return max(float(row[key]) for row in rows)


def main():
    rows = play(WORK / "members.csv")
    before = {row["member"]: row for row in read_csv("reference.csv")}
    missing = set(before) - {row["member"] for row in rows}
    found = [(row["member"], worsened(row, before[row["member"]])) for row in rows if row["member"] in before]
    worse = [(member, what) for member, what in found if what] + [(member, "missing") for member in sorted(missing)]
    for member, what in worse:
        print(f"  worse: {member}: {what}")
    with open("members.csv", "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    done = [row for row in rows if row["status"] == "done"]
    write_measured({
        "members": len(rows),
        "not_done": len(rows) - len(done),
        "worsened": len(worse),
        "solves": sum(int(row["newton"]) for row in done),
        "factorisations": sum(int(row["factorisations"]) for row in done),
        "cutbacks": sum(int(row["cutbacks"]) for row in done),
        "ledger": largest(rows, "ledger"),
        "balance": largest(rows, "balance"),
        "negative_multiplier": max(max(0.0, -float(row["multiplier"])) for row in rows),
        "cpu_s": sum(float(row["cpu_s"]) for row in rows)})


if __name__ == "__main__":
    main()
