#!/usr/bin/env python3
"""Reye against CalculiX and GetFEM in space: a ball pressed on a flat, then one cycle of gross slip in 40 increments, on
one mesh.

CalculiX and GetFEM take a quarter of an hour each. Where either is not installed (`apt-get install calculix-ccx
python3-getfem`), the case is left out.
"""
import pathlib
import subprocess
import sys
import xml.etree.ElementTree as xml

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent), str(HERE.parent / "against_peers")]
import meshes  # noqa: E402
import programs  # noqa: E402
from wear_case import REYE, ROOT, WORK, read_csv, write_csv, write_measured  # noqa: E402

SCENE = ROOT / "geo" / "sliding_ball"
E_MPA, NU, FRICTION, FORCE_N, STROKE_MM, RADIUS_MM, INCREMENTS = 210e3, 0.3, 0.6, 1540.0, 0.2, 50.0, 40
NEAR_MM = 3.0                       # facets so near to the first point of contact are paired
OVERLAP_MM = 0.002                  # of the start: some points touch at once; under a force it changes nothing else
PENALTY_MPA_PER_MM, STICK_MPA_PER_MM = 100.0 * E_MPA, 10.0 * E_MPA
FACET_MM = 0.27
FACES = ((0, 1, 2), (0, 3, 1), (1, 3, 2), (2, 3, 0))    # of a tetrahedron, in CalculiX's order
TET10 = 24                          # VTK's number of the cell


def scene_text():
    """geo/sliding_ball with larger elements: some 38 000 dofs, 360 nodes of either side."""
    text = (SCENE / "scene.toml").read_text(encoding="utf-8")
    for old, new in (("size_mm = 0.19", f"size_mm = {FACET_MM}"), ("far_size_mm = 8.0", "far_size_mm = 12.0"),
                     ('["sliding_ball.geo"]', f'["{SCENE}/sliding_ball.geo"]')):
        assert old in text
        text = text.replace(old, new)
    return text


def read_mesh(path):
    """(positions, tetrahedra of ten nodes); the ball's are those above z = 0."""
    root = xml.parse(path).getroot()
    flat = meshes.array(root, "Points")
    nodes = list(zip(flat[0::3], flat[1::3], flat[2::3]))
    connectivity, ends = meshes.array(root, "connectivity"), meshes.array(root, "offsets")
    kinds = meshes.array(root, "types")
    cells = [connectivity[end - 10:end] for end, kind in zip(ends, kinds) if kind == TET10]
    return nodes, cells


def sets_of(nodes, cells):
    """Node sets by where the nodes lie, and the facets of either side near the contact as (element, face)."""
    balls = [sum(nodes[n][2] for n in cell[:4]) > 0.0 for cell in cells]
    of_ball = {n for cell, is_ball in zip(cells, balls) if is_ball for n in cell}
    tables = {"TOP": [n for n in sorted(of_ball) if nodes[n][2] > RADIUS_MM - 1e-6],
              "BOTTOM": [n for n, x in enumerate(nodes) if x[2] < -RADIUS_MM + 1e-6],
              "SYMMETRY": [n for n, x in enumerate(nodes) if abs(x[1]) < 1e-9]}

    def on_side(x, is_ball):
        if sum(c * c for c in x) > NEAR_MM ** 2:
            return False
        centre_distance = (x[0] ** 2 + x[1] ** 2 + (x[2] - RADIUS_MM) ** 2) ** 0.5
        return abs(centre_distance - RADIUS_MM) < 1e-6 if is_ball else abs(x[2]) < 1e-9

    facets = {True: [], False: []}
    for e, (cell, is_ball) in enumerate(zip(cells, balls), 1):
        for f, face in enumerate(FACES, 1):
            if all(on_side(nodes[cell[k]], is_ball) for k in face):
                facets[is_ball].append((e, f))
    return tables, of_ball, facets


def deck(nodes, cells):
    """Surface-to-surface penalty contact; the ball's top is rigid and does not turn: one height, moved along x."""
    tables, of_ball, facets = sets_of(nodes, cells)
    lines = ["*NODE,NSET=ALL"]
    for n, (x, y, z) in enumerate(nodes):
        lines.append(f"{n + 1},{x:.12e},{y:.12e},{z - (OVERLAP_MM if n in of_ball else 0.0):.12e}")
    lines.append("*ELEMENT,TYPE=C3D10,ELSET=SOLIDS")
    lines += [",".join(str(k) for k in (e, *(n + 1 for n in cell))) for e, cell in enumerate(cells, 1)]
    for name, members in tables.items():
        lines += [f"*NSET,NSET={name}"] + [str(n + 1) for n in members]
    for is_ball, name in ((True, "BALL"), (False, "FLAT")):
        lines.append(f"*SURFACE,NAME={name},TYPE=ELEMENT")
        lines += [f"{e},S{f}" for e, f in facets[is_ball]]
    leader = tables["TOP"][0] + 1
    lines += [text for n in tables["TOP"][1:] for text in ("*EQUATION", "2", f"{n + 1},3,1.,{leader},3,-1.")]
    lines += ["*MATERIAL,NAME=STEEL", "*ELASTIC", f"{E_MPA},{NU}",
              "*SOLID SECTION,ELSET=SOLIDS,MATERIAL=STEEL",
              "*BOUNDARY", "BOTTOM,1,3", "SYMMETRY,2,2", "TOP,1,2",
              "*SURFACE INTERACTION,NAME=PAD", "*SURFACE BEHAVIOR,PRESSURE-OVERCLOSURE=LINEAR", f"{PENALTY_MPA_PER_MM}",
              "*FRICTION", f"{FRICTION},{STICK_MPA_PER_MM}",
              "*CONTACT PAIR,INTERACTION=PAD,TYPE=SURFACE TO SURFACE", "BALL,FLAT",
              "*AMPLITUDE,NAME=SLIDE", "0.,0.,0.25,1.,0.75,-1.,1.,0."]
    output = ["*NODE PRINT,NSET=BOTTOM,TOTALS=ONLY", "RF", "*END STEP"]
    lines += ["*STEP,INC=1000", "*STATIC,DIRECT", "0.5,1.", "*CLOAD", f"{leader},3,{-FORCE_N}", *output]
    lines += ["*STEP,INC=1000", "*STATIC,DIRECT", f"{1.0 / INCREMENTS},1.",
              "*BOUNDARY,AMPLITUDE=SLIDE", f"TOP,1,1,{STROKE_MM}", *output]
    return "\n".join(lines) + "\n"


