#!/usr/bin/env python3
"""Factors of solids on one and two ranks beside one process, a model of their time and memory, and what it says of more."""
import json
import pathlib
import shutil
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from wear_case import figure, program, write_csv, write_measured  # noqa: E402

SIDE = 20                   # retained nodes along an edge of the patch
PARTS = (31, 37, 46)        # hexahedra along an edge: 98 000, 165 000 and 311 000 dofs
DENSE_FLOP_PER_S = 40e9     # of one core, as body/solid/solid_cost.cpp has measured it


def played(ranks, parts, *words):
    """Medians of three runs, of the largest cube one run; memory of the largest rank."""
    told = []
    for _ in range(1 if parts == PARTS[-1] else 3):
        lines = subprocess.run(["mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none", "-n", str(ranks),
                                program("reye-ranks"), str(parts), str(SIDE), *words],
                               check=True, capture_output=True, text=True).stdout.splitlines()
        rows = [json.loads(line) for line in lines]
        told.append(next(r for r in rows if "dofs" in r) | {"largest_MB": max(r["largest_MB"] for r in rows if "largest_MB" in r)})
    middle = lambda key: sorted(t[key] for t in told)[len(told) // 2]  # noqa: E731
    return told[0] | {key: middle(key) for key in ("factor_s", "solve_s", "largest_MB")}


def fitted(points, work, result):
    """Of result = work * (whole + share / ranks) over all points: whole and share by least relative squares."""
    rows = [(work(p) / result(p), work(p) / result(p) / p["ranks"]) for p in points]
    a, b, d = (sum(x * y for x, y in pairs) for pairs in ([(r[0], r[0]) for r in rows], [(r[0], r[1]) for r in rows], [(r[1], r[1]) for r in rows]))
    u, v = sum(r[0] for r in rows), sum(r[1] for r in rows)
    det = a * d - b * b
    return (u * d - v * b) / det, (v * a - u * b) / det


def main():
    one = [played(1, parts, "one") for parts in PARTS]
    ranked = [played(n, parts) for parts in PARTS for n in (1, 2)]
    time = fitted(ranked, lambda p: p["flops"], lambda p: p["factor_s"])
    memory = fitted(ranked, lambda p: p["entries"], lambda p: p["largest_MB"])
    said = lambda fit, work, ranks: work * (fit[0] + fit[1] / ranks)  # noqa: E731
    for p in ranked:
        p["model_s"] = said(time, p["flops"], p["ranks"])
        p["model_MB"] = said(memory, p["entries"], p["ranks"])
    columns = ("dofs", "ranks", "factor_s", "model_s", "solve_s", "largest_MB", "model_MB")
    write_csv("ranks.csv", columns, [[p.get(c, "") for c in columns] for p in one + ranked])

    largest = ranked[-1]
    outlook = []
    for dofs in (3e5, 1e6, 2e6, 5e6):
        # of a cube: separators of n^(2/3) dofs, hence entries of n^(4/3), operations of n^2
        entries = largest["entries"] * (dofs / largest["dofs"]) ** (4 / 3)
        flops = largest["flops"] * (dofs / largest["dofs"]) ** 2
        retained = 3 * SIDE**2 * (dofs / largest["dofs"]) ** (2 / 3)   # as large a share of the surface
        for ranks in (1, 2, 4, 8, 16, 32, 64):
            outlook.append((dofs, ranks, said(time, flops, ranks), retained**3 / 3 / DENSE_FLOP_PER_S,
                            retained**3 * 2 / 3 / DENSE_FLOP_PER_S / 8, said(memory, entries, ranks) / 1e3))
    write_csv("outlook.csv", ("dofs", "ranks", "factor_s", "of_it_schur_s", "interface_s_an_iteration", "largest_GB"), outlook)

    of = {(p["ranks"], p["dofs"]): p for p in one + ranked}
    at = max(p["dofs"] for p in one)
    ratio = lambda key, a, b: of[a, at][key] / of[b, at][key]  # noqa: E731
    write_measured({"largest_rank_of_two_to_one_rank_in_memory": ratio("largest_MB", 2, 1),
                    "largest_rank_of_two_to_one_process_in_memory": ratio("largest_MB", 2, 0),
                    "two_ranks_to_one_rank_in_time": ratio("factor_s", 2, 1),
                    "two_ranks_to_one_process_in_time": ratio("factor_s", 2, 0),
                    "largest_error_of_the_model_in_time": max(abs(p["model_s"] / p["factor_s"] - 1) for p in ranked),
                    "largest_error_of_the_model_in_memory": max(abs(p["model_MB"] / p["largest_MB"] - 1) for p in ranked)})
    figure("set logscale xy\nset key top left\nset xlabel 'dofs'\nset ylabel 'factor, s'\n"
           "plot '<grep \",0,\" ranks.csv' using 1:3 with linespoints lw 2 pt 7 title 'one process (CHOLMOD)', "
           "'<grep \",1,\" ranks.csv' using 1:3 with linespoints lw 2 pt 5 title 'one rank (MUMPS)', "
           "'<grep \",2,\" ranks.csv' using 1:3 with linespoints lw 2 pt 9 title 'two ranks'\n")


if __name__ == "__main__":
    if not shutil.which("mpirun"):
        write_measured("mpirun is not there")
        raise SystemExit(0)
    main()
