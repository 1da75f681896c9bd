#!/usr/bin/python3
"""A ball pressed on a flat and slid in GetFEM, on a ready mesh; run by Debian's own Python, which python3-getfem belongs to.

  getfem_ball.py CASE.json RESULT.json

Tetrahedra of second order; augmented Lagrangian (integral contact by ray tracing, large sliding), the multiplier of first
order on the ball, the slave side. The ball's top moves without turning: one unknown for its height, and what slides it;
it is tied to them by multipliers, and the plane of symmetry is held by springs, for multipliers of both would meet in edges.
"""
import json
import sys

import getfem as gf
import numpy as np

TOP, CONTACT, BOTTOM, SYMMETRY = 1, 2, 3, 4
ORDER = [0, 4, 1, 6, 5, 2, 7, 8, 9, 3]    # of a tetrahedron's nodes in GetFEM, from VTK's
STIFF = 1e5                               # springs of the plane of symmetry [E / mm]


def body(nodes, cells, regions):
    """Mesh of one body; regions = {number: node numbers}, a facet belongs where all its nodes do."""
    mesh = gf.Mesh("empty", 3)
    mesh.add_convex(gf.GeoTrans("GT_PK(3,2)"), np.transpose(np.array(nodes)[np.array(cells)[:, ORDER]], (2, 1, 0)))
    points = {tuple(p): k for k, p in enumerate(mesh.pts().T)}
    outer = {tuple(f) for f in mesh.outer_faces().T}
    for number, members in regions.items():
        faces = mesh.faces_from_pid([points[tuple(nodes[n])] for n in members if tuple(nodes[n]) in points])
        mesh.set_region(number, np.array([f for f in faces.T if tuple(f) in outer]).T)
    return mesh


def space_of(mesh, order):
    space = gf.MeshFem(mesh, 3)
    space.set_fem(gf.Fem(f"FEM_PK(3,{order})"))
    return space


def held(model, name, mesh, integration, region, motion="", tested=""):
    """Face `region` moves as the expression `motion` says, by a multiplier; `tested`: its variation."""
    model.add_filtered_fem_variable(f"hold_{name}", space_of(mesh, 2), region)
    model.add_linear_term(integration, f"hold_{name}.(Test_{name}{tested}) + Test_hold_{name}.({name}{motion})", region)


def prepared(case):
    """Model of both bodies, and what it needs to stay alive."""
    nodes = case["nodes"]
    meshes = {"ball": body(nodes, case["ball"], {TOP: case["top"], CONTACT: case["round"], SYMMETRY: case["symmetry"]}),
              "flat": body(nodes, case["flat"], {BOTTOM: case["bottom"], CONTACT: case["face"], SYMMETRY: case["symmetry"]})}
    E, nu = case["E_MPa"], case["nu"]
    model = gf.Model("real")
    model.add_initialized_data("lame", [E * nu / ((1 + nu) * (1 - 2 * nu))])
    model.add_initialized_data("shear_modulus", [E / (2 * (1 + nu))])
    model.add_initialized_data("stiff", [STIFF * E])
    model.add_initialized_data("aside", [0.0])
    made = {}
    for name, mesh in meshes.items():
        space, integration = space_of(mesh, 2), gf.MeshIm(mesh, gf.Integ("IM_TETRAHEDRON(5)"))
        model.add_fem_variable(name, space)
        model.add_isotropic_linearized_elasticity_brick(integration, name, "lame", "shear_modulus")
        model.add_linear_term(integration, f"stiff*{name}(2)*Test_{name}(2)", SYMMETRY)
        made[name] = space, integration
    model.add_variable("height", 1)
    held(model, "ball", meshes["ball"], made["ball"][1], TOP, "-height*[0;0;1]-aside*[1;0;0]",
         "-Test_height*[0;0;1]")
    held(model, "flat", meshes["flat"], made["flat"][1], BOTTOM)
    traction = space_of(meshes["ball"], 1)
    model.add_filtered_fem_variable("traction", traction, CONTACT)
    model.add_initialized_data("augmentation", [case["augmentation_MPa_per_mm"]])
    model.add_initialized_data("mu", [case["friction"]])
    brick = model.add_integral_large_sliding_contact_brick_raytracing("augmentation", case["reach_mm"], "mu")
    for name, (space, _) in made.items():
        model.add_initialized_fem_data(f"{name}_before", space, np.zeros(space.nbdof()))
    model.add_slave_contact_boundary_to_large_sliding_contact_brick(
        brick, made["ball"][1], CONTACT, "ball", "traction", "ball_before")
    model.add_master_contact_boundary_to_large_sliding_contact_brick(
        brick, made["flat"][1], CONTACT, "flat", "flat_before")
    start = np.zeros(made["ball"][0].nbdof())
    start[2::3] = -case["approach_mm"]    # some points touch when Newton begins
    model.set_variable("height", [-case["approach_mm"]])
    model.set_variable("ball", start)
    return model, (meshes, made, traction)


def main(case_file, result_file):
    with open(case_file, encoding="utf-8") as file:
        case = json.load(file)
    model, (_, made, _traction) = prepared(case)
    push = model.add_explicit_rhs("height", [0.0])
    iterations, frictions = 0, []
    for force, aside in case["increments"]:
        model.set_private_rhs(push, [-force])
        model.set_variable("aside", [aside])
        count, converged = model.solve("max_res", 1e-7, "max_iter", 60, "lsolver", "mumps", "noisy")
        if not converged:
            sys.exit(f"no convergence at {force}, {aside} in {count} iterations")
        iterations += count
        for name in ("ball", "flat"):
            model.set_variable(f"{name}_before", model.variable(name))
        frictions.append(abs(float(gf.asm_generic(made["ball"][1], 0, "traction(1)", CONTACT, model))))
    with open(result_file, "w", encoding="utf-8") as file:
        json.dump({"friction_N": frictions, "iterations": int(iterations)}, file)


if __name__ == "__main__":
    main(*sys.argv[1:3])