def getfem_case(nodes, cells):
    """What getfem_ball.py reads: the same facets, and the same path, pressed in two increments."""
    tables, of_ball, facets = sets_of(nodes, cells)
    paired = {is_ball: sorted({cells[e - 1][k] for e, f in facets[is_ball] for k in face_nodes(f)}) for is_ball in facets}
    slide = [(FORCE_N, STROKE_MM * aside) for aside in slid_shares()]
    return {"nodes": nodes, "ball": [c for c in cells if c[0] in of_ball], "flat": [c for c in cells if c[0] not in of_ball],
            "top": tables["TOP"], "bottom": tables["BOTTOM"], "symmetry": tables["SYMMETRY"], "round": paired[True],
            "face": paired[False], "E_MPa": E_MPA, "nu": NU, "friction": FRICTION, "reach_mm": 0.5,
            "augmentation_MPa_per_mm": E_MPA / FACET_MM, "approach_mm": OVERLAP_MM,
            "increments": [(0.5 * FORCE_N, 0.0), (FORCE_N, 0.0), *slide]}


def face_nodes(face):
    """All six nodes of a facet, by their places in a cell."""
    corners = FACES[face - 1]
    edges = {frozenset(e): 4 + k for k, e in enumerate(((0, 1), (1, 2), (0, 2), (0, 3), (1, 3), (2, 3)))}
    return [*corners, *(edges[frozenset((corners[i], corners[i - 1]))] for i in range(3))]


def slid_shares():
    """Shares of the stroke at the ends of the increments of the cycle: out, across and back."""
    ends = [(k + 1) / INCREMENTS for k in range(INCREMENTS)]
    return [4.0 * t if t <= 0.25 else 2.0 - 4.0 * t if t <= 0.75 else 4.0 * t - 4.0 for t in ends]


def frictions(path):
    """Size of the reaction along x of each increment in a .dat file."""
    words = [line.split() for line in path.read_text(encoding="ascii").splitlines()]
    words = [w for w in words if w]
    return [abs(float(after[0])) for before, after in zip(words, words[1:]) if before[:2] == ["total", "force"]]


def main():
    WORK.mkdir(parents=True, exist_ok=True)
    for program in ("CalculiX", "GetFEM"):
        if not programs.versions()[program]:
            return write_measured(f"{program} is not installed")
    file = WORK / "ball.toml"
    file.write_text(scene_text(), encoding="utf-8")
    subprocess.run([REYE, "mesh", str(file), "--out", str(WORK / "mesh")], check=True, stdout=subprocess.DEVNULL)
    nodes, cells = read_mesh(WORK / "mesh" / "mesh.vtu")
    cpu, _, _ = programs.reye("ball", scene_text(), repeats=5)
    theirs_cpu = programs.calculix("ccx_ball", deck(nodes, cells))
    theirs = frictions(WORK / "ccx_ball.dat")[-INCREMENTS:]
    getfem_cpu, answer = programs.getfem("getfem_ball", getfem_case(nodes, cells), HERE / "getfem_ball.py")
    getfem = answer["friction_N"][-INCREMENTS:]
    ours = [abs(float(r["table_force_x_N"])) for r in read_csv(WORK / "ball" / "history.csv")[-INCREMENTS:]]
    slips = slice(1, 10)      # increments of the first quarter: after it CalculiX's springs first have to turn round
    write_csv("cycle.csv", ("increment", "friction_N", "friction_of_CalculiX_N", "friction_of_GetFEM_N"),
              [(i + 1, *row) for i, row in enumerate(zip(ours, theirs, getfem))])
    dofs = 3 * len(nodes)
    write_csv("figures.csv", ("program", "dofs", "cpu_s"),
              [("Reye", dofs, cpu), ("CalculiX", dofs, theirs_cpu), ("GetFEM", dofs, getfem_cpu)])
    limit = FRICTION * FORCE_N
    write_measured({"dofs": dofs, "reye_cpu_s": cpu, "calculix_cpu_s": theirs_cpu, "calculix_over_reye": theirs_cpu / cpu,
                    "getfem_cpu_s": getfem_cpu, "getfem_over_reye": getfem_cpu / cpu,
                    "friction_over_calculix": sum(ours[slips]) / sum(theirs[slips]),
                    "friction_over_coulomb": sum(ours[slips]) / len(ours[slips]) / limit,
                    "friction_apart_from_getfem": max(abs(a - b) for a, b in zip(ours, getfem)) / limit})


if __name__ == "__main__":
    main()
