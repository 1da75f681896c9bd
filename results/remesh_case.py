"""Remeshes of a run and its worn outlines beside those of another; used by the make.py of the cases that are remeshed."""
import csv
import math

TEXT = ("step", "body", "reason")


def remeshes(run):
    """Rows of remesh.csv, numbers where they are numbers."""
    with open(run.folder / "remesh.csv", newline="", encoding="utf-8") as file:
        return [{k: v if k in TEXT else float(v) for k, v in row.items()} for row in csv.DictReader(file)]


def poorest_scaled_jacobian(run):
    """Of the meshes that were computed on: those at birth, and those given up for another reason than their quality."""
    used = [r["scaled_jacobian_after"] for r in remeshes(run)]
    return min(used + [r["scaled_jacobian_before"] for r in remeshes(run) if not r["reason"].startswith(("the element", "element"))])


def most_nodes(run):
    """Largest mesh of one body over the one that it began with."""
    first = {}
    for r in remeshes(run):
        first.setdefault(r["body"], r["nodes_before"])
    return max(r["nodes_after"] / first[r["body"]] for r in remeshes(run))


def at_cycle(frames, cycle):
    return next(rows for c, rows in frames if c == cycle)


def outline(rows):
    """(x, y) on the worn stress-free shape, with growing x."""
    points = [(r["x_mm"], r["y_mm"]) for r in rows]
    return points if points[0][0] < points[-1][0] else points[::-1]


def value(points, x):
    for (xa, ya), (xb, yb) in zip(points, points[1:]):
        if xa <= x <= xb and xa < xb:
            return ya + (x - xa) / (xb - xa) * (yb - ya)
    raise ValueError(f"no point at x = {x}")


def difference(a, b, half_width, depth, centre=0.0, corner=None):
    """Largest and root mean square |a - b| of two outlines on centre +- half_width, over depth. corner = (place, facet):
    without what lies within a facet of +- place, where a polygon that has no node in the corner cuts it off."""
    x = [centre + half_width * (k / 400.0 - 1.0) for k in range(801)]
    if corner:
        x = [v for v in x if abs(abs(v - centre) - corner[0]) > corner[1]]
    d = [abs(value(a, v) - value(b, v)) / depth for v in x]
    return max(d), math.sqrt(sum(v * v for v in d) / len(d))
