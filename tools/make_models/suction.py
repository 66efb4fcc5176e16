"""A fine suction tube after Yankauer's: a rounded head with a mouth and four side holes, a tube
with one slight bend, a moulded grip with a vent for the thumb and a barb for the hose. Millimetres.

Every ring has SIDES points: 0 towards +x, SIDES / 4 towards +y, where the thumb lies.
"""

import math

from description import description_text, instrument_entries
from inventor import Material, model_text
from shapes.loft import circle, close_end, close_start, loft, through
from shapes.surface import Surface
from shapes.vector import add, scale, subtract, unit

LENGTH = 185.0
SIDES = 16
BEND_DEGREES = 15.0  # between the head's direction and the grip's
BEND_RADIUS = 80.0
STRAIGHT = 30.0  # from the mouth to the bend, along the tube
BEND_STEPS = 5
MOUTH_RADIUS = 1.6
MOUTH_DEPTH = 5.0  # what can be seen of the bore
LEVEL = 6.0  # from the mouth, in the plane z = 0, to the first section square to the tube

# Along the tube from the mouth against the radius: the rounded head, then the tube.
HEAD = (
    (0.15, 2.15),
    (0.6, 2.55),
    (1.4, 2.9),
    (3.0, 3.25),
    (5.5, 3.4),
    (8.0, 3.2),
    (10.5, 2.75),
    (13.0, 2.3),
    (15.5, 2.15),
    (STRAIGHT, 2.15),
)
HEAD_STATIONS = (0.15, 0.6, 1.4, 2.4, 3.6, 4.8, 6.0, 7.2, 8.4, 9.6, 11.0, 12.2, 13.5, 15.5, 23.0)
SIDE_HOLE_ROWS = (4, 6)  # of HEAD_STATIONS: where side holes begin, two bands long
SIDE_HOLE_COLUMNS = ((15, 7), (3, 11))  # in each of these rows, two columns wide
HOLE_DEPTH = 1.2

# z against half height (y) and half width (x) from the tube to the hose
HALF_HEIGHT = (
    (60.0, 2.2),
    (99.0, 2.3),
    (101.0, 4.4),
    (108.0, 5.2),
    (118.0, 5.6),
    (140.0, 5.0),
    (158.0, 5.4),
    (163.0, 4.4),
    (165.0, 3.4),
)
HALF_WIDTH = (
    (60.0, 2.2),
    (99.0, 2.3),
    (101.0, 4.0),
    (108.0, 4.6),
    (118.0, 4.9),
    (140.0, 4.5),
    (158.0, 4.8),
    (163.0, 4.2),
    (165.0, 3.4),
)
TUBE_STATIONS = (76.0, 98.9)
GRIP_STATIONS = (99.0, 99.8, 101.0, 104.5, 108.0, 111.0, 114.0, 118.0)
VENT_STATION = 108.0  # where the thumb's vent begins, two bands long
VENT_DEPTH = 2.5
RIBS = 8
FIRST_RIB = 122.0
RIB_PITCH = 4.0
RIB_DEPTH = 0.6
BACK_STATIONS = (156.0, 160.0, 163.0, 165.0)
# z against the radius of the barb: rings that hold the hose
BARB = ((165.6, 2.9), (170.0, 2.9), (170.4, 3.8), (175.0, 3.0), (175.4, 3.8), (180.0, 3.0))
BARB += ((180.4, 3.8), (LENGTH - 0.4, 3.0), (LENGTH, 2.7))
BARB_BORE = 2.0
BARB_DEPTH = 4.0

STEEL = Material((0.62, 0.63, 0.65), (0.65, 0.65, 0.67), 0.4)
MATT = Material((0.27, 0.32, 0.37), (0.12, 0.12, 0.13), 0.1)
DARK = Material((0.02, 0.02, 0.022), (0.02, 0.02, 0.02), 0.05)

BEND = math.radians(BEND_DEGREES)
OFFSET = STRAIGHT * math.sin(BEND) + BEND_RADIUS * (1.0 - math.cos(BEND))  # y of the grip


def centre_line(s):
    """Point at the distance s along the straight head, and the direction from the mouth."""
    along = (0.0, math.sin(BEND), math.cos(BEND))
    return scale(along, s), along


def bend_point(share):
    """The same on the bend, which `share` passes from 0 to 1."""
    angle = BEND * (1.0 - share)
    y = OFFSET - BEND_RADIUS * (1.0 - math.cos(angle))
    z = STRAIGHT * math.cos(BEND) + BEND_RADIUS * (math.sin(BEND) - math.sin(angle))
    return (0.0, y, z), (0.0, math.sin(angle), math.cos(angle))


def section(centre, along, half_width, half_height):
    """Ring across the direction `along` in the Y-Z plane."""
    up = (0.0, along[2], -along[1])
    return [
        add(centre, (x, y * up[1], y * up[2])) for x, y in circle(SIDES, half_width, half_height)
    ]


def head_ring(s, radius):
    """Section of the head. The mouth lies in the plane z = 0, so that it meets tissue squarely when
    the grip is upright; from there to LEVEL the sections turn until they are square to the tube."""
    centre, along = centre_line(s)
    upright = 1.0 - min(max(s / LEVEL, 0.0), 1.0)
    return section(centre, unit(add(along, (0.0, -upright * along[1], 0.0))), radius, radius)


def grip_ring(z, pressed=0.0):
    return section(
        (0.0, OFFSET, z),
        (0.0, 0.0, 1.0),
        through(HALF_WIDTH, z) - pressed,
        through(HALF_HEIGHT, z) - pressed,
    )


