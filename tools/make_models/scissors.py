"""Dissecting scissors: two slim blades that turn about a screw, long shanks, two finger rings.
Millimetres. The two halves are one shape, turned by half a turn about the Z axis."""

from description import description_text, instrument_entries
from inventor import Material, model_text
from shapes.jaws import both_opened, finger_ring, half_turned, jaw_entries, middle, screw
from shapes.loft import close_end, close_start, loft, through
from shapes.surface import Surface

LENGTH = 168.0
PIVOT = 46.0  # z of the screw
EDGE = 41.0  # length of the edges from the tip
OPENING = 0.5  # rad between the edges when wide open
GAP = 0.005  # between the two halves, each side of the plane x = 0

# z against the lower and upper border (y) and the thickness (x) of the upper half, closed
LOWER = (
    (0.0, 0.0),
    (EDGE, 0.0),
    (PIVOT, -4.4),
    (52.0, -5.4),
    (62.0, -5.2),
    (95.0, -7.6),
    (122.0, -11.6),
    (142.0, -15.2),
)
UPPER = (
    (0.0, 0.7),
    (3.0, 2.0),
    (12.0, 3.4),
    (32.0, 4.9),
    (40.0, 5.0),
    (PIVOT, 4.2),
    (52.0, 1.5),
    (62.0, -1.0),
    (95.0, -3.4),
    (122.0, -7.4),
    (142.0, -11.0),
)
THICKNESS = (
    (0.0, 0.7),
    (12.0, 1.3),
    (40.0, 2.2),
    (PIVOT, 2.6),
    (62.0, 3.0),
    (122.0, 3.2),
    (142.0, 3.2),
)
STATIONS = (
    (0.0, 1.0, 3.0, 7.0, 12.0, 18.0, 25.0, 32.0, 37.0, EDGE, 42.5, 44.0, PIVOT, 48.0, 50.0, 52.0)
    + (56.0, 62.0, 70.0, 82.0, 95.0, 108.0, 122.0, 133.0, 142.0)
)
BLADE_ROWS = STATIONS.index(EDGE)

RING_CENTRE = (-14.2, 153.5)  # y, z
RING_HALF = (10.4, 12.6)  # of the tube's centre line, y and z
RING_TUBE = (1.7, 2.0)  # radii across (x) and in the plane of the ring
RING_STEPS, TUBE_STEPS = 28, 10

SCREW_RADIUS = 3.0
SCREW_HALF = 3.1  # x of its slightly domed heads

STEEL = Material((0.62, 0.63, 0.65), (0.65, 0.65, 0.67), 0.4)


def section(z):
    """Ring of the upper half across Z: flat inside, bevelled to the edge along the blade."""
    low, high, thick = through(LOWER, z), through(UPPER, z), through(THICKNESS, z)
    # From a keen edge to the rounded border of the shank.
    blunt = min(max((z - EDGE) / (PIVOT - EDGE), 0.0), 1.0)
    keen = 0.08 + (0.62 * thick - 0.08) * blunt
    bevel = min(1.4, 0.5 * (high - low))
    round_off = min(0.35 * thick, 0.3 * (high - low))
    y_bevel = low + bevel + (round_off - bevel) * blunt
    outline = [
        (0.0, low + (0.4 * round_off) * blunt),
        (keen, low),
        (thick, y_bevel),
        (thick, high - round_off),
        (thick - round_off, high),
        (0.5 * round_off, high),
        (0.0, high - 0.5 * round_off),
        (0.0, 0.5 * (low + high)),
    ]
    return [(GAP + x, y, z) for x, y in outline]


def build_half(surface, part, turned):
    """One half: a skin from tip to shank and a ring that overlaps its end. `turned`: by half a turn
    about Z."""

    def place(p):
        return half_turned(p) if turned else p

    rings = [[place(p) for p in section(z)] for z in STATIONS]

    def label(row, column):
        flat = column in (6, 7)
        bevel = column == 1 and row < BLADE_ROWS
        return (part, "inside" if flat else "bevel" if bevel else "outside")

    close_start(surface, rings[0], middle(rings[0]), label)
    loft(surface, rings, label)
    close_end(surface, rings[-1], middle(rings[-1]), label)

    centre = (GAP + RING_TUBE[0], *RING_CENTRE)
    finger_ring(surface, part, place, centre, RING_HALF, RING_TUBE, (RING_STEPS, TUBE_STEPS))


def build():
    """The scissors closed: two halves and the screw, each a closed surface or several that
    overlap."""
    surface = Surface(unit=0.001)
    build_half(surface, "JawUpper", turned=False)
    build_half(surface, "JawLower", turned=True)
    screw(surface, PIVOT, SCREW_RADIUS, SCREW_HALF)
    return surface


def files():
    """{file name: text} of this instrument."""
    description = f"""
Dissecting scissors, {LENGTH:.0f} mm long, in metres, open. Closed, the tip is at the origin; handle
towards +Z; the blades turn in the Y-Z plane about the screw. The parts JawUpper and JawLower are
wide open: viewers turn them about the screw as the scissors close.
"""
    opening = """
Scissors. Lengths in metres, in the frame of scissors.iv: the closed tip at the origin, the handle
towards +Z; the blades move in the Y-Z plane.
"""
    steps = 6
    edge = [(0.0, 0.0, 0.001 * EDGE * k / steps) for k in range(steps + 1)]
    entries = [
        *instrument_entries(
            "Scissors",
            "scissors",
            "Dissecting scissors; part what is between the blades as they close",
            "Where the points meet (m).",
        ),
        ("edge", edge, "Where both edges lie when closed, from the tip to the heel (m)."),
        *jaw_entries(
            PIVOT,
            OPENING,
            at="The screw that the blades turn about (m).",
            between="Angle between the edges when wide open (rad).",
        ),
    ]
    before = both_opened(OPENING, PIVOT, ("JawUpper", "JawLower"))
    materials = {part: STEEL for part in ("JawUpper", "JawLower", "Screw")}
    return {
        "scissors.iv": model_text(description, build(), materials, before=before),
        "scissors.toml": description_text(opening, entries),
    }
