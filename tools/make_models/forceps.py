"""Tissue forceps: steel tweezers whose arms meet in a block. Millimetres. Their arms are those of
tweezers.py."""

from description import description_text, instrument_entries
from inventor import Material, model_text
from shapes.jaws import both_opened, half_turned, jaw_entries
from shapes.loft import close_end, close_start, loft
from shapes.outline import arcs
from shapes.surface import Surface
from shapes.tweezers import OPENING, PIVOT, build_arm

LENGTH = 172.0
SLIP_FORCE = 3.0  # N

# z against half width (x) and half height (y) of the block that the ends of the arms overlap
BLOCK = (
    (149.0, 3.3, 3.4),
    (149.6, 3.7, 3.8),
    (160.0, 3.7, 3.5),
    (169.0, 3.3, 2.6),
    (171.4, 2.6, 1.9),
    (LENGTH, 1.6, 1.2),
)

STEEL = Material((0.62, 0.63, 0.65), (0.65, 0.65, 0.67), 0.4)
TIPS = Material((0.55, 0.5, 0.4), (0.6, 0.55, 0.42), 0.3)  # hard metal, as on needle holders


def build_block(surface):
    def label(row, column):
        return ("Block", "end" if row < 0 else "body")

    rings = [
        [(x, y, z) for x, y in arcs(half_width, half_height, 0.6 * half_height, (1, 1), 3)]
        for z, half_width, half_height in BLOCK
    ]
    close_start(surface, rings[0], (0.0, 0.0, BLOCK[0][0]), label)
    loft(surface, rings, label)
    close_end(surface, rings[-1], (0.0, 0.0, LENGTH), label)


def build():
    """The forceps closed: two arms and the block, which overlap."""
    surface = Surface(unit=0.001)
    build_arm(surface, "JawUpper", lambda p: p)
    build_arm(surface, "JawLower", half_turned)
    build_block(surface)
    return surface


def files():
    """{file name: text} of this instrument."""
    description = f"""
Tissue forceps, {LENGTH:.0f} mm long, in metres, open. Closed, the tips meet at the origin; handle
towards +Z; the arms turn in the Y-Z plane about a line in the block. The parts whose names begin
with JawUpper and JawLower are wide open: viewers turn them as the forceps close.
"""
    opening = """
Tissue forceps. Lengths in metres, in the frame of forceps.iv: the closed tips at the origin, the
handle towards +Z; the arms move in the Y-Z plane.
"""
    entries = [
        *instrument_entries(
            "Tissue forceps",
            "forceps",
            "Tweezers with toothed tips; hold what is between them, and pull it",
            "Where the tips meet (m).",
        ),
        *jaw_entries(
            PIVOT,
            OPENING,
            at="Where the arms bend, inside the block (m).",
            along="Unit vector of the line that the arms turn about.",
            between="Angle between the arms when wide open (rad).",
        ),
        ("slip_force", SLIP_FORCE, "Beyond this pull they let go of what they hold (N)."),
    ]
    materials = {
        "JawUpper": STEEL,
        "JawUpperTip": TIPS,
        "JawLower": STEEL,
        "JawLowerTip": TIPS,
        "Block": STEEL,
    }
    before = both_opened(OPENING, PIVOT, [part for part in materials if part.startswith("Jaw")])
    return {
        "forceps.iv": model_text(description, build(), materials, before=before),
        "forceps.toml": description_text(opening, entries),
    }
