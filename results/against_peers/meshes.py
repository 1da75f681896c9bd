"""The meshes that `reye mesh` writes, as values."""
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
    """Mesh of cylinder and flat, distinguished by the side of y = 0 they lie on; boundaries named by where they lie."""
    root = xml.parse(path).getroot()
    position = array(root, "Points")
    nodes = list(zip(position[0::3], position[1::3]))
    flat_list, ends = array(root, "connectivity"), array(root, "offsets")
    cells = [flat_list[end - 4:end] for begin, end in zip((0,) + ends, ends) if end - begin == 4]
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
