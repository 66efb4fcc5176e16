"""The files of the hands."""

from hands.glove import glove
from hands.grips import PEN, RINGS, ROD
from hands.nets import polygonise
from hands.sleeve import rolled_edge, sleeve
from inventor import HEADER, Material, comment, number, numbers
from shapes.strips import make_strips
from shapes.vector import add, length, scale

CELL = 4.6  # of the grid on which the glove is found, mm
LONG_CELL = 7.0  # the same along the forearm
HAND_BEGINS = -14.0  # Y of the hand's frame: behind it lies the forearm

LATEX = Material((0.80, 0.72, 0.58), (0.12, 0.12, 0.12), 0.25)
CLOTH = Material((0.10, 0.26, 0.22), (0.02, 0.03, 0.03), 0.04)

DESCRIPTION = """
{grip}, with the cuff of the glove over the sleeve of the gown; in metres. A right hand of glove
size 7.5. {frame}
"""
HANDLE = """The handle's axis is Z, away from the instrument's tip; the fingers hold it at the
origin; the forearm leaves to +X and +Z."""
GRIPS = {
    "hand_pen": (PEN, "Gloved hand that holds a thin handle like a pen", HANDLE),
    "hand_rod": (ROD, "Gloved hand that grips a rod of 12 mm", HANDLE),
    "hand_rings": (
        RINGS,
        "Gloved hand in the finger rings of scissors",
        """The instrument's axis is Z, away from its tip. The rings lie in the Y-Z plane, their
middles at y = 20 mm for the thumb and y = -20 mm for the ring finger, z = 0;
the forearm leaves to +Z.""",
    ),
}


def places(low, high):
    """Of the grid along a coordinate."""
    result = [low]
    while result[-1] < high:
        result.append(result[-1] + CELL)
    return result


def places_along(low, high):
    """The same along Y, with long cells on the forearm."""
    result = [HAND_BEGINS]
    while result[0] > low:
        result.insert(0, result[0] - LONG_CELL)
    return result[:-1] + places(HAND_BEGINS, high)


def surface_mesh(surface):
    """Points, normals and triangles of a surface that is smooth everywhere."""
    sums = [(0.0, 0.0, 0.0)] * len(surface.points)
    for triangle in surface.triangles:
        across = surface.area_vector(triangle)
        for point in triangle:
            sums[point] = add(sums[point], across)
    normals = [scale(n, 1.0 / max(length(n), 1e-12)) for n in sums]
    return surface.points, normals, surface.triangles


def shape_text(mesh, grip, indent):
    """Coordinate3, Normal and IndexedTriangleStripSet of a mesh of the hand's frame."""
    points, normals, triangles = mesh
    at, corner, index = [], {}, []
    for point in points:
        text = numbers(grip.placed(point), 5)
        index.append(corner.setdefault(text, len(at)))
        if index[-1] == len(at):
            at.append(text)
    directions = [""] * len(at)
    for k, normal in zip(index, normals):
        directions[k] = numbers(grip.turned(normal), 3)
    kept = [tuple(index[p] for p in t) for t in triangles]
    strips = make_strips([t for t in kept if len(set(t)) == 3])
    words = [number(p, 0) for strip in strips for p in strip + [-1]]
    inner = indent + "  "
    text = f"{indent}Coordinate3 {{\n{inner}point [\n" + rows(at, inner, 5)
    text += f"{inner}]\n{indent}}}\n"
    text += f"{indent}Normal {{\n{inner}vector [\n" + rows(directions, inner, 5) + f"{inner}]\n"
    text += f"{indent}}}\n{indent}NormalBinding {{\n{inner}value PER_VERTEX_INDEXED\n{indent}}}\n"
    text += f"{indent}IndexedTriangleStripSet {{\n{inner}coordIndex [\n" + rows(words, inner, 20)
    return text + f"{inner}]\n{indent}}}\n"


def rows(words, indent, per_line):
    lines = [words[k : k + per_line] for k in range(0, len(words), per_line)]
    return "".join(f"{indent}{', '.join(line)},\n" for line in lines)


def meshes(grip):
    """{part: its meshes}."""
    body = glove(grip)
    x, y, z = (body.extent(axis) for axis in range(3))
    skin = polygonise(body, [places(*x), places_along(*y), places(*z)])
    edge, cloth = rolled_edge(body, grip), sleeve(body, grip)
    return {"glove": [skin, surface_mesh(edge)], "sleeve": [surface_mesh(cloth)]}


def hand_text(grip, description):
    text = HEADER + "\n" + comment(description) + "\nSeparator {\n"
    text += "  ShapeHints {\n    vertexOrdering COUNTERCLOCKWISE\n    shapeType SOLID\n  }\n"
    for part, found in meshes(grip).items():
        text += f"  DEF {part} Separator {{\n"
        text += {"glove": LATEX, "sleeve": CLOTH}[part].text("    ")
        for mesh in found:
            text += "    Separator {\n" + shape_text(mesh, grip, "      ") + "    }\n"
        text += "  }\n"
    return text + "}\n"


def files():
    """{file name: text} of the hands."""
    return {
        f"{name}.iv": hand_text(grip, DESCRIPTION.format(grip=title, frame=frame))
        for name, (grip, title, frame) in GRIPS.items()
    }
