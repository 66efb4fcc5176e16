"""The baton of the thesis that Resect follows (ETH diploma thesis, about 2004, section 4.1.1): six
strips of four points.

The coordinates are the thesis's. Two of its six strips, the far end and the top, are listed so that
their normals point inwards; here the two middle points of these strips are exchanged, which turns
them outwards and moves nothing.
"""

from description import description_text, instrument_entries
from inventor import HEADER, Material, comment, number, numbers
from shapes.vector import cross, subtract, unit

SCALE = 0.012  # metres per thesis unit: 0.18 m
TIP_MIDDLE = (0.25, 0.25, 0.0)

STRIPS = {
    "tip": [(0, 0, 0), (0, 0.5, 0), (0.5, 0, 0), (0.5, 0.5, 0)],
    "end (re-ordered)": [(-0.3, -0.3, 15), (0.8, -0.3, 15), (-0.3, 0.8, 15), (0.8, 0.8, 15)],
    "right": [(0.5, 0, 0), (0.5, 0.5, 0), (0.8, -0.3, 15), (0.8, 0.8, 15)],
    "bottom": [(0, 0, 0), (0.5, 0, 0), (-0.3, -0.3, 15), (0.8, -0.3, 15)],
    "left": [(0, 0.5, 0), (0, 0, 0), (-0.3, 0.8, 15), (-0.3, -0.3, 15)],
    "top (re-ordered)": [(0, 0.5, 0), (-0.3, 0.8, 15), (0.5, 0.5, 0), (0.8, 0.8, 15)],
}

DESCRIPTION = """
Baton: the coordinates of the thesis (section 4.1.1), in its units; the Scale makes it 0.18 m long
and the Translation puts the middle of its tip at the origin, with the handle towards +Z. The thesis
lists the end and the top so that their normals point inwards. Here their two middle points are
exchanged: the six faces then form one closed surface seen counterclockwise from outside. All
positions are unchanged. Normals, which the thesis leaves to the viewer, are given: one direction
for each flat side.
"""

GREY = Material((0.4, 0.4, 0.4), (0.4, 0.4, 0.4), 0.9)


def strip_normal(strip):
    return unit(cross(subtract(strip[1], strip[0]), subtract(strip[2], strip[0])))


def model():
    text = HEADER + "\n" + comment(DESCRIPTION) + "\nSeparator {\n"
    text += "  ShapeHints {\n    vertexOrdering COUNTERCLOCKWISE\n    shapeType SOLID\n  }\n"
    text += GREY.text("  ")
    scale = number(SCALE, 3)
    text += f"  Scale {{\n    scaleFactor {scale} {scale} {scale}\n  }}\n"
    text += f"  Translation {{\n    translation {numbers([-x for x in TIP_MIDDLE], 2)}\n  }}\n"
    text += "  Coordinate3 {\n    point [\n"
    for side, strip in STRIPS.items():
        text += f"      {', '.join(numbers(p, 1) for p in strip)},  # {side}\n"
    text += "    ]\n  }\n  Normal {\n    vector [\n"
    for strip in STRIPS.values():
        text += f"      {', '.join([numbers(strip_normal(strip), 4)] * 4)},\n"
    text += "    ]\n  }\n  NormalBinding {\n    value PER_VERTEX\n  }\n"
    return text + "  TriangleStripSet {\n    numVertices [ 4, 4, 4, 4, 4, 4 ]\n  }\n}\n"


def files():
    """{file name: text} of this instrument."""
    opening = """
Baton. Lengths in metres, in the frame of baton.iv after its Scale and Translation: the middle of
the square tip at the origin, the handle towards +Z.
"""
    entries = [
        *instrument_entries(
            "Baton",
            "baton",
            "Tapered square bar of the original simulator; pushes tissue with its tip",
            "Middle of the square tip (m).",
        ),
        (
            "contact_radius",
            TIP_MIDDLE[0] * SCALE,
            "Half the side of the tip: what touches lies this close to the tip (m).",
        ),
    ]
    return {"baton.iv": model(), "baton.toml": description_text(opening, entries)}
