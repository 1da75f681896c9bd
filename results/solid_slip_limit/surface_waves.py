"""How much softer in shear than in pressure a half-space of bilinear elements is where tractions change from node to node.

Plane strain, nu = 0, where both compliances of a half-space under tractions exp(i k x) are 1 / (G k). Elements as wide as the
distance of the nodes, in layers that grow downwards; nodal tractions on the free side, as dual multipliers make them.
"""
import numpy as np

GAUSS = (-1.0 / np.sqrt(3.0), 1.0 / np.sqrt(3.0))
ELASTICITY = np.diag([1.0, 1.0, 0.5])  # E = 1, nu = 0; strains xx, zz, 2 xz


def element(height):
    """Stiffness of a bilinear rectangle 1 x height, (u_x, u_z) of the nodes (0, 0), (1, 0), (1, height), (0, height)."""
    stiffness = np.zeros((8, 8))
    for a in GAUSS:
        for b in GAUSS:
            slopes = 0.25 * np.array([[b - 1, a - 1], [1 - b, -1 - a], [1 + b, 1 + a], [-1 - b, 1 - a]])
            slopes *= np.array([2.0, 2.0 / height])
            strain = np.zeros((3, 8))
            strain[0, 0::2] = slopes[:, 0]
            strain[1, 1::2] = slopes[:, 1]
            strain[2, 0::2], strain[2, 1::2] = slopes[:, 1], slopes[:, 0]
            stiffness += strain.T @ ELASTICITY @ strain * (0.25 * height)
    return stiffness


def layers(first, growth=1.25, depth=60.0, most=5.0):
    heights = [first] * 8
    while sum(heights) < depth:
        heights.append(min(growth * heights[-1], most))
    return heights


def compliances(wave, heights):
    """(tangential, normal) at the free side under tractions exp(i wave x), held at the bottom."""
    count = len(heights) + 1
    stiffness = np.zeros((2 * count, 2 * count), complex)
    turn = np.exp(1j * wave)
    for level, height in enumerate(heights):
        nodes = ((level, 1.0), (level, turn), (level + 1, turn), (level + 1, 1.0))
        of_element = element(height)
        for i, (row, phase) in enumerate(nodes):
            for j, (column, other) in enumerate(nodes):
                block = of_element[2 * i:2 * i + 2, 2 * j:2 * j + 2] * np.conj(phase) * other
                stiffness[2 * row:2 * row + 2, 2 * column:2 * column + 2] += block
    compliance = np.linalg.inv(stiffness[:-2, :-2])
    return compliance[0, 0].real, compliance[1, 1].real


def table(thicknesses=(1.0, 0.5, 0.25), lengths=(12, 6, 4, 3, 2)):
    """Rows: nodes per wave; per thickness of the first layer the tangential over the normal compliance."""
    rows = []
    for length in lengths:
        ratios = []
        for first in thicknesses:
            tangential, normal = compliances(2.0 * np.pi / length, layers(first))
            ratios.append(tangential / normal)
        rows.append([length] + ratios)
    return rows
