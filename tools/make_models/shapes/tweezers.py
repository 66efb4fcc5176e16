"""Arms as tweezers have them: of forceps that are held like a pen. Millimetres.
The two arms are one shape, turned by half a turn about the Z axis."""

from description import description_text, instrument_entries
from inventor import model_text
from shapes.jaws import both_opened, half_turned, jaw_entries, middle
from shapes.loft import close_end, close_start, loft, through
from shapes.outline import arcs
from shapes.surface import Surface

PIVOT = 156.0  # z: where the arms begin to bend
OPENING = 0.064  # rad between the arms when wide open: 10 mm between the tips
GAP = 0.005  # between the closed tips, each side of the plane y = 0
TIP = 9.0  # length of the tips

# z against the inner border (y), the thickness (y) and the half width (x) of the upper arm, closed
INNER = (
    (0.0, GAP),
    (5.5, GAP),
    (TIP, 0.25),
    (12.0, 0.5),
    (40.0, 1.9),
    (85.0, 4.9),
    (115.0, 5.2),
    (140.0, 3.2),
    (PIVOT, 0.9),
    (162.0, 0.7),
)
THICKNESS = (
    (0.0, 0.55),
    (0.5, 0.85),
    (1.2, 1.0),
    (12.0, 1.1),
    (40.0, 1.5),
    (85.0, 2.0),
    (120.0, 2.2),
    (162.0, 2.0),
)
HALF_WIDTH = (
    (0.0, 0.28),
    (0.5, 0.43),
    (1.2, 0.5),
    (12.0, 0.65),
    (40.0, 1.3),
    (70.0, 2.2),
    (88.0, 4.2),
    (98.0, 4.6),
    (124.0, 4.6),
    (145.0, 3.6),
    (162.0, 3.2),
)
TIP_STATIONS = (0.0, 0.2, 0.5, 1.2, 3.5, 5.5, TIP)
ARM_STATIONS = (TIP + 0.1, 12.0, 18.0, 26.0, 34.0, 42.0, 51.0, 60.0, 70.0, 76.0, 82.0, 88.0, 93.0)
RIBS = 8
FIRST_RIB = 96.0
RIB_PITCH = 3.2
RIB_DEPTH = 0.45  # only outside, where the fingers are
BACK_STATIONS = (122.0, 130.0, 138.0, 146.0, 154.0, 162.0)


def section(z, coat=0.0, pressed=0.0):
    """Ring of the upper arm across Z. `coat` widens it all round; `pressed` lowers its outside."""
    low = through(INNER, z) - coat
    high = through(INNER, z) + through(THICKNESS, z) + coat - pressed
    half_width, half_height = through(HALF_WIDTH, z) + coat, 0.5 * (high - low)
    radius = 0.8 * min(half_width, half_height)
    return [
        (x, 0.5 * (low + high) + y, z) for x, y in arcs(half_width, half_height, radius, (1, 1), 2)
    ]


def build_arm(surface, part, place, coat=0.0):
    """One arm, a closed skin: its tip, named `part` + "Tip", and the rest, whose coat is so thick."""
    tip = [section(z) for z in TIP_STATIONS]
    arm = [section(z, coat) for z in ARM_STATIONS]
    for k in range(RIBS):
        z = FIRST_RIB + k * RIB_PITCH
        arm += [section(z, coat), section(z + 0.5 * RIB_PITCH, coat, RIB_DEPTH)]
    arm += [section(z, coat) for z in BACK_STATIONS]
    rings = [[place(p) for p in ring] for ring in tip + arm]

    def label(row, column):
        if row == -1 or 0 <= row < len(tip) - 1:
            return (part + "Tip", "body")
        return (part, "front" if row == len(tip) - 1 else "end" if row == -2 else "body")

    close_start(surface, rings[0], middle(rings[0]), label)
    loft(surface, rings, label)
    close_end(surface, rings[-1], middle(rings[-1]), label)


def build(build_end, coat=0.0):
    """The tweezers closed: two arms, and what build_end(surface) adds where they meet."""
    surface = Surface(unit=0.001)
    build_arm(surface, "JawUpper", lambda p: p, coat)
    build_arm(surface, "JawLower", half_turned, coat)
    build_end(surface)
    return surface


def files(file, name, use, length, end, surface, materials, entries=()):
    """{file name: text}. use: a sentence; end: where the arms meet, as "plug"; entries: more lines of the
    description."""
    description = f"""
{name}, {length:.0f} mm long, in metres, open. Closed, the tips meet at the origin; handle
towards +Z; the arms turn in the Y-Z plane about a line in the {end}. The parts whose names begin
with JawUpper and JawLower are wide open: viewers turn them as the forceps close.
"""
    opening = f"""
{name}. Lengths in metres, in the frame of {file}.iv: the closed tips at the origin, the
handle towards +Z; the arms move in the Y-Z plane.
"""
    lines = [
        *instrument_entries(name, file, use, "Where the tips meet (m)."),
        *jaw_entries(
            PIVOT,
            OPENING,
            at=f"Where the arms bend, inside the {end} (m).",
            along="Unit vector of the line that the arms turn about.",
            between="Angle between the arms when wide open (rad).",
        ),
        *entries,
    ]
    before = both_opened(OPENING, PIVOT, [part for part in materials if part.startswith("Jaw")])
    return {
        f"{file}.iv": model_text(description, surface, materials, before=before),
        f"{file}.toml": description_text(opening, lines),
    }
