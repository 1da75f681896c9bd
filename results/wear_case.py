"""Runs of a scene of geo/ with some of its words replaced, and their tables; used by the make.py of the wear cases."""
import bisect
import csv
import json
import os
import pathlib
import subprocess

ROOT = pathlib.Path(__file__).resolve().parent.parent
REYE = os.environ.get("REYE", str(ROOT / "build" / "bin" / "reye"))
WORK = pathlib.Path(os.environ.get("REYE_WORK", ROOT / "build" / "results" / pathlib.Path.cwd().name))


class Run:
    """A finished run: summary, history rows and frames of the surface tables."""

    def __init__(self, folder):
        self.folder = folder
        self.summary = json.loads((folder / "summary.json").read_text())
        self.history = [numbers(row) for row in read_csv(folder / "history.csv")]

    @property
    def contact(self):
        return next(iter(self.summary["contacts"].values()))

    def frames(self, side):
        """[(cycle, rows)], rows along the boundary."""
        name = next(iter(self.summary["contacts"]))
        frames = {}
        for row in map(numbers, read_csv(self.folder / f"surface_{name}_{side}.csv")):
            frames.setdefault(row["frame"], (row["cycle"], []))[1].append(row)
        return list(frames.values())

    def last(self, side):
        return self.frames(side)[-1][1]


def program(name):
    """A program of the build, beside the command; where it was not built the case is left out and ends here."""
    path = pathlib.Path(REYE).with_name(name)
    if not path.is_file():
        write_measured(f"{name} is not built")
        raise SystemExit(0)
    return path


def benchmarks(pattern):
    """What reye-bench reports of the benchmarks whose name fits a pattern: name, label, counters of each.
    One that failed ends the case."""
    told = subprocess.run([program("reye-bench"), f"--benchmark_filter={pattern}", "--benchmark_format=json"],
                          check=True, capture_output=True, text=True).stdout
    runs = json.loads(told)["benchmarks"]
    for run in runs:
        if run.get("error_occurred"):
            raise SystemExit(f"{run['name']}: {run['error_message']}")
    return runs


def read_csv(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def numbers(row):
    return {key: value if key in ("status", "step", "body") else float(value) for key, value in row.items()}


def run(scene, name, replacements=()):
    """Plays geo/<scene>/scene.toml with (from, to) replaced; each must be found."""
    source = ROOT / "geo" / scene
    text = (source / "scene.toml").read_text(encoding="utf-8")
    for before, after in replacements:
        if before not in text:
            raise SystemExit(f"{scene}: the scene does not say: {before}")
        text = text.replace(before, after)
    text = text.replace('geometry = ["', f'geometry = ["{source}/')
    WORK.mkdir(parents=True, exist_ok=True)
    file, out = WORK / f"{name}.toml", WORK / name
    file.write_text(text, encoding="utf-8")
    subprocess.run([REYE, "run", str(file), "--out", str(out), "--threads", "1", "--force", "--quiet"],
                   check=True)
    return Run(out)


def value_at(rows, key, x=0.0):
    """Column `key` at x by linear interpolation."""
    for a, b in zip(rows, rows[1:]):
        if (a["x_mm"] - x) * (b["x_mm"] - x) <= 0.0 and a["x_mm"] != b["x_mm"]:
            t = (x - a["x_mm"]) / (b["x_mm"] - a["x_mm"])
            return a[key] + t * (b[key] - a[key])
    raise ValueError(f"no row at x = {x}")


class Line:
    """Values over increasing x as straight lines between their points, zero outside."""

    def __init__(self, points):
        self.x, self.f = zip(*points)

    def __call__(self, x):
        k = bisect.bisect_right(self.x, x) - 1
        if k < 0 or k + 1 >= len(self.x):
            return 0.0
        t = (x - self.x[k]) / (self.x[k + 1] - self.x[k])
        return self.f[k] + t * (self.f[k + 1] - self.f[k])


def worn_profile(rows, most_y=0.5):
    """[(x, depth)] of a side along increasing x; of a round one its lower part."""
    return sorted((r["x_mm"], r["wear_depth_mm"]) for r in rows if r["y_mm"] < most_y)


def profile_error(points, exact):
    """int |w - w'| over int w', at the places of the exact points."""
    line = Line(points)

    def integral(f):
        return sum(0.5 * (f(*a) + f(*b)) * (b[0] - a[0]) for a, b in zip(exact, exact[1:]))
    return integral(lambda x, w: abs(w - line(x))) / integral(lambda x, w: w)


def half_width(points):
    """Half the distance between the zeros of lines through the two outermost of (x, f) at each end."""
    def zero(outer, inner):
        if inner[1] <= outer[1]:
            return outer[0]
        ratio = outer[1] / (inner[1] - outer[1])
        return outer[0] if ratio > 1.0 else outer[0] - ratio * (inner[0] - outer[0])
    return 0.5 * (zero(points[-1], points[-2]) - zero(points[0], points[1]))


def contact_half_width(rows):
    return half_width([(r["x_mm"], r["pressure_MPa"] ** 2) for r in rows if r["pressure_MPa"] > 0.0])


def write_csv(name, header, rows):
    with open(name, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(header)
        writer.writerows([f"{v:.9g}" if isinstance(v, float) else v for v in row] for row in rows)


def write_measured(measured):
    """The figures of a case, or a text that says why there are none here."""
    pathlib.Path("measured.json").write_text(json.dumps(measured, indent=2) + "\n", encoding="utf-8")


def figure(script):
    """A gnuplot figure; `script` names its output by figure.svg."""
    head = "set terminal svg size 720,480 dynamic background '#ffffff'\nset output 'figure.svg'\n" \
           "set datafile separator ','\nset grid\n"
    subprocess.run(["gnuplot"], input=head + script, text=True, check=True)
