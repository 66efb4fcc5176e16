"""A monopolar electrosurgical pencil: a blade electrode in an insulating collar, a plastic grip
with a yellow button to cut and a blue one to coagulate, and the beginning of its cable.
Millimetres."""

import math

from description import description_text, instrument_entries
from inventor import Material, model_text
from shapes.jaws import middle
from shapes.loft import close_end, close_start, loft, through
from shapes.outline import arcs
from shapes.surface import Surface
from shapes.tubing import tube

BLADE_LENGTH = 18.0
BLADE_HALF_WIDTH = 1.25  # y; the end is round, with this radius
BLADE_HALF_THICKNESS = 0.25
BEVEL = 0.15  # of the blade's borders, in y
BLADE_STATIONS = (0.04, 0.13, 0.28, 0.5, 0.8, BLADE_HALF_WIDTH, 4.0, 8.0, 13.0, BLADE_LENGTH, 20.0)

# z against half width (x) and half height (y)
COLLAR = (
    (17.6, 1.5, 1.7),
    (18.0, 1.8, 2.0),
    (19.0, 1.95, 2.1),
    (26.0, 2.1, 2.2),
    (26.3, 2.7, 2.8),
    (28.6, 2.7, 2.8),
)
GRIP = (28.0, 168.0)  # z: 140 mm
HALF_WIDTH = (
    (28.0, 2.9),
    (28.6, 3.3),
    (40.0, 4.5),
    (47.0, 5.5),
    (51.0, 5.8),
    (86.0, 5.9),
    (100.0, 5.3),
    (135.0, 4.9),
    (158.0, 4.7),
    (165.0, 4.2),
    (167.4, 3.5),
    (GRIP[1], 2.9),
)
HALF_HEIGHT = (
    (28.0, 2.9),
    (28.6, 3.3),
    (40.0, 4.4),
    (47.0, 5.2),
    (51.0, 5.3),
    (86.0, 5.6),
    (100.0, 5.5),
    (135.0, 5.1),
    (158.0, 4.8),
    (165.0, 4.3),
    (167.4, 3.5),
    (GRIP[1], 2.9),
)
RIBS = 6
FIRST_RIB = 34.0
RIB_PITCH = 2.2
RIB_DEPTH = 0.35
BACK_STATIONS = (48.0, 51.0, 56.0, 70.0, 86.0, 90.0, 95.0, 100.0, 117.0, 135.0, 147.0, 158.0)
BACK_STATIONS += (162.0, 165.0, 166.5, 167.4, GRIP[1])

# On the grip's upper side, +y: the plate around the buttons, and the buttons: z, half length (z)
# and half width (x); y against how far the border is drawn in there.
PLATE = ((68.0, 16.5, 3.9), ((3.5, 0.0), (5.75, 0.0), (5.95, 0.2)))
BUTTON_SHAPE = ((5.7, 0.0), (6.6, 0.0), (7.0, 0.2), (7.25, 0.7))
BUTTONS = {"ButtonCut": (60.0, 6.3, 2.9), "ButtonCoagulate": (76.0, 6.3, 2.9)}
DISH = 0.3  # depth of the hollow for the finger

CABLE_RADIUS = 1.9
CABLE_END = (0.0, -2.2, 186.5)  # of its middle line

STEEL = Material((0.62, 0.63, 0.65), (0.65, 0.65, 0.67), 0.4)
WHITE = Material((0.82, 0.84, 0.86), (0.11, 0.11, 0.11), 0.2)
GREY = Material((0.36, 0.40, 0.45), (0.10, 0.10, 0.10), 0.15)
YELLOW = Material((1.0, 0.86, 0.0), (0.10, 0.10, 0.08), 0.2)
BLUE = Material((0.06, 0.34, 0.95), (0.10, 0.10, 0.12), 0.2)
BLACK = Material((0.10, 0.10, 0.11), (0.10, 0.10, 0.10), 0.15)


def blade_ring(z):
    """Section of the blade: eight points from its lower border (the cutting edge) over +x; the end
    is round and bevelled too."""
    ahead = max(BLADE_HALF_WIDTH - z, 0.0)
    wide = math.sqrt(BLADE_HALF_WIDTH**2 - ahead**2)
    bevel = min(BEVEL, 0.3 * wide)
    thick = BLADE_HALF_THICKNESS * min(0.4 + 2.5 * z, 1.0)
    right = [(0.0, -wide), (thick, bevel - wide), (thick, 0.0), (thick, wide - bevel)]
    return [(x, y, z) for x, y in right + [(-x, -y) for x, y in right]]


def oval(half_width, half_height, z):
    """Ring of the collar or of the grip across Z."""
    radius = 0.85 * min(half_width, half_height)
    return [(x, y, z) for x, y in arcs(half_width, half_height, radius, (1, 1), 4)]


