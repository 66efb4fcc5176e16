"""Bipolar forceps: tweezers with insulated arms, bare tips and a plug with two pins. Millimetres.
Its arms are those of tweezers.py."""

from description import description_text, instrument_entries
from inventor import Material, model_text
from shapes.jaws import both_opened, half_turned, jaw_entries
from shapes.loft import circle, close_end, close_start, loft
from shapes.outline import arcs
from shapes.surface import Surface
from shapes.tweezers import OPENING, PIVOT, build_arm

LENGTH = 185.0
COAT = 0.2  # thickness of the insulation

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
    build_arm(surface, "JawUpper", lambda p: p, COAT)
    build_arm(surface, "JawLower", half_turned, COAT)
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
