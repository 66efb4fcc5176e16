"""The handpiece of an ultrasonic surgical aspirator: a hollow titanium tip in a silicone flue, a
nose cone, a thick grip, the tube that brings water to the flue, and the beginnings of the suction
hose and the cable. Millimetres."""

from description import description_text, instrument_entries
from inventor import Material, model_text
from shapes.loft import circle, close_end, close_start, loft
from shapes.surface import Surface
from shapes.tubing import tube

LENGTH = 186.0
SIDES = 24
BORE = 0.6  # radius
BORE_DEPTH = 5.0  # what can be seen of it
FLUE_START = 6.0  # the tip stands out of the flue by this
GAP_DEPTH = 3.0  # of the gap between tip and flue, through which the water comes

# z against the radius of the skin, from the bottom of the bore forwards and back over the outside
HOLLOW = ((BORE_DEPTH, BORE), (0.0, BORE))
TIP = ((0.0, 0.92), (0.08, 1.0), (3.0, 1.06), (FLUE_START, 1.12), (FLUE_START + GAP_DEPTH, 1.18))
GAP = ((FLUE_START + GAP_DEPTH, 1.7), (FLUE_START + 0.15, 1.7))
FLUE = (
    (FLUE_START, 1.85),
    (FLUE_START, 2.1),
    (FLUE_START + 0.2, 2.25),
    (14.0, 2.35),
    (28.0, 2.6),
    (44.0, 3.0),
    (56.0, 3.5),
    (62.0, 4.1),
    (67.0, 5.1),
    (71.0, 5.9),
    (75.0, 6.3),
    (80.0, 6.5),
)
NOSE = (
    (80.0, 7.3),
    (80.5, 7.8),
    (84.0, 8.3),
    (84.4, 8.0),
    (85.4, 8.0),
    (85.8, 8.5),
    (90.0, 9.7),
    (95.0, 10.9),
    (99.0, 11.5),
    (100.0, 11.4),
)
GROOVES = 7
FIRST_GROOVE = 104.0
GROOVE_PITCH = 3.0
GROOVE_DEPTH = 0.5
GRIP_RADIUS = 12.0
CAP = (
    (156.0, 11.6),
    (156.2, 11.2),
    (157.2, 11.2),
    (157.5, 11.7),
    (162.0, 11.5),
    (164.5, 10.6),
    (165.6, 9.4),
    (166.0, 8.0),
)

# Middle lines in the Y-Z plane, or beside it for the cable: points and radii.
WATER = ((6.0, 86.0), (8.2, 89.0), (10.6, 93.0), (12.0, 98.0), (12.5, 104.0), (12.5, 130.0))
WATER += ((12.5, 158.0), (12.3, 170.0), (11.6, 178.0), (10.4, LENGTH - 0.5))
WATER_RADIUS = 1.6
SUCTION = ((-4.1, 163.0), (-4.1, 172.0), (-4.1, 172.2), (-4.2, 178.0), (-4.7, LENGTH - 0.5))
SUCTION_RADII = (2.9, 2.9, 3.7, 3.7, 3.7)
CABLE = ((3.4, 163.0), (3.4, 172.0), (3.4, 172.2), (3.3, 178.0), (2.9, LENGTH))
CABLE_RADII = (3.4, 3.1, 2.5, 2.5, 2.5)

TITANIUM = Material((0.66, 0.65, 0.63), (0.70, 0.69, 0.67), 0.45)
STEEL = Material((0.62, 0.63, 0.65), (0.65, 0.65, 0.67), 0.4)
SILICONE = Material((0.56, 0.72, 0.80), (0.11, 0.11, 0.11), 0.3)
GRIP = Material((0.55, 0.60, 0.64), (0.10, 0.10, 0.10), 0.2)
CLEAR = Material((0.76, 0.80, 0.80), (0.11, 0.11, 0.11), 0.3)
BLUE = Material((0.15, 0.40, 0.66), (0.10, 0.10, 0.11), 0.2)
BLACK = Material((0.09, 0.09, 0.10), (0.10, 0.10, 0.10), 0.15)
DARK = Material((0.02, 0.02, 0.022), (0.02, 0.02, 0.02), 0.05)


