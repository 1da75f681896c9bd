#!/usr/bin/env python3
"""Reye against CalculiX and GetFEM on the same meshes: Hertz, Cattaneo-Mindlin and a fretting cycle in gross slip.

CalculiX's fretting cycle on the finest mesh (a good quarter of an hour) is left out unless REYE_PEERS_LONG is set.
A program that is not installed is said so in measured.json; the rest is measured.
"""
import math
import os
import pathlib
import platform
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import calculix as ccx  # noqa: E402
import cases  # noqa: E402
import contact_case as cc  # noqa: E402
import meshes  # noqa: E402
import programs  # noqa: E402
from wear_case import REYE, ROOT, WORK, figure, write_csv, write_measured  # noqa: E402

PER_HALF_WIDTH = (8, 16, 32)
POSITIONS = 3          # of the fine zone, a third of an element apart: errors are their root mean square
PENALTY = ccx.STIFFNESS_MPA_PER_MM


def mesh_of(scene, n, k, half_width, zone):
    """Reye's mesh of geo/<scene> with n elements per half width at position k, and the file it is in."""
    h = half_width / n
    source = ROOT / "geo" / scene / "scene.toml"
    lines = []
    for line in source.read_text(encoding="utf-8").splitlines():
        if line.startswith("fine_zone"):
            line = (f"fine_zone = {{ centre_mm = [{k * h / POSITIONS:.12g}, 0.0], half_width_mm = {zone[0]}, "
                    f"depth_mm = {zone[1]}, size_mm = {h:.12g} }}")
        lines.append(line.replace("far_size_mm = 0.8", "far_size_mm = 0.2")
                     .replace('geometry = ["', f'geometry = ["{source.parent}/'))
    name = f"{scene}_{n}_{k}"
    file = WORK / f"{name}.toml"
    file.write_text("\n".join(lines), encoding="utf-8")
    subprocess.run([REYE, "mesh", str(file), "--out", str(WORK / name)], check=True, stdout=subprocess.DEVNULL)
    written = WORK / name / "mesh.vtu"
    return meshes.read_vtu(written), written


def rows(triples):
    """Rows as in a surface table of Reye; what is a thousandth of the largest pressure or less is none."""
    floor = 1e-3 * max(p for _, p, _ in triples)
    return [{"x_mm": x, "pressure_MPa": p if p > floor else 0.0, "shear_MPa": q} for x, p, q in sorted(triples)]


def reye_rows(table):
    return rows([(r["x_mm"], r["pressure_MPa"], r["shear_MPa"]) for r in table])


def getfem_case(mesh, values, h, increments):
    """What getfem_contact.py reads. The augmentation parameter is E / h."""
    edges = {name: mesh.nodes_on(name) for name in ("cylinder_top", "cylinder_round", "flat_top", "flat_bottom")}
    return dict(edges, nodes=mesh.nodes, quads=mesh.quads, E_MPa=cases.E_MPA, nu=cases.NU,
                friction=values.get("friction", 0.0), driven="Q" in values, reach_mm=0.05, increments=increments,
                augmentation_MPa_per_mm=cases.E_MPA / h, approach_mm=approach(values))


def approach(values):
    """About a third of Hertz's a^2 / 2R."""
    return values["a"] ** 2 / 36.0


def getfem_rows(answer):
    """Rows from the multiplier on the flat's top."""
    x = answer["x_mm"][0::2]
    t = answer["traction"]
    return rows([(a, -t[2 * i + 1], t[2 * i]) for i, a in enumerate(x)])


def calculix_case(values, slave):
    master = {"flat_top": "cylinder_round", "cylinder_round": "flat_top"}[slave]
    return dict(values, E_MPa=cases.E_MPA, nu=cases.NU, overlap_mm=approach(values), driven="Q" in values, slave=slave,
                master=master, friction=values.get("friction", 0.0), stick_MPa_per_mm=PENALTY)


def calculix_frames(name, mesh, slave):
    return [rows(ccx.tractions(mesh, slave, frame)) for frame in ccx.stresses(WORK / f"{name}.dat")]


