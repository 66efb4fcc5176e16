"""A vascular clamp for the inflow of the liver: two straight jaws with soft ribbed inserts (after
Fogarty's), a screw, shanks with a ratchet and finger rings. Millimetres. The two halves are one
shape, turned by half a turn about the Z axis."""

from description import description_text, instrument_entries
from inventor import Material, model_text
from shapes.jaws import both_opened, finger_ring, half_turned, jaw_entries, screw
from shapes.outline import arcs
from shapes.shanks import bar_section, ratchet, skin
from shapes.surface import Surface

LENGTH = 185.0
PIVOT = 50.0  # z of the screw
OPENING = 0.35  # rad between the jaws when wide open: 17 mm between their ends
GAP = 0.005  # between what touches when closed, each side

# z against the borders of the upper half, closed: the jaw lies on its side of the plane y = 0; at
# the screw and behind it the half lies on its side of the plane x = 0.
LEFT = ((0.0, -1.4), (0.8, -2.0), (2.5, -2.4), (34.0, -2.6), (39.0, GAP))
RIGHT = (
    (0.0, 1.4),
    (0.8, 2.0),
    (2.5, 2.4),
    (34.0, 2.6),
    (40.0, 3.2),
    (PIVOT, 3.6),
    (62.0, 3.2),
    (90.0, 3.0),
)
LOWER = (
    (0.0, GAP),
    (1.4, GAP),
    (1.5, 1.0),
    (32.5, 1.0),
    (36.0, 1.2),
    (40.0, 0.6),
    (PIVOT, -5.0),
    (60.0, -5.4),
    (72.0, -5.2),
    (105.0, -8.2),
    (135.0, -11.6),
    (160.0, -14.6),
)
UPPER = (
    (0.0, 1.3),
    (0.8, 2.2),
    (2.5, 2.9),
    (12.0, 3.4),
    (32.0, 4.4),
    (42.0, 6.0),
    (PIVOT, 5.0),
    (60.0, 0.6),
    (72.0, -1.4),
    (105.0, -4.6),
    (135.0, -8.2),
    (160.0, -11.2),
)
STATIONS = (0.0, 0.3, 0.8, 1.4, 1.5, 2.5, 7.0, 12.0, 20.0, 27.0, 32.5, 34.0, 35.5, 37.0, 39.0)
STATIONS += (41.0, 43.5, 46.5, PIVOT, 53.0, 56.5, 60.0, 66.0, 72.0, 83.0, 94.0, 105.0, 120.0)
STATIONS += (135.0, 148.0, 160.0)

# The insert of the upper jaw: a bar sunk into the jaw, with ribs across its face.
INSERT = (1.6, 32.0)  # z
INSERT_HALF_WIDTH = 2.9
INSERT_DEPTH = 1.9  # y of its back
RIBS = 16
RIB_DEPTH = 0.35

RING_CENTRE = (-14.4, 171.4)  # y, z of the upper half's finger ring
RING_HALF = (10.0, 11.6)
RING_TUBE = (1.7, 2.0)
RING_STEPS = (24, 8)
RATCHET_Z = 148.0
SCREW_RADIUS = 3.2
SCREW_HALF = 4.1

STEEL = Material((0.62, 0.63, 0.65), (0.65, 0.65, 0.67), 0.4)
SILICONE = Material((0.45, 0.68, 0.86), (0.08, 0.08, 0.08), 0.1)


def insert_section(z, pressed=0.0):
    """Ring across Z; its face (y = GAP) is lower by `pressed` in a groove between two ribs."""
    half_height = 0.5 * (INSERT_DEPTH - GAP - pressed)
    outline = arcs(INSERT_HALF_WIDTH, half_height, 0.3, (1, 1), 1)
    return [(x, GAP + pressed + half_height + y, z) for x, y in outline]


def insert_rings():
    pitch = (INSERT[1] - INSERT[0]) / RIBS
    rings = []
    for k in range(RIBS):
        z = INSERT[0] + k * pitch
        rings += [insert_section(z), insert_section(z + 0.3 * pitch)]
        if k + 1 < RIBS:
            rings.append(insert_section(z + 0.65 * pitch, RIB_DEPTH))
    return rings


def build_half(surface, part, place):
    """One half: a skin from the end of the jaw to the shank, the insert, a finger ring and a
    ratchet."""
    borders = (LEFT, RIGHT, LOWER, UPPER)
    skin(surface, part, place, [bar_section(borders, z, 0.6) for z in STATIONS])
    skin(surface, part + "Insert", place, insert_rings())
    centre = (0.5 * RIGHT[-1][1], *RING_CENTRE)
    finger_ring(surface, part, place, centre, RING_HALF, RING_TUBE, RING_STEPS)
    ratchet(surface, part, place, RATCHET_Z, (-10.5, 6.0))


def build():
    """The clamp closed: two halves, each with its insert, and the screw."""
    surface = Surface(unit=0.001)
    for part, place in (("JawUpper", lambda p: p), ("JawLower", half_turned)):
        build_half(surface, part, place)
    screw(surface, PIVOT, SCREW_RADIUS, SCREW_HALF)
    return surface


def files():
    """{file name: text} of this instrument."""
    description = f"""
Vascular clamp with soft inserts, {LENGTH:.0f} mm long, in metres, open. Closed, the ends of the
jaws meet at the origin; handle towards +Z; the jaws turn in the Y-Z plane about the screw. The
parts whose names begin with JawUpper and JawLower are wide open: viewers turn them about the screw
as the jaws close.
"""
    opening = """
Inflow clamp. Lengths in metres, in the frame of inflow_clamp.iv: where the ends of the jaws meet at
the origin, the handle towards +Z; the jaws move in the Y-Z plane.
"""
    entries = [
        *instrument_entries(
            "Inflow clamp",
            "inflow_clamp",
            "Vascular clamp with soft jaws; shuts off the inflow of the liver at its hilum",
            "Where the ends of the jaws meet (m).",
        ),
        *jaw_entries(PIVOT, OPENING),
    ]
    materials = {
        "JawUpper": STEEL,
        "JawUpperInsert": SILICONE,
        "JawLower": STEEL,
        "JawLowerInsert": SILICONE,
        "Screw": STEEL,
    }
    before = both_opened(OPENING, PIVOT, [part for part in materials if part.startswith("Jaw")])
    return {
        "inflow_clamp.iv": model_text(description, build(), materials, before=before),
        "inflow_clamp.toml": description_text(opening, entries),
    }
