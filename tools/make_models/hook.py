"""A blunt surgical hook: round shaft, bend of 10 mm radius, flattened handle with grooves for the
fingers. Millimetres."""

import math

from description import description_text, instrument_entries
from inventor import Material, model_text
from shapes.loft import circle, close_end, close_start, loft, through
from shapes.surface import Surface

LENGTH = 180.0
SIDES = 16  # a multiple of 4: the outermost line of the bend is a line of vertices
BEND_RADIUS = 10.0  # of the centre line
BEND_DEGREES = 150.0  # from the shaft round to the point
WIRE = 1.5  # radius of the shaft where the bend begins
POINT_RADIUS = 0.9  # of the rounded point
BEND_STEPS = 20

# z against half height (y) and half thickness (x) behind the bend
HALF_HEIGHT = (
    (12.0, 1.5),
    (40.0, 1.75),
    (68.0, 2.0),
    (71.0, 2.0),
    (73.5, 3.4),
    (76.0, 3.4),
    (79.0, 2.6),
    (92.0, 4.6),
    (110.0, 5.0),
    (135.0, 4.2),
    (160.0, 5.2),
    (170.0, 5.4),
    (180.0, 5.4),
)
HALF_THICKNESS = (
    (12.0, 1.5),
    (40.0, 1.75),
    (68.0, 2.0),
    (71.0, 2.0),
    (73.5, 3.4),
    (76.0, 3.4),
    (79.0, 2.6),
    (92.0, 3.2),
    (110.0, 3.3),
    (135.0, 2.9),
    (165.0, 3.0),
    (180.0, 3.0),
)
SHAFT_STATIONS = (
    18.0,
    28.0,
    40.0,
    54.0,
    68.0,
    71.0,
    72.0,
    72.8,
    73.5,
    76.0,
    76.7,
    77.6,
    79.0,
    82.0,
    85.0,
    88.0,
)
GROOVES = 13
FIRST_GROOVE = 91.0
GROOVE_PITCH = 3.0
GROOVE_DEPTH = 0.45
BACK_STATIONS = (134.0, 142.0, 150.0, 158.0, 165.0, 170.0)
END_LENGTH = 7.0

STEEL = Material((0.62, 0.63, 0.65), (0.65, 0.65, 0.67), 0.4)


def wire_radius(degrees):
    """Radius of the hook at an angle of the bend (0 at the shaft): it thins evenly towards the
    point."""
    return WIRE + (POINT_RADIUS + 0.2 - WIRE) * degrees / BEND_DEGREES


# z of the bend's centre: its outside touches the plane z = 0 at the origin
BEND_CENTRE = BEND_RADIUS + wire_radius(90.0)


def bend_point(degrees):
    """Point of the centre line of the bend."""
    a = math.radians(degrees)
    return (0.0, BEND_RADIUS * math.cos(a), BEND_CENTRE - BEND_RADIUS * math.sin(a))


def bend_angles():
    """From the point to the shaft, degrees."""
    return [BEND_DEGREES * (1.0 - k / BEND_STEPS) for k in range(BEND_STEPS + 1)]


def towards_shaft(degrees):
    """Direction of the centre line there."""
    a = math.radians(degrees)
    return (0.0, math.sin(a), math.cos(a))


def section(centre, along, half_thickness, half_height):
    """Ring across the direction `along` in the Y-Z plane: half_thickness in x, half_height in the
    plane."""
    up = (0.0, along[2], -along[1])
    return [
        (x, centre[1] + y * up[1], centre[2] + y * up[2])
        for x, y in circle(SIDES, half_thickness, half_height)
    ]


def point_rings():
    """The rounded point: half an ellipsoid beyond the end of the bend. Returns its apex and its
    rings."""
    centre, along = bend_point(BEND_DEGREES), towards_shaft(BEND_DEGREES)
    radius = wire_radius(BEND_DEGREES)
    reach = 1.3 * radius

    def ahead(distance):
        return (0.0, centre[1] - distance * along[1], centre[2] - distance * along[2])

    rings = []
    for angle in (72.0, 54.0, 36.0, 18.0):
        a = math.radians(angle)
        rings.append(
            section(ahead(reach * math.sin(a)), along, radius * math.cos(a), radius * math.cos(a))
        )
    return ahead(reach), rings


def handle_ring(z, pressed=0.0):
    factor = 1.0 - pressed / through(HALF_HEIGHT, z)
    centre = (0.0, BEND_RADIUS, z)
    thickness = through(HALF_THICKNESS, z) - pressed
    return section(centre, (0.0, 0.0, 1.0), thickness, factor * through(HALF_HEIGHT, z))


def build():
    """The hook as one closed surface."""
    surface = Surface(unit=0.001)
    apex, rings = point_rings()
    for angle in bend_angles():
        radius = wire_radius(angle)
        rings.append(section(bend_point(angle), towards_shaft(angle), radius, radius))
    rings += [handle_ring(z) for z in SHAFT_STATIONS]
    first_groove = len(rings)
    for k in range(GROOVES):
        z = FIRST_GROOVE + k * GROOVE_PITCH
        rings += [handle_ring(z), handle_ring(z + 0.5 * GROOVE_PITCH, GROOVE_DEPTH)]
    rings.append(handle_ring(FIRST_GROOVE + GROOVES * GROOVE_PITCH))
    last_groove = len(rings) - 1
    rings += [handle_ring(z) for z in BACK_STATIONS]
    for angle in (20.0, 40.0, 58.0, 75.0):
        a = math.radians(angle)
        z = LENGTH - END_LENGTH * (1.0 - math.sin(a))
        rings.append(
            section(
                (0.0, BEND_RADIUS, z),
                (0.0, 0.0, 1.0),
                through(HALF_THICKNESS, z) * math.cos(a),
                through(HALF_HEIGHT, z) * math.cos(a),
            )
        )

    def label(row, column):
        return ("all", ("groove", row) if first_groove <= row < last_groove else "body")

    close_start(surface, rings[0], apex, label)
    loft(surface, rings, label)
    close_end(surface, rings[-1], (0.0, BEND_RADIUS, LENGTH), label)
    return surface


def centre_line():
    """Centre line of the hook from its point to the shaft, metres."""
    return [tuple(0.001 * x for x in bend_point(angle)) for angle in bend_angles()]


def files():
    """{file name: text} of this instrument."""
    description = f"""
Blunt surgical hook, {LENGTH:.0f} mm long, in metres. The front of the bend touches the origin,
handle towards +Z. The hook opens towards -Y: it is bent in the Y-Z plane from the shaft (y = 0.010)
down through the origin to the point. One closed surface.
"""
    opening = """
Hook. Lengths in metres, in the frame of hook.iv: the front of the bend at the origin, the handle
towards +Z. It opens towards -Y: bent in the Y-Z plane, from the shaft at y = 0.010 through the
origin to the point, which looks back to the hand.
"""
    apex, _ = point_rings()
    entries = [
        *instrument_entries(
            "Hook",
            "hook",
            "Blunt hook with a bend of 10 mm radius; catches and pulls tissue",
            "Foremost point of the bend, on its outside (m).",
        ),
        ("point", tuple(0.001 * x for x in apex), "The rounded point in which the hook ends (m)."),
        (
            "hook",
            centre_line(),
            "Centre line of the bend from the point to the shaft: corners of a polyline (m).",
        ),
        ("slip_force", 2.0, "Beyond this pull it lets go of what it has caught (N)."),
    ]
    return {
        "hook.iv": model_text(description, build(), {"all": STEEL}),
        "hook.toml": description_text(opening, entries),
    }
