"""A folded gauze swab in closed ring forceps after Foerster's ("swab on a stick"). Millimetres.

The swab is one skin from the middle of its underside over its three layers and the gathers of its
top into the fold that the rings of the forceps hold. The two halves of the forceps are one shape,
turned by half a turn about the Z axis."""

import math

from description import description_text, instrument_entries
from inventor import Material, model_text
from shapes.jaws import finger_ring, half_turned, screw
from shapes.loft import close_end, close_start, loft, through
from shapes.outline import rounded, square
from shapes.shanks import bar_section, ratchet, skin
from shapes.surface import Surface

SIDE = 32.0  # of the square swab
THICKNESS = 10.0
STEPS = 11  # of the swab's skin along each side
GATHERS = 9  # round the swab
UNEVEN = 0.44  # how far the border of the layers is from straight

# The layers do not lie quite straight on each other: z against the angle by which each is turned.
TURNED = ((0.0, -0.015), (3.7, -0.02), (3.8, 0.035), (6.3, 0.03), (6.4, -0.03), (9.0, -0.02))
TURNED += ((10.5, 0.0),)

# z against half width (x), half depth (y), radius of the corners and depth of the gathers
PAD = (
    (0.06, 3.5, 3.5, 2.5, 0.0),
    (0.2, 7.5, 7.5, 4.0, 0.0),
    (0.45, 11.0, 11.0, 5.0, 0.0),
    (0.9, 13.8, 13.8, 5.5, 0.0),
    (1.6, 15.4, 15.4, 5.5, 0.0),
    (2.5, 0.5 * SIDE, 0.5 * SIDE, 5.5, 0.0),
    (3.3, 15.7, 15.6, 5.5, 0.0),
    (3.75, 14.7, 14.6, 5.5, 0.0),
    (4.2, 15.3, 15.8, 5.0, 0.0),
    (5.0, 15.7, 0.5 * SIDE, 5.0, 0.0),
    (5.8, 15.2, 15.5, 5.0, 0.1),
    (6.3, 14.2, 14.6, 5.0, 0.1),
    (6.8, 15.2, 15.0, 5.5, 0.1),
    (7.7, 15.6, 15.2, 5.5, 0.2),
    (8.7, 14.9, 14.2, 5.5, 0.4),
    (9.5, 13.6, 12.2, 5.0, 0.7),
    (THICKNESS, 12.2, 9.2, 4.5, 0.9),
    (10.5, 11.5, 6.2, 3.8, 0.9),
    (11.6, 11.2, 4.2, 2.8, 0.7),
)
# The same of the fold between the rings, up to where it is gathered in its top.
FOLD = (
    (14.0, 11.4, 3.2, 2.0, 0.5),
    (17.0, 11.6, 2.9, 1.8, 0.45),
    (20.5, 11.7, 2.9, 1.8, 0.45),
    (24.0, 11.2, 2.8, 1.7, 0.45),
    (26.0, 10.4, 2.4, 1.4, 0.4),
    (27.3, 8.8, 1.6, 0.9, 0.2),
)
FOLD_TOP = 27.7
THREAD = 14  # column of the skin in which the X-ray thread is drawn

JAW_RING_CENTRE = (2.6, 23.0)  # y, z of the upper jaw's ring
JAW_RING_HALF = (8.2, 11.2)  # of the tube's centre line, x and z
JAW_RING_TUBE = (1.3, 1.9)  # radii across (y) and in the plane of the ring
JAW_RING_STEPS = (24, 8)

PIVOT = 108.0  # z of the screw
GAP = 0.02  # between the two halves, each side of the plane x = 0
LEFT = ((33.0, -2.1), (50.0, -2.0), (90.0, -2.0), (99.0, GAP))
RIGHT = ((33.0, 2.1), (50.0, 2.0), (90.0, 2.0), (99.0, 2.8), (PIVOT, 3.3), (118.0, 3.1))
LOWER = (
    (33.0, 1.3),
    (40.0, 1.3),
    (60.0, 2.0),
    (85.0, 1.6),
    (99.0, 0.4),
    (PIVOT, -4.6),
    (117.0, -5.6),
    (130.0, -6.6),
    (148.0, -10.4),
    (161.0, -14.6),
)
UPPER = (
    (33.0, 3.9),
    (40.0, 4.2),
    (60.0, 5.2),
    (85.0, 5.2),
    (99.0, 5.4),
    (PIVOT, 4.6),
    (117.0, 0.0),
    (130.0, -3.2),
    (148.0, -7.0),
    (161.0, -11.2),
)
STATIONS = (33.0, 36.0, 40.0, 60.0, 85.0, 92.0, 96.0, 99.0, 102.0, 105.0, PIVOT)
STATIONS += (111.0, 114.0, 117.0, 130.0, 139.0, 148.0, 161.0)

