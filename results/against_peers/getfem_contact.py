#!/usr/bin/python3
"""One contact case in GetFEM on a ready mesh; run by Debian's own Python, which python3-getfem belongs to.

  getfem_contact.py CASE.json RESULT.json

Quadrilaterals of first order, plane strain; augmented Lagrangian (integral contact by ray tracing, large sliding), the
multiplier of first order on the flat's top. The half disc's flat side moves as a rigid line without turning: one
unknown for its height, one for its sideways motion where a force drives it, tied to the side by multipliers.
"""
import json
import sys

import getfem_parts as parts

TOP, CONTACT, BOTTOM = 1, 2, 3
ELEMENT, INTEGRAL = "FEM_QK(2,1)", "IM_GAUSS_PARALLELEPIPED(2,3)"


def prepared(case):
    """Model with both bodies, supports and contact, the multiplier's space, and what both need to stay alive."""
    nodes = case["nodes"]
    quads = {name: [[q[k] for k in (0, 1, 3, 2)] for q in cells] for name, cells in case["quads"].items()}
    meshes = {"cylinder": parts.body(nodes, quads["cylinder"], "GT_QK(2,1)",
                                     {TOP: case["cylinder_top"], CONTACT: case["cylinder_round"]}),
              "flat": parts.body(nodes, quads["flat"], "GT_QK(2,1)",
                                 {BOTTOM: case["flat_bottom"], CONTACT: case["flat_top"]})}
    model = parts.model_of(case)
    made = {name: parts.elastic(model, name, mesh, ELEMENT, INTEGRAL) for name, mesh in meshes.items()}
    model.add_variable("height", 1)
    motion, tested = "-height*[0;1]", "-Test_height*[0;1]"
    if case["driven"]:
        model.add_variable("aside", 1)
        motion, tested = motion + "-aside*[1;0]", tested + "-Test_aside*[1;0]"
    parts.held(model, "cylinder", meshes["cylinder"], made["cylinder"][1], TOP, ELEMENT, motion, tested)
    parts.held(model, "flat", meshes["flat"], made["flat"][1], BOTTOM, ELEMENT)
    space = parts.space_of(meshes["flat"], ELEMENT)
    parts.contact(model, case, made, "flat", "cylinder", space, CONTACT)
    parts.approach(model, "cylinder", made["cylinder"][0], case["approach_mm"])
    return model, space, (meshes, made)


def main(case_file, result_file):
    with open(case_file, encoding="utf-8") as file:
        case = json.load(file)
    model, space, _alive = prepared(case)
    push = model.add_explicit_rhs("height", [0.0])
    pull = model.add_explicit_rhs("aside", [0.0]) if case["driven"] else None
    iterations = 0
    for force, sideways in case["increments"]:
        model.set_private_rhs(push, [-force])
        if pull is not None:
            model.set_private_rhs(pull, [sideways])
        count = parts.solve(model, ("cylinder", "flat"))
        if count is None:
            sys.exit(f"no convergence at {force}, {sideways}")
        iterations += count
    kept = space.basic_dof_on_region(CONTACT)
    with open(result_file, "w", encoding="utf-8") as file:
        json.dump({"x_mm": list(space.basic_dof_nodes()[0, kept]), "traction": list(model.variable("traction")),
                   "iterations": iterations}, file)


if __name__ == "__main__":
    main(*sys.argv[1:3])
