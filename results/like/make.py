#!/usr/bin/env python3
"""The scenes of `reye new`, each run to its end on one core: seconds, depth and life of each."""
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
import wear_case as case  # noqa: E402

KINDS = ("ball_on_flat", "bearing", "block_on_ring", "dovetail", "fretting", "hip_cup", "pin_on_disc", "seal")


def loaded(run):
    """Nodes of the secondary side under pressure, at the frame of the last load."""
    return next(sum(1 for row in rows if row["pressure_MPa"] > 0.0) for _, rows in reversed(run.frames("secondary"))
                if any(row["pressure_MPa"] > 0.0 for row in rows))


measured, table = {}, []
for kind in KINDS:
    run = case.run(f"like/{kind}", kind)
    depth, life = run.contact["secondary"]["max_depth_mm"], next(iter(run.summary["life_cycles"].values()))
    measured |= {f"{kind}_cpu_s": run.summary["cpu_s"], f"{kind}_depth_um": 1e3 * depth, f"{kind}_life_cycles": life,
                 f"{kind}_ledger": run.contact["ledger_relative_error"], f"{kind}_warnings": len(run.summary["warnings"]),
                 f"{kind}_nodes_in_contact": loaded(run)}
    table.append((kind, run.summary["cpu_s"], 1e3 * depth, life, run.summary["counts"]["increments"], loaded(run)))
case.write_measured(measured)
case.write_csv("kinds.csv", ["kind", "cpu_s", "depth_um", "life_cycles", "increments", "nodes_in_contact"], table)
