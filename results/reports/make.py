#!/usr/bin/env python3
"""Runs sixteen scenes, renders their reports with moving pictures in headless Chromium at two widths, and measures what
a page costs: its size, how long it takes to open, and its share of the run."""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from wear_case import ROOT, WORK, write_csv, write_measured  # noqa: E402

SCENES = ("fretting_demo", "hertz_block", "measured_load", "two_pins", "pin_in_hole", "coating", "hinge", "spinning_shaft",
          "bonded_coat", "block_on_ring", "ball_worn_flat", "ball_in_cup", "rubber_pin_wear", "three_bodies",
          "partial_slip_life", "upsetting_remesh")
WIDTHS = (1280, 480)
PROBE = ("<script>addEventListener('load', () => { const tall = document.documentElement.scrollHeight; document.title = "
         "'opened ' + Math.round(performance.now()) + ' ' + tall; });</script></body>")


def seconds(*command):
    start = time.monotonic()
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return time.monotonic() - start


def chromium(page, width, height, *more):
    return subprocess.run(["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
                           f"--window-size={width},{height}", *more, f"file://{page}"],
                          check=True, capture_output=True, text=True).stdout


def opened(page, width):
    """Milliseconds until all is loaded and laid out, and the height of the page."""
    probe = page.with_name("probe.html")
    probe.write_text(page.read_text(encoding="utf-8").replace("</body>", PROBE), encoding="utf-8")
    dom = chromium(probe, width, 900, "--timeout=5000", "--dump-dom")
    return tuple(int(n) for n in re.search(r"<title>opened (\d+) (\d+)</title>", dom).groups())


def render(page, name, width):
    milliseconds, height = opened(page, width)
    picture = pathlib.Path(f"{name}_{width}.png").resolve()
    chromium(page, width, height, f"--screenshot={picture}")
    if shutil.which("pngquant"):
        subprocess.run(["pngquant", "--force", "--output", picture, "32", picture], check=True)
    return milliseconds


def main():
    if not shutil.which("chromium"):
        write_measured("there is no chromium here to render pages with")
        return
    reye = os.environ["REYE"]
    os.environ |= {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
    WORK.mkdir(parents=True, exist_ok=True)
    rows = []
    for name in SCENES:
        folder = WORK / name
        run = seconds(reye, "run", ROOT / "geo" / name / "scene.toml", "--out", folder, "--threads", "1", "--force", "--quiet")
        report = float(re.search(r"report made in (\S+) s", (folder / "log.txt").read_text(encoding="utf-8")).group(1))
        seconds(reye, "report", folder, "--animation")
        page = folder / "report.html"
        slowest = max(render(page, name, width) for width in WIDTHS)
        rows.append([name, round(run, 2), round(report, 4), round(report / run, 4), round(page.stat().st_size / 1e6, 3), slowest])
        print(*rows[-1], flush=True)
    write_csv("reports.csv", ["scene", "run_s", "report_s", "share", "page_MB", "opens_ms"], rows)
    write_measured({"pages": len(rows), "largest_page_MB": max(row[4] for row in rows),
                    "slowest_opening_s": 1e-3 * max(row[5] for row in rows),
                    "share_of_a_run_most": max(row[3] for row in rows),
                    "share_of_all_runs": sum(row[2] for row in rows) / sum(row[1] for row in rows)})


if __name__ == "__main__":
    main()