def grip_profile():
    """z against radius: a rounded front, grooves for the fingers, then smooth."""
    profile = [(100.2, 11.7), (101.0, GRIP_RADIUS)]
    for k in range(GROOVES):
        z = FIRST_GROOVE + k * GROOVE_PITCH
        profile += [(z, GRIP_RADIUS), (z + 0.5 * GROOVE_PITCH, GRIP_RADIUS - GROOVE_DEPTH)]
    last = FIRST_GROOVE + GROOVES * GROOVE_PITCH
    return profile + [(last, GRIP_RADIUS), (140.0, GRIP_RADIUS), (155.2, GRIP_RADIUS)]


def build_handpiece(surface):
    """One skin from the bottom of the bore over tip, flue, nose and grip to the end of the cap."""
    sections = (
        ("Bore", HOLLOW),
        ("Tip", TIP),
        ("Bore", GAP),
        ("Flue", FLUE),
        ("Nose", NOSE),
        ("Grip", grip_profile()),
        ("Cap", CAP),
    )
    rings, parts = [], []
    for part, profile in sections:
        for z, radius in profile:
            rings.append([(x, y, z) for x, y in circle(SIDES, radius)])
            parts.append(part)

    def label(row, column):
        if row < 0:
            return ("Bore", "floor") if row == -1 else ("Cap", "end")
        # The band between two sections belongs to the hinder one, except at the mouth's rim.
        part = parts[row + 1]
        return (part, (part, row < len(HOLLOW) + len(TIP)))

    close_start(surface, rings[0], (0.0, 0.0, BORE_DEPTH), label)
    loft(surface, rings, label)
    close_end(surface, rings[-1], (0.0, 0.0, CAP[-1][0]), label)


def build():
    """The handpiece, its tubes and its cable, closed shells that overlap."""
    surface = Surface(unit=0.001)
    build_handpiece(surface)
    water = [(0.0, y, z) for y, z in WATER]
    tube(surface, "Water", water, [WATER_RADIUS] * len(water), 10)
    suction = [(0.0, y, z) for y, z in SUCTION]
    tube(surface, "Suction", suction, SUCTION_RADII, 14, ("SuctionBore", 2.5, 3.0))
    tube(surface, "Cable", [(0.0, y, z) for y, z in CABLE], CABLE_RADII, 12)
    return surface


def files():
    """{file name: text} of this instrument."""
    description = f"""
Handpiece of an ultrasonic aspirator, {LENGTH:.0f} mm long, in metres. The middle of the mouth of
its hollow tip is at the origin, the handle towards +Z; the tube for water lies along the grip on
the side of +Y. Closed shells that overlap.
"""
    opening = """
Ultrasonic aspirator. Lengths in metres, in the frame of aspirator.iv: the middle of the mouth of
the hollow tip at the origin, the handle towards +Z. The mouth lies in the plane z = 0.
"""
    entries = [
        *instrument_entries(
            "Ultrasonic aspirator",
            "aspirator",
            "Ultrasonic aspirator; breaks up and draws off parenchyma and leaves vessels standing",
            "Middle of the mouth of the hollow tip (m).",
        ),
        (
            "contact_radius",
            0.0012,
            "Little more than the tip's radius: what touches lies this close to the mouth (m).",
        ),
    ]
    materials = {
        "Tip": TITANIUM,
        "Bore": DARK,
        "Flue": SILICONE,
        "Nose": STEEL,
        "Grip": GRIP,
        "Cap": BLACK,
        "Water": BLUE,
        "Suction": CLEAR,
        "SuctionBore": DARK,
        "Cable": BLACK,
    }
    return {
        "aspirator.iv": model_text(description, build(), materials),
        "aspirator.toml": description_text(opening, entries),
    }