def head_and_tube():
    rings = [head_ring(s, through(HEAD, s)) for s in HEAD_STATIONS]
    radius = HEAD[-1][1]
    for k in range(BEND_STEPS + 1):
        rings.append(section(*bend_point(k / BEND_STEPS), radius, radius))
    return rings + [grip_ring(z) for z in TUBE_STATIONS]


def grip():
    rings = [grip_ring(z) for z in GRIP_STATIONS]
    for k in range(RIBS):
        z = FIRST_RIB + k * RIB_PITCH
        rings += [grip_ring(z), grip_ring(z + 0.5 * RIB_PITCH, RIB_DEPTH)]
    return rings + [grip_ring(z) for z in BACK_STATIONS]


def hole(surface, rings, row, column, depth, part):
    """A hole where four quads are left out, from ring `row` to row + 2 and from point `column` to
    column + 2: an oval rim, a wall and a dark floor."""
    here, between, there = (
        [rings[row + r][(column + c) % SIDES] for c in range(3)] for r in range(3)
    )
    border = here + [between[2]] + there[::-1] + [between[0]]
    centre = between[1]
    inward = scale(unit(subtract(rings[row + 1][(column + 1 + SIDES // 2) % SIDES], centre)), depth)
    # The corners of the border go farther in than the middles of its sides: the rim is oval.
    shares = [0.5 if k % 2 == 0 else 0.28 for k in range(8)]
    rim = [add(p, scale(subtract(centre, p), share)) for p, share in zip(border, shares)]
    floor = [add(p, inward) for p in rim]
    outer, inner, deep = ([surface.point(p) for p in ring] for ring in (border, rim, floor))
    bottom = surface.point(add(centre, inward))
    for k in range(8):
        j = (k + 1) % 8
        surface.quad(outer[k], outer[j], inner[j], inner[k], part, "body")
        surface.quad(inner[k], inner[j], deep[j], deep[k], "Bore", "wall")
        surface.triangle(deep[k], deep[j], bottom, "Bore", "floor")


def build():
    """The tube as one closed surface with the parts Tube, Grip and Bore (what looks dark)."""
    surface = Surface(unit=0.001)
    # From the bottom of the mouth forwards to its rim, and from there back over the outside.
    mouth = [head_ring(MOUTH_DEPTH, MOUTH_RADIUS), head_ring(0.25, MOUTH_RADIUS)]
    lip = [head_ring(0.05, MOUTH_RADIUS + 0.15), head_ring(0.0, MOUTH_RADIUS + 0.35)]
    front, back = head_and_tube(), grip()
    barb = [
        section((0.0, OFFSET, z), (0.0, 0.0, 1.0), radius, radius)
        for z, radius in BARB + ((LENGTH, BARB_BORE), (LENGTH - BARB_DEPTH, BARB_BORE))
    ]
    rings = mouth + lip + front + back + barb
    first = len(mouth + lip)
    start_of_grip, start_of_barb = first + len(front), first + len(front) + len(back)
    vent = start_of_grip + GRIP_STATIONS.index(VENT_STATION)
    holes = [
        (first + row, column, HOLE_DEPTH, "Tube")
        for row, columns in zip(SIDE_HOLE_ROWS, SIDE_HOLE_COLUMNS)
        for column in columns
    ] + [(vent, SIDES // 4 - 1, VENT_DEPTH, "Grip")]
    left_out = {
        (row + r, (column + c) % SIDES)
        for row, column, *_ in holes
        for r in range(2)
        for c in range(2)
    }

    def label(row, column):
        if (row, column) in left_out:
            return None
        if row in (-1, -2) or row == 0 or row == len(rings) - 2:
            return ("Bore", "floor" if row < 0 else "wall")
        if row < start_of_grip - 1:
            return ("Tube", "body")
        if row < start_of_barb - 1:
            return ("Grip", "body")
        return ("Grip", ("barb", row))

    close_start(surface, rings[0], centre_line(MOUTH_DEPTH)[0], label)
    loft(surface, rings, label)
    close_end(surface, rings[-1], (0.0, OFFSET, LENGTH - BARB_DEPTH), label)
    for row, column, depth, part in holes:
        hole(surface, rings, row, column, depth, part)
    return surface


def files():
    """{file name: text} of this instrument."""
    offset = 0.001 * round(OFFSET, 1)
    description = f"""
Suction tube with a rounded head, {LENGTH:.0f} mm long, in metres. The middle of its mouth is at the
origin, the handle towards +Z. From the mouth the tube leans {BEND_DEGREES:.0f} degrees towards +Y;
behind the bend it runs along +Z, at y = {offset:.4f}. One closed surface in three strip sets.
"""
    opening = f"""
Suction tube. Lengths in metres, in the frame of suction.iv: the middle of the mouth at the origin,
the handle towards +Z. The mouth lies in the plane z = 0; behind the bend the tube and the grip are
at y = {offset:.4f}.
"""
    entries = [
        *instrument_entries(
            "Suction tube",
            "suction",
            "Tube with a rounded head and side holes; draws off the blood at its mouth",
            "Middle of the mouth (m).",
        ),
        (
            "contact_radius",
            0.001 * max(radius for _, radius in HEAD),
            "Radius of the rounded head: what touches lies this close to the mouth (m).",
        ),
    ]
    materials = {"Tube": STEEL, "Grip": MATT, "Bore": DARK}
    return {
        "suction.iv": model_text(description, build(), materials),
        "suction.toml": description_text(opening, entries),
    }
