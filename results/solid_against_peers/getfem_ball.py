#!/usr/bin/python3
"""A ball pressed on a flat and slid in GetFEM, on a ready mesh; run by Debian's own Python, which python3-getfem belongs to.

  getfem_ball.py CASE.json RESULT.json

Tetrahedra of second order; augmented Lagrangian (integral contact by ray tracing, large sliding), the multiplier of first
order on the ball, the slave side. The ball's top moves without turning: one unknown for its height, and what slides it;
it is tied to them by multipliers, and the plane of symmetry is held by springs, for multipliers of both would meet in edges.
"""
import json
import pathlib
import sys

import getfem as gf

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "against_peers"))
import getfem_parts as parts  # noqa: E402

TOP, CONTACT, BOTTOM, SYMMETRY = 1, 2, 3, 4
ORDER = [0, 4, 1, 6, 5, 2, 7, 8, 9, 3]    # of a tetrahedron's nodes in GetFEM, from VTK's
ELEMENT, INTEGRAL = "FEM_PK(3,2)", "IM_TETRAHEDRON(5)"
STIFF = 1e5                               # springs of the plane of symmetry [E / mm]


def prepared(case):
    """Model of both bodies, and what it needs to stay alive."""
    regions = {"ball": {TOP: case["top"], CONTACT: case["round"], SYMMETRY: case["symmetry"]},
               "flat": {BOTTOM: case["bottom"], CONTACT: case["face"], SYMMETRY: case["symmetry"]}}
    meshes = {name: parts.body(case["nodes"], [[c[k] for k in ORDER] for c in case[name]], "GT_PK(3,2)", of)
              for name, of in regions.items()}
    model = parts.model_of(case)
    model.add_initialized_data("stiff", [STIFF * case["E_MPa"]])
    model.add_initialized_data("aside", [0.0])
    made = {name: parts.elastic(model, name, mesh, ELEMENT, INTEGRAL) for name, mesh in meshes.items()}
    for name, (_, integration) in made.items():
        model.add_linear_term(integration, f"stiff*{name}(2)*Test_{name}(2)", SYMMETRY)
    model.add_variable("height", 1)
    parts.held(model, "ball", meshes["ball"], made["ball"][1], TOP, ELEMENT, "-height*[0;0;1]-aside*[1;0;0]",
               "-Test_height*[0;0;1]")
    parts.held(model, "flat", meshes["flat"], made["flat"][1], BOTTOM, ELEMENT)
    traction = parts.space_of(meshes["ball"], "FEM_PK(3,1)")
    parts.contact(model, case, made, "ball", "flat", traction, CONTACT)
    parts.approach(model, "ball", made["ball"][0], case["approach_mm"])
    return model, made, (meshes, traction)


def main(case_file, result_file):
    with open(case_file, encoding="utf-8") as file:
        case = json.load(file)
    model, made, _alive = prepared(case)
    push = model.add_explicit_rhs("height", [0.0])
    iterations, frictions = 0, []
    for force, aside in case["increments"]:
        model.set_private_rhs(push, [-force])
        model.set_variable("aside", [aside])
        count = parts.solve(model, made)
        if count is None:
            sys.exit(f"no convergence at {force}, {aside}")
        iterations += count
        frictions.append(abs(float(gf.asm_generic(made["ball"][1], 0, "traction(1)", CONTACT, model))))
    with open(result_file, "w", encoding="utf-8") as file:
        json.dump({"friction_N": frictions, "iterations": iterations}, file)


if __name__ == "__main__":
    main(*sys.argv[1:3])
