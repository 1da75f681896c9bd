"""Decks for CalculiX on a ready mesh, and what it answers.

Quadrilaterals CPE4, surface-to-surface penalty contact with an explicit stiffness (HARD would be 50 E). The half disc's
flat side is rigid by equations: one height, one sideways motion. It starts `overlap_mm` deep in the flat, so that some
points touch at once; with a force on it that changes nothing else.
"""
import math

STIFFNESS_MPA_PER_MM = 2000 * 200e3
GAUSS = 1.0 / math.sqrt(3.0)


def numbered(mesh):
    """[(element number, body, nodes)] and the element and face of each boundary facet."""
    cells, face_of = [], {}
    for body, quads in mesh.quads.items():
        for quad in quads:
            number = len(cells) + 1
            cells.append((number, body, quad))
            for k in range(4):
                face_of[quad[k], quad[(k + 1) % 4]] = (number, k + 1)
    return cells, face_of


def row(mesh, cells, slave):
    """Elements with a node on the slave side: their stresses give the contact forces."""
    side = set(mesh.nodes_on(slave))
    return [cell for cell in cells if side.intersection(cell[2])]


def deck(mesh, case, steps):
    """Text of a deck; steps = [(increments, [lines of loads])]."""
    cells, face_of = numbered(mesh)
    moved = {n for quad in mesh.quads["cylinder"] for n in quad}
    overlap = case["overlap_mm"]
    lines = ["*NODE,NSET=ALL"]
    for n, (x, y) in enumerate(mesh.nodes):
        lines.append(f"{n + 1},{x:.12e},{y - (overlap if n in moved else 0.0):.12e},0.")
    for body in mesh.quads:
        lines.append(f"*ELEMENT,TYPE=CPE4,ELSET={body.upper()}")
        lines += [",".join(map(str, [e, *(n + 1 for n in quad)])) for e, name, quad in cells if name == body]
    lines += ["*ELSET,ELSET=ROW"] + [str(e) for e, _, _ in row(mesh, cells, case["slave"])]
    for name in ("flat_top", "cylinder_round"):
        lines.append(f"*SURFACE,NAME={name.upper()},TYPE=ELEMENT")
        lines += ["{},S{}".format(*face_of[facet]) for facet in mesh.edges[name]]
    lines += ["*MATERIAL,NAME=STEEL", "*ELASTIC", f"{case['E_MPa']},{case['nu']}"]
    for body in mesh.quads:
        lines += [f"*SOLID SECTION,ELSET={body.upper()},MATERIAL=STEEL", "1."]
    lines += held(mesh, case)
    lines += ["*SURFACE INTERACTION,NAME=PAD", "*SURFACE BEHAVIOR,PRESSURE-OVERCLOSURE=LINEAR",
              f"{STIFFNESS_MPA_PER_MM}"]
    if case["friction"] > 0.0:
        lines += ["*FRICTION", f"{case['friction']},{case['stick_MPa_per_mm']}"]
    lines += ["*CONTACT PAIR,INTERACTION=PAD,TYPE=SURFACE TO SURFACE", f"{case['slave']},{case['master']}".upper()]
    for increments, loads in steps:
        lines += ["*STEP,INC=1000", "*STATIC,DIRECT", f"{1.0 / increments},1.", *loads,
                  "*EL PRINT,ELSET=ROW", "S", "*CONTACT FILE", "CSTR", "*END STEP"]
    return "\n".join(lines) + "\n"


def leader(mesh):
    """The node that carries the rigid top's motion."""
    return mesh.nodes_on("cylinder_top")[0] + 1


def held(mesh, case):
    """Supports: the rigid top, sideways free when a force drives it, and the bottom."""
    top, first = mesh.nodes_on("cylinder_top"), leader(mesh)
    tied = (1, 2) if case["driven"] else (2,)
    lines = [text for n in top[1:] for d in tied for text in ("*EQUATION", "2", f"{n + 1},{d},1.,{first},{d},-1.")]
    lines += ["*NSET,NSET=TOP"] + [str(n + 1) for n in top]
    lines += ["*NSET,NSET=BOTTOM"] + [str(n + 1) for n in mesh.nodes_on("flat_bottom")]
    return lines + ["*BOUNDARY", "BOTTOM,1,2"] + ([] if case["driven"] else ["TOP,1,1"])


