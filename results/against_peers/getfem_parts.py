"""What the cases in GetFEM have in common, in the plane and in space: bodies, faces that move as one, contact."""
import getfem as gf
import numpy as np


def body(nodes, cells, geometry, regions):
    """Mesh of one body of cells whose nodes stand in GetFEM's order; regions = {number: node numbers, of any body}, a
    facet belongs where all its nodes do."""
    mesh = gf.Mesh("empty", len(nodes[0]))
    mesh.add_convex(gf.GeoTrans(geometry), np.transpose(np.array(nodes)[np.array(cells)], (2, 1, 0)))
    points = {tuple(p): k for k, p in enumerate(mesh.pts().T)}
    outer = {tuple(f) for f in mesh.outer_faces().T}
    for number, members in regions.items():
        faces = mesh.faces_from_pid([points[tuple(nodes[n])] for n in members if tuple(nodes[n]) in points])
        mesh.set_region(number, np.array([f for f in faces.T if tuple(f) in outer]).T)
    return mesh


def space_of(mesh, element):
    """Vectors of a finite element."""
    space = gf.MeshFem(mesh, mesh.dim())
    space.set_fem(gf.Fem(element))
    return space


def model_of(case):
    """Without unknowns, with the elasticity of the case."""
    E, nu = case["E_MPa"], case["nu"]
    model = gf.Model("real")
    model.add_initialized_data("lame", [E * nu / ((1 + nu) * (1 - 2 * nu))])
    model.add_initialized_data("shear_modulus", [E / (2 * (1 + nu))])
    return model


def elastic(model, name, mesh, element, integral):
    """Displacement `name` of linear elasticity on `mesh`: (finite element space, integration)."""
    space, integration = space_of(mesh, element), gf.MeshIm(mesh, gf.Integ(integral))
    model.add_fem_variable(name, space)
    model.add_isotropic_linearized_elasticity_brick(integration, name, "lame", "shear_modulus")
    return space, integration


def held(model, name, mesh, integration, region, element, motion="", tested=""):
    """Face `region` moves as the expression `motion` says, by a multiplier; without one it stays. `tested`: its variation."""
    model.add_filtered_fem_variable(f"hold_{name}", space_of(mesh, element), region)
    model.add_linear_term(integration, f"hold_{name}.(Test_{name}{tested}) + Test_hold_{name}.({name}{motion})", region)


def contact(model, case, made, slave, master, multiplier, region):
    """Augmented Lagrangian, integrals by ray tracing, large sliding: the traction on the slave is of the space given."""
    model.add_filtered_fem_variable("traction", multiplier, region)
    model.add_initialized_data("augmentation", [case["augmentation_MPa_per_mm"]])
    model.add_initialized_data("mu", [case["friction"]])
    brick = model.add_integral_large_sliding_contact_brick_raytracing("augmentation", case["reach_mm"], "mu")
    for name, (space, _) in made.items():
        model.add_initialized_fem_data(f"{name}_before", space, np.zeros(space.nbdof()))
    model.add_slave_contact_boundary_to_large_sliding_contact_brick(
        brick, made[slave][1], region, slave, "traction", f"{slave}_before")
    model.add_master_contact_boundary_to_large_sliding_contact_brick(
        brick, made[master][1], region, master, f"{master}_before")


def approach(model, name, space, depth):
    """A body starts `depth` deep in the other, along its last axis, so that some points touch when Newton begins."""
    axes = space.qdim()
    start = np.zeros(space.nbdof())
    start[axes - 1::axes] = -depth
    model.set_variable("height", [-depth])
    model.set_variable(name, start)


def solve(model, names):
    """One increment: its iterations, or none where they do not converge. Slip is counted from here on."""
    count, converged = model.solve("max_res", 1e-7, "max_iter", 60, "lsolver", "mumps", "noisy")
    if not converged:
        return None
    for name in names:
        model.set_variable(f"{name}_before", model.variable(name))
    return int(count)
