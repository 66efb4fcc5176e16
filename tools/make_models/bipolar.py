"""Bipolar forceps: tweezers with insulated arms, bare tips and a plug with two pins. Millimetres.
The two arms are one shape, turned by half a turn about the Z axis."""

from description import description_text, instrument_entries
from inventor import Material, model_text
from jaws import both_opened, half_turned, jaw_entries, middle
from loft import circle, close_end, close_start, loft, through
from outline import arcs
from surface import Surface

LENGTH = 185.0
PIVOT = 156.0  # z: inside the plug, where the arms begin to bend
OPENING = 0.064  # rad between the arms when wide open: 10 mm between the tips
GAP = 0.005  # between the closed tips, each side of the plane y = 0
BARE = 9.0  # length of the tips without insulation
COAT = 0.2  # thickness of the insulation

# z against the inner border (y), the thickness (y) and the half width (x) of the upper arm, closed
INNER = (
    (0.0, GAP),
    (5.5, GAP),
    (BARE, 0.25),
    (12.0, 0.5),
    (40.0, 1.9),
    (85.0, 4.9),
    (115.0, 5.2),
    (140.0, 3.2),
    (PIVOT, 0.9),
    (162.0, 0.7),
)
THICKNESS = (
    (0.0, 0.55),
    (0.5, 0.85),
    (1.2, 1.0),
    (12.0, 1.1),
    (40.0, 1.5),
    (85.0, 2.0),
    (120.0, 2.2),
    (162.0, 2.0),
)
HALF_WIDTH = (
    (0.0, 0.28),
    (0.5, 0.43),
    (1.2, 0.5),
    (12.0, 0.65),
    (40.0, 1.3),
    (70.0, 2.2),
    (88.0, 4.2),
    (98.0, 4.6),
    (124.0, 4.6),
    (145.0, 3.6),
    (162.0, 3.2),
)
TIP_STATIONS = (0.0, 0.2, 0.5, 1.2, 3.5, 5.5, BARE)
ARM_STATIONS = (BARE + 0.1, 12.0, 18.0, 26.0, 34.0, 42.0, 51.0, 60.0, 70.0, 76.0, 82.0, 88.0, 93.0)
RIBS = 8
FIRST_RIB = 96.0
RIB_PITCH = 3.2
RIB_DEPTH = 0.45  # only outside, where the fingers are
BACK_STATIONS = (122.0, 130.0, 138.0, 146.0, 154.0, 162.0)

# z against half width (x) and half height (y) of the plug
PLUG = (
    (145.0, 4.9, 5.6),
    (145.6, 5.4, 6.3),
    (147.0, 5.7, 6.7),
    (152.0, 5.7, 6.7),
    (157.0, 4.7, 6.0),
    (164.0, 4.7, 6.0),
    (168.0, 5.3, 6.9),
    (172.0, 5.3, 6.9),
    (172.8, 5.1, 6.7),
)
PLUG_CORNER = 2.4
PIN_Y = 3.5
PIN = ((171.0, 1.6), (182.6, 1.6), (184.2, 1.3), (LENGTH, 0.6))  # z against its radius

STEEL = Material((0.62, 0.63, 0.65), (0.65, 0.65, 0.67), 0.4)
BLUE = Material((0.08, 0.19, 0.47), (0.18, 0.19, 0.22), 0.2)
BLACK = Material((0.11, 0.11, 0.12), (0.12, 0.12, 0.12), 0.15)


def section(z, coat=0.0, pressed=0.0):
    """Ring of the upper arm across Z. `coat` widens it all round; `pressed` lowers its outside."""
    low = through(INNER, z) - coat
    high = through(INNER, z) + through(THICKNESS, z) + coat - pressed
    half_width, half_height = through(HALF_WIDTH, z) + coat, 0.5 * (high - low)
    radius = 0.8 * min(half_width, half_height)
    return [
        (x, 0.5 * (low + high) + y, z) for x, y in arcs(half_width, half_height, radius, (1, 1), 2)
    ]


