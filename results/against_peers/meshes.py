"""The meshes of Reye as values, and as .msh."""
import base64
import struct
import xml.etree.ElementTree as xml
import zlib
from typing import NamedTuple


class Mesh(NamedTuple):
    """Quadrilaterals of both bodies; edges = boundary facets (two nodes, body on the left) by the boundary's name."""
    nodes: list    # [(x, y)] mm
    quads: dict    # body -> [four node numbers, from 0]
    edges: dict    # "body_place" -> [(first, second)]

    def nodes_on(self, name):
        """Nodes of a boundary in the order of x."""
        return sorted({n for edge in self.edges[name] for n in edge}, key=lambda n: self.nodes[n])


def decoded(text):
    """Bytes of an inline VTK array: base64 of (blocks, block size, last size, sizes...), then of the blocks."""
    text = text.strip()
    count = struct.unpack_from("<Q", base64.b64decode(text[:12]))[0]
    head = 4 * ((8 * (3 + count) + 2) // 3)
    sizes = struct.unpack_from(f"<{count}Q", base64.b64decode(text[:head]), 24)
    data, blocks = base64.b64decode(text[head:]), []
    for size in sizes:
        blocks.append(zlib.decompress(data[:size]))
        data = data[size:]
    return b"".join(blocks)


def array(root, name):
    """A named array of a .vtu as a tuple of numbers; points are the array without another name."""
    item = next(a for a in root.iter("DataArray") if a.get("Name") == name)
    kind = {"Float64": "d", "Int64": "q", "Int32": "i", "UInt8": "B"}[item.get("type")]
    data = decoded(item.text)
    return struct.unpack(f"<{len(data) // struct.calcsize(kind)}{kind}", data)


def read_vtu(path):
    """Mesh of cylinder and flat, told apart by the side of y = 0 they lie on; boundaries named by where they lie."""
    root = xml.parse(path).getroot()
    position = array(root, "reference_position")
    nodes = list(zip(position[0::3], position[1::3]))
    flat_list = array(root, "connectivity")
    cells = [flat_list[i:i + 4] for i in range(0, len(flat_list), 4)]
    quads = {"cylinder": [], "flat": []}
    for cell in cells:
        quads["cylinder" if sum(nodes[n][1] for n in cell) > 0.0 else "flat"].append(cell)
    edges = {}
    for body, own in quads.items():
        sides = {(q[k], q[(k + 1) % 4]) for q in own for k in range(4)}
        for a, b in sorted(sides):
            if (b, a) not in sides:
                edges.setdefault(f"{body}_{place(body, nodes[a], nodes[b])}", []).append((a, b))
    return Mesh(nodes, quads, edges)


def place(body, a, b):
    """Where a facet of the half disc (flat side at y = 6) or of the block (top at y = 0) lies."""
    if body == "cylinder":
        return "top" if min(a[1], b[1]) > 5.999 else "round"
    return "side" if a[1] != b[1] else "top" if a[1] > -0.001 else "bottom"


def write_msh(mesh, path):
    """Gmsh's binary format 2.2 with physical names: bodies are surfaces, boundaries curves."""
    names = [(1, name) for name in mesh.edges] + [(2, body) for body in mesh.quads]
    with path.open("wb") as file:
        def say(*lines):
            file.write("".join(f"{line}\n" for line in lines).encode())
        say("$MeshFormat", "2.2 1 8")
        file.write(struct.pack("i", 1))
        say("", "$EndMeshFormat", "$PhysicalNames", len(names))
        say(*(f'{dim} {k} "{name}"' for k, (dim, name) in enumerate(names, 1)))
        say("$EndPhysicalNames", "$Nodes", len(mesh.nodes))
        for k, (x, y) in enumerate(mesh.nodes, 1):
            file.write(struct.pack("=i3d", k, x, y, 0.0))
        cells = [mesh.edges[name] if dim == 1 else mesh.quads[name] for dim, name in names]
        say("", "$EndNodes", "$Elements", sum(map(len, cells)))
        number = 0
        for k, (dim, _) in enumerate(names, 1):
            file.write(struct.pack("3i", 1 if dim == 1 else 3, len(cells[k - 1]), 2))
            for cell in cells[k - 1]:
                number += 1
                file.write(struct.pack(f"{3 + len(cell)}i", number, k, k, *(n + 1 for n in cell)))
        say("", "$EndElements")
