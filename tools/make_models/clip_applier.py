"""A clip applier for open surgery: two grooved jaws that face each other, a screw, long shanks with
finger rings, and a polymer clip between the jaws. Millimetres. The two halves are one shape,
turned by half a turn about the Z axis."""

import math

from description import description_text, instrument_entries
from inventor import Material, model_text
from shapes.jaws import both_opened, finger_ring, half_turned, jaw_entries, middle, screw
from shapes.loft import circle, close_end, close_start, loft, through
from shapes.surface import Surface
from shapes.vector import add, dot, scale, subtract, unit

LENGTH = 185.0
PIVOT = 38.0  # z of the screw
OPENING = 0.2  # rad between the jaws when wide open: 7.6 mm between their ends
GAP = 0.005  # between what touches when closed, each side

# z against the borders of the upper half, closed: the jaw lies on its side of the plane y = 0 and
# faces the other; at the screw and behind it the half lies on its side of the plane x = 0.
LEFT = ((20.0, -2.0), (25.0, GAP))
RIGHT = (
    (0.0, 1.25),
    (0.7, 1.65),
    (2.2, 1.9),
    (5.0, 2.0),
    (20.0, 2.0),
    (27.0, 2.9),
    (PIVOT, 3.2),
    (62.0, 3.2),
)
LOWER = (
    (0.0, 0.35),
    (25.0, 0.35),
    (30.0, -4.2),
    (44.0, -5.4),
    (50.0, -5.6),
    (62.0, -5.6),
    (105.0, -8.4),
    (135.0, -11.8),
    (158.0, -15.0),
)
UPPER = (
    (0.0, 1.8),
    (0.7, 2.55),
    (2.2, 3.2),
    (8.0, 3.6),
    (20.0, 4.2),
    (28.0, 5.4),
    (PIVOT, 5.0),
    (46.0, 2.4),
    (54.0, -0.8),
    (62.0, -1.6),
    (105.0, -4.6),
    (135.0, -8.0),
    (158.0, -11.2),
)
STATIONS = (
    (0.0, 0.3, 0.7, 2.2, 5.0, 8.5, 11.5, 12.0, 16.0, 20.0, 22.0, 23.5, 25.0, 26.5, 28.0, 30.0)
    + (33.0, PIVOT, 42.0, 46.0, 50.0, 54.0, 62.0, 76.0, 90.0, 105.0, 120.0, 135.0, 147.0, 158.0)
)
GROOVE = ((11.5, 0.6), (12.0, 0.0))  # z against its depth: it holds the clip
GROOVE_HALF = 0.75
INNER_BEVEL = 0.25  # of the borders beside the groove
OUTER_BEVEL = 0.9

RING_CENTRE = (-14.4, 170.8)  # y, z
RING_HALF = (10.2, 12.2)  # of the tube's centre line, y and z
RING_TUBE = (1.8, 2.0)  # radii across (x) and in the plane of the ring
RING_STEPS = (24, 8)
SCREW_RADIUS = 3.2
SCREW_HALF = 3.7

# One leg of the clip when the jaws are wide open, z from the end of the jaws: straight along the
# jaw, then aslant to the middle, where it meets the other. Closed, the bend dips into the other jaw
# and is not seen.
CLIP_LEG = 8.0
CLIP_BEND = 10.8
CLIP_HALF = (0.6, 0.45)  # of its wire, in x and across

STEEL = Material((0.62, 0.63, 0.65), (0.65, 0.65, 0.67), 0.4)
POLYMER = Material((0.50, 0.95, 0.90), (0.05, 0.05, 0.05), 0.35)


def section(z):
    """Ring of the upper half across Z; points 2 to 5 are the groove for the clip."""
    right = through(RIGHT, z)
    left = max(through(LEFT, z), -right)
    low, high, depth = through(LOWER, z), through(UPPER, z), through(GROOVE, z)
    centre, half = 0.5 * (left + right), 0.5 * (right - left)
    slot = min(GROOVE_HALF, 0.6 * half)
    edge, corner = INNER_BEVEL, min(OUTER_BEVEL, 0.35 * (high - low), 0.5 * half)
    outline = [
        (-half, low + edge),
        (edge - half, low),
        (-slot, low),
        (0.1 - slot, low + depth),
        (slot - 0.1, low + depth),
        (slot, low),
        (half - edge, low),
        (half, low + edge),
        (half, high - corner),
        (half - corner, high),
        (corner - half, high),
        (-half, high - corner),
    ]
    return [(centre + x, y, z) for x, y in outline]