RING_CENTRE = (-14.6, 171.5)  # y, z of the upper half's finger ring
RING_HALF = (9.8, 11.8)
RING_TUBE = (1.7, 1.9)
RING_STEPS = (22, 8)
RATCHET_Z = 150.0
SCREW_RADIUS = 2.9
SCREW_HALF = 3.8

STEEL = Material((0.62, 0.63, 0.65), (0.65, 0.65, 0.67), 0.4)
COTTON = Material((0.95, 0.94, 0.90), (0.03, 0.03, 0.03), 0.02)
BLUE = Material((0.12, 0.30, 0.66), (0.04, 0.04, 0.04), 0.02)


def swab_ring(z, half_width, half_depth, radius, gather):
    """Section of the swab. Gathers run from its top into the fold: there the skin goes in and out
    along its normal."""
    angle = through(TURNED, z)
    cosine, sine = math.cos(angle), math.sin(angle)
    directions = square(STEPS, STEPS)
    ring = []
    for k, (point, normal) in enumerate(rounded(directions, half_width, half_depth, radius)):
        turn = 2.0 * math.pi * k / len(directions)
        wave = gather * math.cos(GATHERS * turn + 0.6 * math.sin(turn))
        wave += UNEVEN * math.sin(3.0 * turn + 1.3 * z) * min(z / 3.0, 1.0) * half_depth / SIDE
        x, y = (point[a] + wave * normal[a] for a in range(2))
        ring.append((cosine * x - sine * y, sine * x + cosine * y, z))
    return ring


def build_swab(surface):
    """The swab as one closed skin; a blue thread in it shows up in X-rays."""
    rings = [swab_ring(*station) for station in PAD + FOLD]

    def label(row, column):
        return ("Thread" if column == THREAD and row >= 3 else "Swab", "cloth")

    close_start(surface, rings[0], (0.0, 0.0, 0.0), label)
    loft(surface, rings, label)
    close_end(surface, rings[-1], (0.0, 0.0, FOLD_TOP), label)


def build_half(surface, place):
    """One half of the forceps: the jaw's ring, the arm and shank, the finger ring and a ratchet."""

    def across(p):
        """From the Y-Z plane, in which rings are drawn, to the X-Z plane."""
        return place((p[1], -p[0], p[2]))

    y, z = JAW_RING_CENTRE
    finger_ring(
        surface, "Forceps", across, (-y, 0.0, z), JAW_RING_HALF, JAW_RING_TUBE, JAW_RING_STEPS
    )
    borders = (LEFT, RIGHT, LOWER, UPPER)
    skin(surface, "Forceps", place, [bar_section(borders, z) for z in STATIONS])
    centre = (0.5 * RIGHT[-1][1], *RING_CENTRE)
    finger_ring(surface, "Forceps", place, centre, RING_HALF, RING_TUBE, RING_STEPS)
    ratchet(surface, "Forceps", place, RATCHET_Z, (-9.0, 5.0))


def build():
    """The swab and the closed forceps, which overlap."""
    surface = Surface(unit=0.001)
    build_swab(surface)
    build_half(surface, lambda p: p)
    build_half(surface, half_turned)
    screw(surface, PIVOT, SCREW_RADIUS, SCREW_HALF)
    return surface


def files():
    """{file name: text} of this instrument."""
    description = f"""
Gauze swab in ring forceps, in metres. The middle of the swab's underside is at the origin; the swab
is {SIDE:.0f} mm square in X and Y and {THICKNESS:.0f} mm thick, and a fold of it rises between the
rings of the closed forceps. Handle towards +Z; the forceps' rings face +Y and -Y. Closed shells
that overlap.
"""
    opening = """
Gauze swab in ring forceps. Lengths in metres, in the frame of gauze.iv: the middle of the swab's
underside at the origin, the handle towards +Z.
"""
    entries = [
        *instrument_entries(
            "Gauze swab",
            "gauze",
            "Folded gauze swab in ring forceps; dabs up blood and presses on a bleeding surface",
            "Middle of the swab's underside (m).",
        ),
        (
            "contact_radius",
            0.0005 * SIDE,
            "Half the side of the swab: what touches lies this close to the tip (m).",
        ),
    ]
    materials = {"Swab": COTTON, "Thread": BLUE, "Forceps": STEEL, "Screw": STEEL}
    return {
        "gauze.iv": model_text(description, build(), materials),
        "gauze.toml": description_text(opening, entries),
    }
