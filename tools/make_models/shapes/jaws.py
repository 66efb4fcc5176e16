"""What instruments with two jaws have in common. Millimetres, except where a text is written."""

import math

from inventor import numbers
from shapes.loft import circle, close_end, close_start, loft


def middle(ring):
    """Mean of the points of a ring."""
    return tuple(sum(p[a] for p in ring) / len(ring) for a in range(3))


def half_turned(p):
    """The other of two equal halves: half a turn about the Z axis."""
    return (-p[0], -p[1], p[2])


def opened(angle, pivot):
    """The transform that holds a jaw open: it turns about the pivot, `pivot` millimetres along
    Z."""
    return (
        "Transform {\n"
        f"  rotation 1 0 0 {numbers([angle], 6)}\n"
        f"  center 0 0 {numbers([0.001 * pivot], 6)}\n"
        "}\n"
    )


def jaw_entries(
    pivot,
    opening,
    at="The screw that the jaws turn about (m).",
    along="Unit vector along the screw.",
    between="Angle between the jaws when wide open (rad).",
):
    """The entries of the description that tell how two jaws turn; `pivot` as in opened(), `opening`
    in rad."""
    return [
        ("jaw_pivot", (0.0, 0.0, 0.001 * pivot), at),
        ("jaw_axis", (1.0, 0.0, 0.0), along),
        ("jaw_opening", opening, between),
    ]


def both_opened(opening, pivot, parts):
    """{part: transform} of the wide open jaws: those whose names begin with JawUpper turn one way,
    those with JawLower the other."""
    return {
        part: opened(0.5 * opening if part.startswith("JawUpper") else -0.5 * opening, pivot)
        for part in parts
    }


def finger_ring(surface, part, place, centre, half, tube, steps):
    """A closed ring in the Y-Z plane. `centre` (x, y, z); `half`: of the tube's centre line in y
    and z; `tube`: radii across (x) and in the plane of the ring; `steps`: round the ring and round
    the tube; `place` puts each point where it belongs."""
    rings = []
    for k in range(steps[0]):
        a = 2.0 * math.pi * k / steps[0]
        row = []
        for across, along in circle(steps[1], tube[0], tube[1]):
            y = centre[1] + (half[0] + along) * math.cos(a)
            z = centre[2] + (half[1] + along) * math.sin(a)
            row.append(place((centre[0] + across, y, z)))
        rings.append(row)
    loft(surface, rings + rings[:1], lambda row, column: (part, "ring"))


def screw(surface, pivot, radius, half, sides=20):
    """A screw along X through the pivot; `half`: x of its slightly domed heads."""

    def disc(x, wide):
        return [(x, y, pivot + z) for y, z in circle(sides, wide)]

    rings = [
        disc(-half, 0.8 * radius),
        disc(-half + 0.5, radius),
        disc(half - 0.5, radius),
        disc(half, 0.8 * radius),
    ]
    close_start(surface, rings[0], (-half, 0.0, pivot), lambda r, c: ("Screw", "head"))
    loft(surface, rings, lambda r, c: ("Screw", ("side", r)))
    close_end(surface, rings[-1], (half, 0.0, pivot), lambda r, c: ("Screw", "other head"))
