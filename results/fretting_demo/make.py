#!/usr/bin/env python3
"""The fretting demo: its picture for the README, and the numbers that must hold whatever the mesh."""
import json
import os
import pathlib
import shutil
import subprocess

HERE = pathlib.Path(__file__).resolve().parent
SCENE = HERE.parent.parent / "geo" / "fretting_demo" / "scene.toml"
OUT = pathlib.Path(os.environ["REYE_WORK"]) / "demo.out"

subprocess.run([os.environ["REYE"], "run", str(SCENE), "--out", str(OUT), "--threads", "1", "--quiet", "--force"], check=True)
summary = json.loads((OUT / "summary.json").read_text())
pad = summary["contacts"]["pad"]
shutil.copy(OUT / "figures" / "overview-pad.svg", HERE / "overview.svg")
sliding = 4 * 0.025 * 18000  # mm, were the bodies rigid: 4 amplitudes a cycle
measured = {
    "cycles": summary["cycles"],
    "ledger_relative_error": pad["ledger_relative_error"],
    "worn_area_ratio": pad["primary"]["worn_area_mm2"] / pad["secondary"]["worn_area_mm2"],
    "energy_over_rigid_sliding": pad["dissipated_energy_mJ_per_mm"] / (0.9 * 18.5 * sliding),
    "depth_flat_mm": pad["secondary"]["max_depth_mm"],
    "scar_width_flat_mm": pad["secondary"]["scar_width_mm"],
}
(HERE / "measured.json").write_text(json.dumps(measured, indent=2) + "\n")
