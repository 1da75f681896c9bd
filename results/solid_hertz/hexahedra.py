"""Quarter models of a ball on a flat as graded hexahedra in a .msh file (format 2.2)."""


def places(size, fine, length, growth=1.35):
    """Even to `fine`, then growing to `length`."""
    at, step = [0.0], size
    while at[-1] < length:
        if at[-1] >= fine - 1e-9 * size:
            step *= growth
        at.append(at[-1] + step)
    scale = (length - fine) / (at[-1] - fine)
    return [x if x <= fine else fine + scale * (x - fine) for x in at]


def write_hertz_blocks(file, size, fine, radius, length):
    """Bodies "ball" (its face a paraboloid of this radius) and "flat", each length^3, with the faces of geo/ball_on_flat."""
    at, deep = places(size, fine, length), places(size, 0.5 * fine, length)
    n, m = len(at), len(deep)
    nodes, quads, hexes = [], [], []
    names = []

    def tag(dim, name):
        names.append((dim, len(names) + 1, name))
        return len(names)
    for body, sign in (("ball", 1.0), ("flat", -1.0)):
        first = len(nodes)
        layers = deep if sign > 0 else [-d for d in reversed(deep)]
        for d in layers:
            for y in at:
                for x in at:
                    lift = (x * x + y * y) / (2.0 * radius) * (1.0 - d / length) if sign > 0 else 0.0
                    nodes.append((x, y, d + lift))

        def node(i, j, k):
            return first + i + n * (j + n * k) + 1
        volume = tag(3, body)
        faces = {key: tag(2, f"{body}_{key}") for key in ("contact", "top" if sign > 0 else "bottom", "sx", "sy", "x1", "y1")}
        far = "top" if sign > 0 else "bottom"
        for k in range(m - 1):
            for j in range(n - 1):
                for i in range(n - 1):
                    corner = [node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k)]
                    up = [node(i, j, k + 1), node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1), node(i, j + 1, k + 1)]
                    hexes.append((volume, corner + up))
                    if k == 0:
                        quads.append((faces["contact" if sign > 0 else far], corner[::-1]))
                    if k == m - 2:
                        quads.append((faces[far if sign > 0 else "contact"], up))
                    if i == 0:
                        quads.append((faces["sx"], [corner[0], up[0], up[3], corner[3]]))
                    if i == n - 2:
                        quads.append((faces["x1"], [corner[1], corner[2], up[2], up[1]]))
                    if j == 0:
                        quads.append((faces["sy"], [corner[0], corner[1], up[1], up[0]]))
                    if j == n - 2:
                        quads.append((faces["y1"], [corner[3], up[3], up[2], corner[2]]))
    with open(file, "w", encoding="utf-8") as out:
        out.write("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n%d\n" % len(names))
        out.writelines(f'{dim} {number} "{name}"\n' for dim, number, name in names)
        out.write("$EndPhysicalNames\n$Nodes\n%d\n" % len(nodes))
        out.writelines(f"{i + 1} {x:.17g} {y:.17g} {z:.17g}\n" for i, (x, y, z) in enumerate(nodes))
        out.write("$EndNodes\n$Elements\n%d\n" % (len(quads) + len(hexes)))
        number = 0
        for kind, cells in ((3, quads), (5, hexes)):
            for physical, corners in cells:
                number += 1
                out.write(f"{number} {kind} 2 {physical} {physical} {' '.join(map(str, corners))}\n")
        out.write("$EndElements\n")