def own_frames(name, mesh, slave):
    """The same with the nodal pressure that CalculiX itself writes."""
    return [rows([(mesh.nodes[i][0], frame.get(i, 0.0), 0.0) for i in mesh.nodes_on(slave)])
            for frame in ccx.nodal_pressures(WORK / f"{name}.frd")]


def pressure_errors(table, values):
    """(L2 of the pressure, error of the peak), relative; the values linear between the nodes."""
    a, p0 = values["a"], values["p0"]
    points = cc.profile(table, "pressure_MPa", 1)
    l2 = cc.l2_error(points, lambda x: cc.hertz(x, a, p0)) / (p0 * math.sqrt(4.0 * a / 3.0))
    return l2, max(p for _, p in points) / p0 - 1.0


def shear_error(table):
    """Relative L2 error of the shear in partial slip."""
    c = cases.MINDLIN
    def exact(x):
        return cc.mindlin(x, c["a"], c["c"], c["friction"] * c["p0"])
    points = cc.profile(table, "shear_MPa", 1)
    sign = math.copysign(1.0, sum(q for _, q in points))
    norm = cc.l2_error([(-c["a"], 0.0), (c["a"], 0.0)], exact, 4000)
    return cc.l2_error([(x, sign * q) for x, q in points], exact) / norm


def jitter(tables, values):
    """Largest distance of a nodal pressure within 0.8 a from the increment's own smooth profile, over p0: Hertz's about
    the pressure centroid, its height fitted."""
    a, p0 = values["a"], values["p0"]
    worst = 0.0
    for table in tables:
        points = [(x, p) for x, p in cc.profile(table, "pressure_MPa", 0) if abs(x) < 0.8 * a]
        smooth = [cc.hertz(x, a, 1.0) for x, _ in points]
        height = sum(p * s for (_, p), s in zip(points, smooth)) / sum(s * s for s in smooth)
        worst = max(worst, *(abs(p - height * s) / p0 for (_, p), s in zip(points, smooth)))
    return worst


def sliding(frames):
    """Of the press and 40 increments, those in gross slip: neither the press nor the first two after each reversal."""
    return [f for i, f in enumerate(frames) if i > 2 and i not in (11, 12, 31, 32)]


