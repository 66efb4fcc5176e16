"""Tissue forceps: steel tweezers whose arms meet in a block. Millimetres. Their arms are those of
tweezers.py."""

from inventor import Material
from shapes import tweezers
from shapes.loft import close_end, close_start, loft
from shapes.outline import arcs

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


def files():
    """{file name: text} of this instrument."""
    return tweezers.files(
        "forceps",
        "Tissue forceps",
        "Tweezers with toothed tips; hold what is between them, and pull it",
        LENGTH,
        "block",
        tweezers.build(build_block),
        {
            "JawUpper": STEEL,
            "JawUpperTip": TIPS,
            "JawLower": STEEL,
            "JawLowerTip": TIPS,
            "Block": STEEL,
        },
        [("slip_force", SLIP_FORCE, "Beyond this pull they let go of what they hold (N).")],
    )
