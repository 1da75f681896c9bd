#!/usr/bin/env python3
"""A series whose meshes change from frame to frame, checked by its XML; where pvbatch is installed ParaView opens it, too."""
import os
import pathlib
import shutil
import subprocess
import sys
import xml.etree.ElementTree as xml

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from wear_case import read_csv, run, write_measured  # noqa: E402


def series(folder):
    """[(time, frame)] of series.pvd, a frame as XML."""
    return [(float(entry.get("timestep")), xml.parse(folder / entry.get("file")).getroot())
            for entry in xml.parse(folder / "series.pvd").iter("DataSet")]


def arrays(frame):
    """Place, name, type and components of every array."""
    return [(place, a.get("Name"), a.get("type"), *sorted(item for item in a.items() if item[0].startswith("Component")))
            for place in ("PointData", "CellData") for a in frame.find(f".//{place}")]


def points(frame):
    return int(frame.find(".//Piece").get("NumberOfPoints"))


def deepest(frame):
    return float(frame.find(".//DataArray[@Name='wear_depth_mm']").get("RangeMax"))


def nodes(remeshes, cycle):
    """Nodes of all bodies at a cycle, by the table of remeshes."""
    count = {}
    for row in remeshes:
        if float(row["cycle"]) <= cycle:
            count[row["body"]] = int(row["nodes_after"])
        count.setdefault(row["body"], int(row["nodes_before"]))
    return sum(count.values())


def paraview(folder):
    """ParaView's own words and picture."""
    if not shutil.which("pvbatch"):
        print("  pvbatch is not installed: paraview.txt and series.png stay as they are")
        return
    screen = [] if os.environ.get("DISPLAY") else ["xvfb-run", "-a"]
    subprocess.run([*screen, "pvbatch", "view.py", str(folder)], check=True)


def main():
    folder = run("pin_worn_flat", "pin").folder
    frames, remeshes = series(folder), read_csv(folder / "remesh.csv")
    pairs = list(zip(frames, frames[1:]))
    write_measured({
        "frames": len(frames),
        "times_that_do_not_grow": sum(later[0] <= former[0] for former, later in pairs),
        "frames_with_other_arrays": sum(arrays(frame) != arrays(frames[0][1]) for _, frame in frames),
        "frames_off_the_table_of_remeshes": sum(points(frame) != nodes(remeshes, time) for time, frame in frames),
        "different_point_counts": len({points(frame) for _, frame in frames}),
        "frames_with_less_depth": sum(deepest(later[1]) < deepest(former[1]) for former, later in pairs),
        "depth_mm": deepest(frames[-1][1]),
    })
    paraview(folder)


if __name__ == "__main__":
    main()