def grip_ring(z, pressed=0.0):
    return oval(through(HALF_WIDTH, z) - pressed, through(HALF_HEIGHT, z) - pressed, z)


def skin(surface, part, rings):
    """A closed skin, flat at both ends."""
    close_start(surface, rings[0], middle(rings[0]), lambda row, column: (part, "start"))
    loft(surface, rings, lambda row, column: (part, "body"))
    close_end(surface, rings[-1], middle(rings[-1]), lambda row, column: (part, "end"))


def build_blade(surface):
    rings = [blade_ring(z) for z in BLADE_STATIONS]

    def label(row, column):
        return ("Blade", "bevel" if column % 4 in (0, 3) else "flat")

    close_start(surface, rings[0], (0.0, 0.0, 0.0), lambda row, column: ("Blade", "end"))
    loft(surface, rings, label)
    close_end(surface, rings[-1], middle(rings[-1]), lambda row, column: ("Blade", "back"))


def build_grip(surface):
    rings = [grip_ring(z) for z in (GRIP[0], 28.6, 31.0)]
    for k in range(RIBS):
        z = FIRST_RIB + k * RIB_PITCH
        rings += [grip_ring(z), grip_ring(z + 0.5 * RIB_PITCH, RIB_DEPTH)]
    rings += [grip_ring(z) for z in BACK_STATIONS]
    skin(surface, "Grip", rings)


def build_pill(surface, part, place, shape, dish=0.0):
    """A rounded block that stands out of the grip's upper side, drawn along +y."""
    at, half_length, half_width = place
    rings = []
    for y, drawn_in in shape:
        wide = half_width - drawn_in
        outline = arcs(half_length - drawn_in, wide, 0.9 * wide, (1, 1), 4)
        rings.append([(b, y, at + a) for a, b in outline])
    apex = (0.0, shape[-1][0] - dish, at)
    close_start(surface, rings[0], (0.0, shape[0][0], at), lambda row, column: (part, "start"))
    loft(surface, rings, lambda row, column: (part, "body"))
    close_end(surface, rings[-1], apex, lambda row, column: (part, "top"))


def build_cable(surface):
    """The cable, which leaves the grip through a ribbed sleeve and hangs down a little."""
    path, radii = [], []
    for k in range(5):
        z = 166.0 + 2.2 * k
        path += [(0.0, 0.0, z), (0.0, 0.0, z + 1.1)]
        radii += [2.9 - 0.12 * k, 2.35 - 0.07 * k]
    for z in (177.5, 180.0, 183.0, CABLE_END[2]):
        share = (z - 176.0) / (CABLE_END[2] - 176.0)
        path.append((0.0, CABLE_END[1] * share**2, z))
        radii.append(CABLE_RADIUS)
    tube(surface, "Cable", path, radii)


def build():
    """The pencil: blade, collar, grip, plate, buttons and cable, closed shells that overlap."""
    surface = Surface(unit=0.001)
    build_blade(surface)
    collar = [oval(*station[1:], station[0]) for station in COLLAR]
    skin(surface, "Collar", collar)
    build_grip(surface)
    build_pill(surface, "Plate", *PLATE)
    for part, place in BUTTONS.items():
        build_pill(surface, part, place, BUTTON_SHAPE, DISH)
    build_cable(surface)
    return surface


def cutting_edge():
    """The lower border of the blade from the tip round its end to the collar, metres."""
    edge = [(0.0, 0.0, 0.0)] + [blade_ring(z)[0] for z in BLADE_STATIONS if z <= BLADE_LENGTH]
    return [tuple(0.001 * x for x in point) for point in edge]


def files():
    """{file name: text} of this instrument."""
    description = f"""
Electrosurgical pencil, {CABLE_END[2]:.0f} mm long, in metres. The round end of its blade touches
the origin, handle towards +Z, cutting edge towards -Y, buttons towards +Y; the blade lies in the
Y-Z plane. Closed shells that overlap.
"""
    opening = """
Electrosurgical pencil. Lengths in metres, in the frame of pencil.iv: the end of the blade at the
origin, the handle towards +Z, the cutting edge towards -Y; the blade lies in the Y-Z plane, so its
flats face +X and -X.
"""
    entries = [
        *instrument_entries(
            "Electrosurgical pencil",
            "pencil",
            "Monopolar pencil with a blade electrode; cuts and coagulates with its edge",
            "Foremost point of the blade's round end (m).",
        ),
        (
            "edge",
            cutting_edge(),
            "Narrow side of the blade from the tip to the heel: corners of a polyline (m).",
        ),
    ]
    materials = {
        "Blade": STEEL,
        "Collar": GREY,
        "Grip": WHITE,
        "Plate": GREY,
        "ButtonCut": YELLOW,
        "ButtonCoagulate": BLUE,
        "Cable": BLACK,
    }
    return {
        "pencil.iv": model_text(description, build(), materials),
        "pencil.toml": description_text(opening, entries),
    }
