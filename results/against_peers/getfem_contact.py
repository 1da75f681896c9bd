#!/usr/bin/python3
"""One contact case in GetFEM on a ready mesh; run by Debian's own Python, which python3-getfem belongs to.

  getfem_contact.py CASE.json RESULT.json

Quadrilaterals of first order, plane strain; augmented Lagrangian (integral contact by ray tracing, large sliding), the
multiplier of first order on the flat's top. The half disc's flat side moves as a rigid line without turning: one
unknown for its height, one for its sideways motion where a force drives it, tied to the side by multipliers.
"""
import json
import sys

import getfem as gf
import numpy as np

TOP, CONTACT, BOTTOM = 1, 2, 3


def body(nodes, quads, regions):
    """Mesh of one body; regions = {number: node numbers}, a facet belongs where all its nodes do."""
    mesh = gf.Mesh("empty", 2)
    order = np.array(quads)[:, [0, 1, 3, 2]]
    mesh.add_convex(gf.GeoTrans("GT_QK(2,1)"), np.transpose(np.array(nodes)[order], (2, 1, 0)))
    points = {tuple(p): k for k, p in enumerate(mesh.pts().T)}
    outer = {tuple(f) for f in mesh.outer_faces().T}
    for number, members in regions.items():
        faces = mesh.faces_from_pid([points[tuple(nodes[n])] for n in members])
        mesh.set_region(number, np.array([f for f in faces.T if tuple(f) in outer]).T)
    return mesh


def elastic(model, name, mesh):
    """Displacement `name` of linear elasticity on `mesh`: (finite element space, integration)."""
    space = gf.MeshFem(mesh, 2)
    space.set_fem(gf.Fem("FEM_QK(2,1)"))
    integration = gf.MeshIm(mesh, gf.Integ("IM_GAUSS_PARALLELEPIPED(2,3)"))
    model.add_fem_variable(name, space)
    model.add_isotropic_linearized_elasticity_brick(integration, name, "lame", "shear_modulus")
    return space, integration


def held(model, name, mesh, integration, region, motion):
    """Edge `region` moves as the expression `motion` says, by a multiplier; without one it stays."""
    space = gf.MeshFem(mesh, 2)
    space.set_fem(gf.Fem("FEM_QK(2,1)"))
    model.add_filtered_fem_variable(f"hold_{name}", space, region)
    tested = motion.replace("height", "Test_height").replace("aside", "Test_aside")
    model.add_linear_term(integration, f"hold_{name}.(Test_{name}{tested}) + Test_hold_{name}.({name}{motion})", region)


def contact(model, case, made, meshes):
    """A vector multiplier on the flat's top, the slave side; returns its space."""
    multiplier = gf.MeshFem(meshes["flat"], 2)
    multiplier.set_fem(gf.Fem("FEM_QK(2,1)"))
    model.add_filtered_fem_variable("traction", multiplier, CONTACT)
    model.add_initialized_data("augmentation", [case["augmentation_MPa_per_mm"]])
    model.add_initialized_data("mu", [case["friction"]])
    brick = model.add_integral_large_sliding_contact_brick_raytracing("augmentation", case["reach_mm"], "mu")
    for name, (space, _) in made.items():
        model.add_initialized_fem_data(f"{name}_before", space, np.zeros(space.nbdof()))
    model.add_slave_contact_boundary_to_large_sliding_contact_brick(
        brick, made["flat"][1], CONTACT, "flat", "traction", "flat_before")
    model.add_master_contact_boundary_to_large_sliding_contact_brick(
        brick, made["cylinder"][1], CONTACT, "cylinder", "cylinder_before")
    return multiplier


def approach(model, space, depth):
    """The half disc starts `depth` deep in the flat, so that some points touch when Newton begins."""
    start = np.zeros(space.nbdof())
    start[1::2] = -depth
    model.set_variable("height", [-depth])
    model.set_variable("cylinder", start)


def prepared(case):
    """Model with both bodies, supports and contact, the multiplier's space, and what both need to stay alive."""
    nodes, quads = case["nodes"], case["quads"]
    meshes = {"cylinder": body(nodes, quads["cylinder"], {TOP: case["cylinder_top"], CONTACT: case["cylinder_round"]}),
              "flat": body(nodes, quads["flat"], {BOTTOM: case["flat_bottom"], CONTACT: case["flat_top"]})}
    E, nu = case["E_MPa"], case["nu"]
    model = gf.Model("real")
    model.add_initialized_data("lame", [E * nu / ((1 + nu) * (1 - 2 * nu))])
    model.add_initialized_data("shear_modulus", [E / (2 * (1 + nu))])
    made = {name: elastic(model, name, mesh) for name, mesh in meshes.items()}
    model.add_variable("height", 1)
    if case["driven"]:
        model.add_variable("aside", 1)
    held(model, "cylinder", meshes["cylinder"], made["cylinder"][1], TOP,
         "-height*[0;1]" + ("-aside*[1;0]" if case["driven"] else ""))
    held(model, "flat", meshes["flat"], made["flat"][1], BOTTOM, "")
    space = contact(model, case, made, meshes)
    approach(model, made["cylinder"][0], case["approach_mm"])
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
        count, converged = model.solve("max_res", 1e-7, "max_iter", 60, "lsolver", "mumps", "noisy")
        if not converged:
            sys.exit(f"no convergence at {force}, {sideways} in {count} iterations")
        iterations += count
        for name in ("cylinder", "flat"):
            model.set_variable(f"{name}_before", model.variable(name))
    kept = space.basic_dof_on_region(CONTACT)
    with open(result_file, "w", encoding="utf-8") as file:
        json.dump({"x_mm": list(space.basic_dof_nodes()[0, kept]), "traction": list(model.variable("traction")),
                   "iterations": int(iterations)}, file)


if __name__ == "__main__":
    main(*sys.argv[1:3])
