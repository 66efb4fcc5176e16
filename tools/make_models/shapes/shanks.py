"""What forceps and clamps with two crossing halves have in common behind their jaws: shanks that
cross at the screw, and a ratchet. Millimetres. `place` puts each point of the upper half where it
belongs."""

from shapes.jaws import middle
from shapes.loft import close_end, close_start, loft, through
from shapes.outline import arcs


def bar_section(borders, z, roundness=0.7):
    """Ring of the upper half across Z: a rectangle whose rounded corners have `roundness` times its
    lesser half width as radius. `borders`: LEFT, RIGHT (x), LOWER, UPPER (y), each a list of (z,
    value). In front of the screw the half lies above the plane y = 0; at the screw and behind it,
    right of the plane x = 0."""
    left, right, low, high = (through(border, z) for border in borders)
    half_width, half_height = 0.5 * (right - left), 0.5 * (high - low)
    radius = roundness * min(half_width, half_height)
    return [
        (left + half_width + x, low + half_height + y, z)
        for x, y in arcs(half_width, half_height, radius, (1, 1), 2)
    ]


def skin(surface, part, place, rings):
    """A closed skin over rings, flat at both ends."""
    rings = [[place(p) for p in ring] for ring in rings]
    close_start(surface, rings[0], middle(rings[0]), lambda row, column: (part, "start"))
    loft(surface, rings, lambda row, column: (part, "body"))
    close_end(surface, rings[-1], middle(rings[-1]), lambda row, column: (part, "end"))


def ratchet(surface, part, place, z, y, x=(0.4, 2.0), half_length=1.9, teeth=4):
    """A toothed arm along Y at `z`, from y[0] to y[1]; the arm of the other half slides along its
    left side."""
    half_width, centre = 0.5 * (x[1] - x[0]), 0.5 * (x[0] + x[1])
    toothed = 0.45 * (y[1] - y[0])

    def ring(at, pressed=0.0):
        # Right-handed about the direction of travel, +y: from +z to +x.
        outline = arcs(half_length - pressed, half_width, 0.4 * half_width, (1, 1), 1)
        return [(centre + b, at, z + a) for a, b in outline]

    rings = [ring(y[0])]
    for k in range(teeth):
        at = y[1] - toothed * (1.0 - k / teeth)
        rings += [ring(at), ring(at + 0.6 * toothed / teeth, 0.6)]
    skin(surface, part, place, rings + [ring(y[1])])
