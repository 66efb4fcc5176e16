"""A scalpel: a No. 22 blade (large curved belly) on a flat No. 4 handle. Millimetres.

Every ring has 20 points, ten on each side of the Y-Z plane: 0 at the bottom (on the blade the
cutting edge), 10 at the top (the blade's back), and between them on the right side, x > 0:

    blade    1 grind line, 2 flat, 3-7 tongue of the handle that carries the blade, 8 flat, 9 back
    handle   1-3 lower rounded corner, 4-6 flat with the lengthwise hollow, 7-9 upper corner
"""

import math

from description import description_text, instrument_entries
from inventor import Material, model_text
from shapes.loft import close_end, close_start, loft, smoothstep, through
from shapes.surface import Surface

LENGTH = 165.0
MIDDLE = -3.0  # y of the handle's middle plane
BLADE_HALF_THICKNESS = 0.2  # a 0.4 mm blade
GRIND_HEIGHT = 1.5  # of the ground facet that tapers to the edge
BACK_HEIGHT = 1.2  # y of the blade's back behind its rise from the tip
BELLY_DEPTH = 8.0
BELLY_LENGTH = 29.0
HEEL = 40.6  # z of the blade's rear end at the height of the handle's middle
HEEL_SLANT = 0.41  # dz / dy of that end: the edge ends before the back
TONGUE_HALF_HEIGHT = 1.5

BLADE_STATIONS = (0.5, 1.3, 2.4, 4.0, 6.0, 8.5, 11.5, 15.0, 18.6)
TONGUE_STATIONS = ((19.2, 0.45), (20.2, 0.8), (22.0, 1.0), (25.0, 1.0), (29.0, 1.0), (33.2, 1.0))

# z and half height, z and half thickness of the handle
HALF_HEIGHT = (
    (42.0, 3.2),
    (48.0, 3.1),
    (70.0, 5.2),
    (98.0, 4.5),
    (140.0, 4.9),
    (150.0, 5.0),
    (165.0, 5.0),
)
HALF_THICKNESS = ((42.0, 1.35), (54.0, 1.65), (70.0, 2.0), (100.0, 1.9), (165.0, 1.6))
RIB_PITCH = 2.4
RIBS = 13
FIRST_RIB = 64.0
RIB_DEPTH = 0.4
HOLLOW = (104.0, 150.0)
END_RADIUS = 5.0  # of the handle's rounded end, seen from the side

STEEL = Material((0.66, 0.67, 0.69), (0.75, 0.75, 0.77), 0.45)
SATIN = Material((0.56, 0.57, 0.59), (0.45, 0.45, 0.46), 0.25)


def back(z):
    return BACK_HEIGHT * math.sin(0.5 * math.pi * min(z / 34.0, 1.0))


def edge(z):
    """y of the cutting edge: a steep nose, then the belly, then nearly straight to the heel."""
    t = min(z / BELLY_LENGTH, 1.0)
    straight = max(z - BELLY_LENGTH, 0.0)
    return -BELLY_DEPTH * (1.0 - (1.0 - t) ** 2.2) ** 0.68 + 0.02 * straight


def ring_of(half):
    """The 20 points from the 11 of the right half, bottom to top: mirrored in the Y-Z plane."""
    return half + [(-x, y, z) for x, y, z in reversed(half[1:-1])]


def blade_ring(z, raised=0.0):
    """Section at z; `raised` is how far the tongue stands out of the flats, 0..1."""
    low, high = edge(z), back(z)
    height = high - low
    thick = BLADE_HALF_THICKNESS * (0.35 + 0.65 * smoothstep(0.0, 6.0, z))
    grind = min(GRIND_HEIGHT, 0.3 * height)
    tongue = min(TONGUE_HALF_HEIGHT * (0.75 + 0.25 * raised), 0.22 * height)
    centre = 0.5 * (low + grind + high)
    middle = centre + (MIDDLE - centre) * smoothstep(6.0, 18.0, z)
    proud = thick + 0.55 * raised
    shape = [
        (0.0, low),
        (thick, low + grind),
        (thick, 0.5 * (low + grind + middle - tongue)),
        (thick, middle - tongue),
        (proud, middle - 0.7 * tongue),
        (proud, middle),
        (proud, middle + 0.7 * tongue),
        (thick, middle + tongue),
        (thick, 0.5 * (high + middle + tongue)),
        (thick, high),
        (0.0, high),
    ]
    return ring_of([(x, y, z) for x, y in shape])


def shoulder_ring(z, half_height, half_thickness, fin):
    """The handle's front end, slanted like the blade's heel. `fin` (y of edge and back) is the
    blade that still reaches out below and above."""
    thick = BLADE_HALF_THICKNESS
    low, high = MIDDLE - half_height, MIDDLE + half_height
    grind = min(GRIND_HEIGHT, 0.6 * (low - fin[0]))
    shape = [
        (0.0, fin[0]),
        (thick, fin[0] + grind),
        (thick, 0.5 * (fin[0] + grind + low)),
        (thick, low),
        (half_thickness, low + 0.4 * half_thickness),
        (half_thickness, MIDDLE),
        (half_thickness, high - 0.4 * half_thickness),
        (thick, high),
        (thick, 0.5 * (high + fin[1])),
        (thick, fin[1]),
        (0.0, fin[1]),
    ]
    return ring_of([(x, y, z + HEEL_SLANT * (y - MIDDLE)) for x, y in shape])