def above_groove(ring):
    """A point from which the whole ring of a section is seen."""
    return middle([ring[k] for k in (3, 4, 9, 10)])


def build_half(surface, part, place):
    """One half: a skin from the end of the jaw to the shank and a finger ring that overlaps its
    end."""
    rings = [[place(p) for p in section(z)] for z in STATIONS]

    def label(row, column):
        if row < 0:
            return (part, "end")
        return (part, "face" if column <= 6 else "outside")

    close_start(surface, rings[0], above_groove(rings[0]), label)
    loft(surface, rings, label)
    close_end(surface, rings[-1], above_groove(rings[-1]), label)
    centre = (0.5 * through(RIGHT, STATIONS[-1]), *RING_CENTRE)
    finger_ring(surface, part, place, centre, RING_HALF, RING_TUBE, RING_STEPS)


def turned_open(p, angle):
    """The point of the upper half where it is when the half is turned open by `angle`."""
    y, z = p[1], p[2] - PIVOT
    return (
        p[0],
        y * math.cos(angle) - z * math.sin(angle),
        PIVOT + y * math.sin(angle) + z * math.cos(angle),
    )


def clip_leg(surface, part, place):
    """Half of the clip, as the closed jaws hold it: a wire from its end to where it meets the other
    half."""
    y = CLIP_HALF[1] + GAP
    corners = [turned_open((0.0, y, z), 0.5 * OPENING) for z in (0.0, CLIP_LEG)]
    corners.append((0.0, 0.0, CLIP_BEND))
    leg, bend = (unit(subtract(b, a)) for a, b in zip(corners, corners[1:]))
    # The planes in which the wire ends and bends, each by a normal of it.
    normals = (leg, unit(add(leg, bend)), (0.0, -1.0, 0.0))
    rings = []
    for corner, normal, along in zip(corners, normals, (leg, leg, bend)):
        up = scale((0.0, normal[2], -normal[1]), 1.0 / dot(normal, along))
        ring = [add(corner, (x, t * up[1], t * up[2])) for x, t in circle(8, *CLIP_HALF)]
        rings.append([place(turned_open(p, -0.5 * OPENING)) for p in ring])

    def label(row, column):
        return (part, row)

    close_start(surface, rings[0], middle(rings[0]), label)
    loft(surface, rings, label)
    close_end(surface, rings[-1], middle(rings[-1]), label)


def build():
    """The clip applier closed: two halves, each with its leg of the clip, and the screw."""
    surface = Surface(unit=0.001)
    for part, place in (("JawUpper", lambda p: p), ("JawLower", half_turned)):
        build_half(surface, part, place)
        clip_leg(surface, part + "Clip", place)
    screw(surface, PIVOT, SCREW_RADIUS, SCREW_HALF)
    return surface


def files():
    """{file name: text} of this instrument."""
    description = f"""
Clip applier, {LENGTH:.0f} mm long, in metres, open, with a clip in its jaws. Closed, the ends of
the jaws meet at the origin; handle towards +Z; the jaws turn in the Y-Z plane about the screw. The
parts whose names begin with JawUpper and JawLower are wide open: viewers turn them about the screw
as the jaws close.
"""
    opening = """
Clip applier. Lengths in metres, in the frame of clip_applier.iv: where the ends of the jaws meet at
the origin, the handle towards +Z; the jaws move in the Y-Z plane.
"""
    entries = [
        *instrument_entries(
            "Clip applier",
            "clip_applier",
            "Clip applier with a polymer clip; closes a vessel that lies between its jaws",
            "Where the ends of the jaws meet (m).",
        ),
        *jaw_entries(PIVOT, OPENING),
    ]
    materials = {
        "JawUpper": STEEL,
        "JawLower": STEEL,
        "Screw": STEEL,
        "JawUpperClip": POLYMER,
        "JawLowerClip": POLYMER,
    }
    before = both_opened(OPENING, PIVOT, [part for part in materials if part.startswith("Jaw")])
    return {
        "clip_applier.iv": model_text(description, build(), materials, before=before),
        "clip_applier.toml": description_text(opening, entries),
    }