def build_arm(surface, part, place):
    """One arm: a bare tip and the insulated rest, one closed skin."""
    tip = [section(z) for z in TIP_STATIONS]
    arm = [section(z, COAT) for z in ARM_STATIONS]
    for k in range(RIBS):
        z = FIRST_RIB + k * RIB_PITCH
        arm += [section(z, COAT), section(z + 0.5 * RIB_PITCH, COAT, RIB_DEPTH)]
    arm += [section(z, COAT) for z in BACK_STATIONS]
    rings = [[place(p) for p in ring] for ring in tip + arm]

    def label(row, column):
        if row == -1 or 0 <= row < len(tip) - 1:
            return (part + "Tip", "body")
        return (part, "front" if row == len(tip) - 1 else "end" if row == -2 else "body")

    close_start(surface, rings[0], middle(rings[0]), label)
    loft(surface, rings, label)
    close_end(surface, rings[-1], middle(rings[-1]), label)


def build_plug(surface):
    """The plug, which the ends of the arms overlap, and its two pins."""

    def label(row, column):
        return ("Plug", "end" if row < 0 else "body")

    rings = [
        [(x, y, z) for x, y in arcs(half_width, half_height, PLUG_CORNER, (1, 1), 3)]
        for z, half_width, half_height in PLUG
    ]
    close_start(surface, rings[0], (0.0, 0.0, PLUG[0][0]), label)
    loft(surface, rings, label)
    close_end(surface, rings[-1], (0.0, 0.0, PLUG[-1][0]), label)
    for side in (1.0, -1.0):
        rings = [[(x, side * PIN_Y + y, z) for x, y in circle(12, radius)] for z, radius in PIN]
        close_start(surface, rings[0], (0.0, side * PIN_Y, PIN[0][0]), lambda r, c: ("Pins", "end"))
        loft(surface, rings, lambda r, c: ("Pins", r))
        close_end(surface, rings[-1], (0.0, side * PIN_Y, LENGTH), lambda r, c: ("Pins", "tip"))


def build():
    """The forceps closed: two arms, the plug and its pins, which overlap."""
    surface = Surface(unit=0.001)
    build_arm(surface, "JawUpper", lambda p: p)
    build_arm(surface, "JawLower", half_turned)
    build_plug(surface)
    return surface


def files():
    """{file name: text} of this instrument."""
    description = f"""
Bipolar forceps, {LENGTH:.0f} mm long, in metres, open. Closed, the tips meet at the origin; handle
towards +Z; the arms turn in the Y-Z plane about a line in the plug. The parts whose names begin
with JawUpper and JawLower are wide open: viewers turn them as the forceps close.
"""
    opening = """
Bipolar forceps. Lengths in metres, in the frame of bipolar.iv: the closed tips at the origin, the
handle towards +Z; the arms move in the Y-Z plane.
"""
    entries = [
        *instrument_entries(
            "Bipolar forceps",
            "bipolar",
            "Insulated forceps; coagulate what lies between their bare tips",
            "Where the tips meet (m).",
        ),
        *jaw_entries(
            PIVOT,
            OPENING,
            at="Where the arms bend, inside the plug (m).",
            along="Unit vector of the line that the arms turn about.",
            between="Angle between the arms when wide open (rad).",
        ),
    ]
    materials = {
        "JawUpper": BLUE,
        "JawUpperTip": STEEL,
        "JawLower": BLUE,
        "JawLowerTip": STEEL,
        "Plug": BLACK,
        "Pins": STEEL,
    }
    before = both_opened(OPENING, PIVOT, [part for part in materials if part.startswith("Jaw")])
    return {
        "bipolar.iv": model_text(description, build(), materials, before=before),
        "bipolar.toml": description_text(opening, entries),
    }