def handle_ring(z, half_height, half_thickness, pressed=0.0, hollow=0.0, slant=0.0):
    """A rectangle with rounded corners; `pressed` lowers the flats (a rib's groove), `hollow` only
    their middle; `slant` is dz / dy, as at the blade's heel."""
    corner = min(0.75 * half_thickness, 0.6 * half_height)
    right, inner, up = half_thickness - pressed, half_thickness - corner, half_height - corner
    bend = math.sqrt(0.5) * corner
    shape = [
        (0.0, -half_height),
        (inner, -half_height),
        (min(inner + bend, right), -up - bend),
        (right, -up),
        (right, -0.55 * up),
        (right - hollow, 0.0),
        (right, 0.55 * up),
        (right, up),
        (min(inner + bend, right), up + bend),
        (inner, half_height),
        (0.0, half_height),
    ]
    return ring_of([(x, MIDDLE + y, z + slant * y) for x, y in shape])


def handle_rings():
    rings, ribs = [], []

    def grow(z, pressed=0.0, hollow=0.0, slant=0.0):
        rings.append(
            handle_ring(
                z, through(HALF_HEIGHT, z), through(HALF_THICKNESS, z), pressed, hollow, slant
            )
        )
        ribs.append(pressed > 0.0)

    for z, slant in (
        (HEEL + 1.3, HEEL_SLANT),
        (46.0, 0.5 * HEEL_SLANT),
        (51.0, 0.0),
        (55.0, 0.0),
        (59.0, 0.0),
    ):
        grow(z, slant=slant)
    for k in range(RIBS):
        z = FIRST_RIB + k * RIB_PITCH
        grow(z)
        grow(z + 0.5 * RIB_PITCH, RIB_DEPTH)
    for z in (FIRST_RIB + RIBS * RIB_PITCH, HOLLOW[0]):
        grow(z)
    for z in (108.0, 120.0, 134.0, 146.0):
        grow(z, hollow=0.5)
    grow(HOLLOW[1])
    end = LENGTH - END_RADIUS
    for angle in (0.0, 25.0, 45.0, 62.0, 77.0):
        a = math.radians(angle)
        z = end + END_RADIUS * math.sin(a)
        rings.append(
            handle_ring(
                z,
                END_RADIUS * math.cos(a),
                through(HALF_THICKNESS, z) * (0.45 + 0.55 * math.cos(a)),
            )
        )
        ribs.append(False)
    return rings, ribs


def skin():
    """The rings from tip to end, and for each whether it lies in a rib's groove; and the row at
    which the blade ends."""
    blade = [blade_ring(z) for z in BLADE_STATIONS] + [
        blade_ring(z, raised) for z, raised in TONGUE_STATIONS
    ]
    fin = (edge(HEEL - 2.0), BACK_HEIGHT)
    blade += [
        shoulder_ring(HEEL - 2.6, 1.9, 0.8, fin),
        shoulder_ring(HEEL - 1.6, 2.9, 1.2, fin),
        shoulder_ring(HEEL, 3.0, 1.25, fin),
    ]
    neck = [shoulder_ring(HEEL + 0.12, 3.0, 1.27, (MIDDLE - 3.25, MIDDLE + 3.25))]
    handle, grooves = handle_rings()
    return blade + neck + handle, [False] * (len(blade) + 1) + grooves, len(blade) - 1


def build():
    """The scalpel as one closed surface with the parts `blade` and `handle`."""
    surface = Surface(unit=0.001)
    rings, grooves, heel = skin()

    def label(row, column):
        level = min(column, 19 - column)  # 0 beside the edge .. 9 beside the back, on either side
        of_blade = level < 3 or level > 6 or row < len(BLADE_STATIONS) - 1
        if row == -2:
            return ("handle", "end")
        if row < heel:
            if of_blade:
                return ("blade", "grind" if level == 0 else "flat")
            return (
                "handle",
                "tongue" if row < len(BLADE_STATIONS) + len(TONGUE_STATIONS) - 1 else "body",
            )
        if row == heel:
            return ("blade", "heel") if of_blade else ("handle", "body")
        ribbed = 2 <= level <= 7 and (grooves[row] or grooves[row + 1])
        return ("handle", ("rib", row) if ribbed else "body")

    close_start(surface, rings[0], (0.0, 0.0, 0.0), label)
    loft(surface, rings, label)
    close_end(surface, rings[-1], (0.0, MIDDLE, LENGTH), label)
    return surface


def cutting_edge():
    """The vertices of the edge from the tip to the heel, metres."""
    rings, _, heel = skin()
    edge_points = [(0.0, 0.0, 0.0)] + [ring[0] for ring in rings[: heel + 1]]
    return [tuple(0.001 * x for x in point) for point in edge_points]


def files():
    """{file name: text} of this instrument."""
    description = f"""
Scalpel: a No. 22 blade on a flat No. 4 handle, {LENGTH:.0f} mm long, in metres. Tip of the blade at
the origin, handle towards +Z, cutting edge towards -Y; the blade lies in the Y-Z plane. One closed
surface in two strip sets (blade and handle).
"""
    opening = """
Scalpel. Lengths in metres, in the frame of scalpel.iv: the tip at the origin, the handle towards
+Z, the cutting edge towards -Y; the blade lies in the Y-Z plane, so its flats face +X and -X.
"""
    entries = [
        *instrument_entries(
            "Scalpel",
            "scalpel",
            "No. 22 blade on a No. 4 handle; cuts with the belly of the blade",
            "Point of the blade (m).",
        ),
        (
            "edge",
            cutting_edge(),
            "Cutting edge from the tip over the belly to the heel: corners of a polyline (m).",
        ),
    ]
    materials = {"blade": STEEL, "handle": SATIN}
    return {
        "scalpel.iv": model_text(description, build(), materials),
        "scalpel.toml": description_text(opening, entries),
    }