def hertz(n, present):
    """{program: {measure: value}} over the positions of the mesh."""
    found = {name: {"cpu": [], "l2": [], "peak": []} for name in present}
    inner, own, dofs = [], [], 0
    for k in range(POSITIONS):
        mesh, written = mesh_of("hertz", n, k, cases.HERTZ["a"], (0.15, 0.12))
        dofs = 2 * len(mesh.nodes)
        name, h = f"hertz_{n}_{k}", cases.HERTZ["a"] / n
        answers = {}
        cpu, run_cpu, run = programs.reye(f"reye_{name}", cases.hertz(written), repeats=3)
        inner.append(run_cpu)
        answers["Reye"] = cpu, reye_rows(run.last("secondary"))
        if "CalculiX" in present:
            cpu = programs.calculix(f"ccx_{name}", ccx.hertz(mesh, calculix_case(cases.HERTZ, "flat_top")))
            answers["CalculiX"] = cpu, calculix_frames(f"ccx_{name}", mesh, "flat_top")[-1]
            own.append(pressure_errors(own_frames(f"ccx_{name}", mesh, "flat_top")[-1], cases.HERTZ)[0])
        if "GetFEM" in present:
            case = getfem_case(mesh, cases.HERTZ, h, [(cases.HERTZ["P"], 0.0)])
            cpu, answer = programs.getfem(f"getfem_{name}", case)
            answers["GetFEM"] = cpu, getfem_rows(answer)
        for program, (cpu, table) in answers.items():
            l2, peak = pressure_errors(table, cases.HERTZ)
            for key, value in (("cpu", cpu), ("l2", l2), ("peak", peak)):
                found[program][key].append(value)
    result = {p: {"dofs": dofs, "cpu": sorted(v["cpu"])[POSITIONS // 2], "l2": cc.mean_square(v["l2"]),
                  "peak": cc.mean_square(v["peak"])} for p, v in found.items()}
    result["Reye"]["cpu_without_start"] = sorted(inner)[POSITIONS // 2]
    if own:
        result["CalculiX"]["l2_of_its_nodal_pressure"] = cc.mean_square(own)
    return result


def mindlin(n, present):
    c = cases.MINDLIN
    mesh, written = mesh_of("hertz", n, 0, c["a"], (0.15, 0.12))
    name, answers = f"mindlin_{n}", {}
    cpu, inner, run = programs.reye(f"reye_{name}", cases.mindlin(written), repeats=3)
    answers["Reye"] = cpu, reye_rows(run.last("secondary"))
    if "CalculiX" in present:
        cpu = programs.calculix(f"ccx_{name}", ccx.mindlin(mesh, calculix_case(c, "flat_top")))
        answers["CalculiX"] = cpu, calculix_frames(f"ccx_{name}", mesh, "flat_top")[-1]
    if "GetFEM" in present:
        steps = [(c["P"], c["Q"] * i / c["increments"]) for i in range(c["increments"] + 1)]
        cpu, answer = programs.getfem(f"getfem_{name}", getfem_case(mesh, c, c["a"] / n, steps))
        answers["GetFEM"] = cpu, getfem_rows(answer)
    result = {}
    for program, (cpu, table) in answers.items():
        l2, peak = pressure_errors(table, c)
        result[program] = {"dofs": 2 * len(mesh.nodes), "cpu": cpu, "l2": l2, "peak": peak, "shear": shear_error(table)}
    result["Reye"]["cpu_without_start"] = inner
    return result


def fretting(n, present):
    """One cycle; Reye's with wear and moved shape, CalculiX's without."""
    c = cases.FRETTING
    mesh, written = mesh_of("fretting_mccoll", n, 0, c["a"], (0.08, 0.05))
    name, side, dofs = f"fretting_{n}", "cylinder_round", 2 * len(mesh.nodes)
    result = {}
    one, inner, _ = programs.reye(f"reye_{name}_1", cases.fretting(written, 1), repeats=3)
    more, _, _ = programs.reye(f"reye_{name}_4", cases.fretting(written, 4), repeats=3)
    _, _, still = programs.reye(f"reye_{name}_still", cases.fretting(written))
    frames = [reye_rows(table) for _, table in still.frames("secondary")]
    result["Reye"] = {"dofs": dofs, "cpu": one, "cpu_without_start": inner, "cpu_of_one_more_cycle": (more - one) / 3.0,
                      "jitter": jitter(sliding(frames[-c["increments"] - 1:]), c)}
    if "CalculiX" in present and (n < PER_HALF_WIDTH[-1] or os.environ.get("REYE_PEERS_LONG")):
        cpu = programs.calculix(f"ccx_{name}", ccx.fretting(mesh, dict(calculix_case(c, side), stroke_mm=c["stroke"])))
        forces, own = calculix_frames(f"ccx_{name}", mesh, side), own_frames(f"ccx_{name}", mesh, side)
        result["CalculiX"] = {"dofs": dofs, "cpu": cpu, "jitter": jitter(sliding(forces), c),
                              "jitter_of_its_nodal_pressure": jitter(sliding(own), c)}
    return result


def at_error(table, program, error):
    """CPU of a command at an L2 error, by the power law through the two meshes nearest to it."""
    pairs = sorted(((t[program]["l2"], t[program]["cpu"]) for t in table.values()),
                   key=lambda pair: abs(math.log(pair[0] / error)))[:2]
    return pairs[0][1] * (error / pairs[0][0]) ** cc.slope(pairs)


def machine():
    for line in pathlib.Path("/proc/cpuinfo").read_text(encoding="ascii").splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return platform.processor()


def commit():
    return programs.first_line(["git", "-C", str(ROOT), "rev-parse", "--short", "HEAD"])


def write_figures(study, installed):
    header = ["case", "elements_per_half_width", "program", "dofs", "measure", "value"]
    lines = [["machine", "", machine(), "", "", ""], ["commit", "", commit(), "", "", ""]]
    lines += [["peers' runs taken over from earlier", "", "", "", str(len(programs.TAKEN_OVER)), ""]]
    lines += [["version", "", program, "", version or "not installed", ""] for program, version in installed.items()]
    for case, table in study.items():
        for n, programs_of in table.items():
            for program, values in programs_of.items():
                lines += [[case, n, program, values["dofs"], k, f"{v:.4g}"] for k, v in values.items() if k != "dofs"]
    write_csv("figures.csv", header, lines)


def measures(study, installed):
    """The numbers that are compared: ratios and errors; a word for what an absent program leaves out."""
    out = {}
    h, m, f = study["hertz"], study["mindlin"], study["fretting"]
    for n in PER_HALF_WIDTH:
        out[f"hertz_l2_reye_{n}"] = h[n]["Reye"]["l2"]
        out[f"mindlin_shear_l2_reye_{n}"] = m[n]["Reye"]["shear"]
        out[f"jitter_reye_{n}"] = f[n]["Reye"]["jitter"]
    for program in ("CalculiX", "GetFEM"):
        absent = f"{program} is not installed" if not installed[program] else None
        for n in PER_HALF_WIDTH:
            out[f"hertz_equal_l2_{program}_over_Reye_{n}"] = absent or (
                at_error(h, program, h[n]["Reye"]["l2"]) / h[n]["Reye"]["cpu"])
            out[f"hertz_l2_{program}_over_Reye_{n}"] = absent or h[n][program]["l2"] / h[n]["Reye"]["l2"]
            out[f"hertz_cpu_{program}_over_Reye_{n}"] = absent or h[n][program]["cpu"] / h[n]["Reye"]["cpu"]
            out[f"mindlin_cpu_{program}_over_Reye_{n}"] = absent or m[n][program]["cpu"] / m[n]["Reye"]["cpu"]
    absent = None if installed["CalculiX"] else "CalculiX is not installed"
    for n in PER_HALF_WIDTH[:2]:    # the finest one is not made by default
        theirs, ours = f[n].get("CalculiX"), f[n]["Reye"]
        out[f"fretting_cycle_CalculiX_over_Reye_{n}"] = absent or theirs["cpu"] / ours["cpu_of_one_more_cycle"]
        out[f"fretting_command_CalculiX_over_Reye_{n}"] = absent or theirs["cpu"] / ours["cpu"]
        out[f"jitter_CalculiX_{n}"] = absent or theirs["jitter"]
    return out


def main():
    WORK.mkdir(parents=True, exist_ok=True)
    installed = programs.versions()
    present = [program for program, version in installed.items() if version]
    for program, version in installed.items():
        print(f"{program}: {version or 'not installed, left out'}", flush=True)
    study = {"hertz": {}, "mindlin": {}, "fretting": {}}
    for name, case in (("hertz", hertz), ("mindlin", mindlin), ("fretting", fretting)):
        for n in PER_HALF_WIDTH:
            study[name][n] = case(n, present)
            print(name, n, study[name][n], flush=True)
    write_figures(study, installed)
    write_measured(measures(study, installed))
    draw(study["hertz"], present)


def draw(table, present):
    """CPU time over error."""
    for program in present:
        write_csv(f"hertz_{program.lower()}.csv", ["l2_error", "cpu_s"],
                  [[t[program]["l2"], t[program]["cpu"]] for t in table.values()])
    curves = ", ".join(f"'hertz_{p.lower()}.csv' skip 1 using 1:2 with linespoints pt {5 + 2 * i} title '{p}'"
                       for i, p in enumerate(present))
    write_csv("hertz_reye_without_start.csv", ["l2_error", "cpu_s"],
              [[t["Reye"]["l2"], t["Reye"]["cpu_without_start"]] for t in table.values()])
    figure("set logscale xy\nset xlabel 'relative L2 error of the pressure'\nset ylabel 'CPU [s]'\n"
           "set title 'Hertz, the same meshes: 8, 16, 32 elements per half width'\n"
           f"plot {curves}, 'hertz_reye_without_start.csv' skip 1 using 1:2 with linespoints dt 2 pt 6 "
           "title 'Reye without start and reading the mesh'\n")


if __name__ == "__main__":
    main()
