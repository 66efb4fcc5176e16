"""Bipolar forceps: tweezers with insulated arms, bare tips and a plug with two pins. Millimetres.
Its arms are those of tweezers.py."""

from inventor import Material
from shapes import tweezers
from shapes.loft import circle, close_end, close_start, loft
from shapes.outline import arcs

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


def files():
    """{file name: text} of this instrument."""
    return tweezers.files(
        "bipolar",
        "Bipolar forceps",
        "Insulated forceps; coagulate what lies between their bare tips",
        LENGTH,
        "plug",
        tweezers.build(build_plug, COAT),
        {
            "JawUpper": BLUE,
            "JawUpperTip": STEEL,
            "JawLower": BLUE,
            "JawLowerTip": STEEL,
            "Plug": BLACK,
            "Pins": STEEL,
        },
    )
