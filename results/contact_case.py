"""Profiles of line contacts against closed forms, and error against mesh size; used by the make.py of the contact cases."""
import math

SHIFTS = 5  # positions of the fine zone, a fifth of an element apart


def root(x):
    return math.sqrt(x) if x > 0.0 else 0.0


def hertz(x, a, p0):
    return p0 * root(1.0 - (x / a) ** 2)


def mindlin(x, a, c, mu_p0):
    """Shear in partial slip (references B2): a full-slip part of half width a less one of half width c."""
    return hertz(x, a, mu_p0) - hertz(x, c, mu_p0 * c / a)


def centroid(rows):
    total = sum(r["pressure_MPa"] for r in rows)
    return sum(r["x_mm"] * r["pressure_MPa"] for r in rows) / total


def profile(rows, key, margin=3):
    """[(x about the pressure centroid, value)] of the loaded nodes and `margin` nodes on either side."""
    loaded = [i for i, r in enumerate(rows) if r["pressure_MPa"] > 0.0]
    middle = centroid(rows)
    return [(r["x_mm"] - middle, r[key]) for r in rows[loaded[0] - margin:loaded[-1] + margin + 1]]


def spacing(points):
    k = len(points) // 2
    return points[k + 1][0] - points[k][0]


def l2_error(points, exact, parts=50):
    """Root of the integral of (value - exact)^2, the values linear between the nodes."""
    total = 0.0
    for (x0, f0), (x1, f1) in zip(points, points[1:]):
        for k in range(parts):
            t = (k + 0.5) / parts
            total += (f0 + t * (f1 - f0) - exact(x0 + t * (x1 - x0))) ** 2 * (x1 - x0) / parts
    return math.sqrt(total)


def largest_error(points, exact, bound):
    """Largest |value - exact| at nodes with |x| < bound."""
    return max(abs(f - exact(x)) for x, f in points if abs(x) < bound)


def mean_square(values):
    return math.sqrt(sum(v * v for v in values) / len(values))


def slope(pairs):
    """Least-squares slope of log(error) over log(h)."""
    x, y = [math.log(h) for h, _ in pairs], [math.log(e) for _, e in pairs]
    mx, my = sum(x) / len(x), sum(y) / len(y)
    return sum((u - mx) * (v - my) for u, v in zip(x, y)) / sum((u - mx) ** 2 for u in x)


def fitted(points, bound):
    """(p0, a) of the straight line through p^2 over x^2 at nodes with |x| < bound: free of what happens at the edge."""
    pairs = [(x * x, p * p) for x, p in points if abs(x) < bound]
    mx, my = sum(x for x, _ in pairs) / len(pairs), sum(y for _, y in pairs) / len(pairs)
    b = sum((x - mx) * (y - my) for x, y in pairs) / sum((x - mx) ** 2 for x, _ in pairs)
    return math.sqrt(my - b * mx), math.sqrt(mx - my / b)


def zone(old_size, size, shift):
    """Replacements that set size and centre of the fine zone."""
    return [("centre_mm = [0.0, 0.0]", f"centre_mm = [{shift:.9g}, 0.0]"), (f"size_mm = {old_size}", f"size_mm = {size:.9g}")]