def hertz(mesh, case):
    return deck(mesh, case, [(1, ["*CLOAD", f"{leader(mesh)},2,{-case['P']}"])])


def mindlin(mesh, case):
    press = f"{leader(mesh)},2,{-case['P']}"
    return deck(mesh, dict(case, driven=True), [
        (1, ["*BOUNDARY", f"{leader(mesh)},1,1", "*CLOAD", press]),
        (case["increments"], ["*BOUNDARY,OP=NEW", "BOTTOM,1,2", "*CLOAD", press, f"{leader(mesh)},1,{case['Q']}"])])


def fretting(mesh, case):
    """Press, then one cycle 0, +stroke, -stroke, 0 of the flat's bottom."""
    text = deck(mesh, case, [
        (1, ["*CLOAD", f"{leader(mesh)},2,{-case['P']}"]),
        (case["increments"], ["*BOUNDARY,AMPLITUDE=STROKE", f"BOTTOM,1,1,{case['stroke_mm']}"])])
    return text.replace("*STEP", "*AMPLITUDE,NAME=STROKE\n0.,0.,0.25,1.,0.75,-1.,1.,0.\n*STEP", 1)


def stresses(path):
    """{(element, point): (sxx, syy, sxy)} of every increment in a .dat file."""
    frames = []
    with open(path, encoding="ascii") as file:
        for line in file:
            words = line.split()
            if words[:1] == ["stresses"]:
                frames.append({})
            elif len(words) == 8 and frames:
                frames[-1][int(words[0]), int(words[1])] = (float(words[2]), float(words[3]), float(words[5]))
    return frames


def gradients(corners, xi, eta):
    """Jacobian and shape function gradients of a quadrilateral at a point."""
    d = [(-(1 - eta) / 4, -(1 - xi) / 4), ((1 - eta) / 4, -(1 + xi) / 4),
         ((1 + eta) / 4, (1 + xi) / 4), (-(1 + eta) / 4, (1 - xi) / 4)]
    (a, b), (c, e) = [[sum(d[k][i] * corners[k][j] for k in range(4)) for j in range(2)] for i in range(2)]
    det = a * e - b * c
    return det, [((e * p - b * q) / det, (a * q - c * p) / det) for p, q in d]


def tractions(mesh, slave, frame):
    """[(x, pressure, shear)] of the slave side: nodal contact force, from the stresses of the elements at the node, by
    nodal length along x. The eight points of the slab that CalculiX makes of an element are taken in pairs."""
    side = mesh.nodes_on(slave)
    force = {n: [0.0, 0.0] for n in side}
    for e, _, quad in row(mesh, numbered(mesh)[0], slave):
        corners = [mesh.nodes[n] for n in quad]
        for k, (xi, eta) in enumerate([(-GAUSS, -GAUSS), (GAUSS, -GAUSS), (-GAUSS, GAUSS), (GAUSS, GAUSS)], 1):
            det, grad = gradients(corners, xi, eta)
            sx, sy, sxy = [0.5 * (p + q) for p, q in zip(frame[e, k], frame[e, k + 4])]
            for n, (gx, gy) in zip(quad, grad):
                if n in force:
                    force[n][0] += det * (gx * sx + gy * sxy)
                    force[n][1] += det * (gy * sy + gx * sxy)
    outward = 1.0 if slave == "flat_top" else -1.0
    rows = []
    for before, n, after in zip(side, side[1:], side[2:]):
        length = 0.5 * (mesh.nodes[after][0] - mesh.nodes[before][0])
        rows.append((mesh.nodes[n][0], -outward * force[n][1] / length, force[n][0] / length))
    return rows


def nodal_pressures(path):
    """[{node: pressure}] of every increment as CalculiX itself writes it at the slave nodes (.frd, CSTR)."""
    frames, reading = [], False
    with open(path, encoding="ascii", errors="replace") as file:
        for line in file:
            if line.startswith(" -4  CONTACT"):
                frames.append({})
                reading = True
            elif line.startswith(" -3"):
                reading = False
            elif reading and line.startswith(" -1"):
                frames[-1][int(line[3:13]) - 1] = float(line[13 + 36:25 + 36])
    return frames
