"""What of the operative field stops tissue: the wall round the opening, as one closed mesh. It follows the drawn
surfaces within 3 mm (test/inventor/field/field_body_test.cpp), without the relief that a distance grid of some millimetres
cannot hold. Gauze pads and steel blades are left out. So are stomach and colon: they would have to give way."""

from field.opening import angles, rim, skin_height
from field.viscera import floor_point
from field.wall import COLUMNS, DRAPE_ROWS, SECTION, drape_edge, drape_point, edge_point
from plain_mesh import plain_mesh
from shapes.loft import loft
from shapes.surface import Surface

OUTERMOST = 0.15  # metres outside the rim: so far the drape is an obstacle
BOTTOM = -0.02  # below the table's top, which is an obstacle of its own
# Of SECTION: what is seen of it from inside. The rest lies in the folds between the layers, which
# are too narrow for tissue.
SEEN = [
    ("skin", 0.003), ("skin", 0.001), ("fat", 0.0005), ("fat", -0.003), ("fat", -0.0055), ("fat", -0.0065),
    ("fat", -0.006), ("fat", -0.004), ("muscle", 0.000), ("muscle", -0.002), ("muscle", -0.0035),
    ("muscle", -0.003), ("muscle", -0.0005),
]
FLOOR = [1.0 - 0.02 * k for k in range(20)]  # of the way from the middle to the rim


def wall():
    """A ring whose section runs over the drape from its outer border to the opening, down the layers, over the
    floor that rises to them, and back below."""
    turn = angles(COLUMNS)
    drape = [k for k, out in enumerate(DRAPE_ROWS) if k > 0 and out <= OUTERMOST]
    rings = [[drape_point(k, a) for a in turn] for k in reversed(drape)]
    rings.insert(0, [(x, BOTTOM, z) for x, y, z in rings[0]])
    rings.append([(x, skin_height(a) - 0.0005, z) for a in turn for x, z in [rim(a, drape_edge(1, a))]])
    done = set()
    for layer, out in SEEN:
        below = next(b for o, b, name in SECTION if (name, o) == (layer, out) and (name, o, b) not in done)
        done.add((layer, out, below))
        rings.append([edge_point(layer, out, below, a, relief=False) for a in turn])
    for u in FLOOR:
        rings.append([floor_point(u, a, relief=False) for a in turn])
    rings.append([(p[0], BOTTOM, p[2]) for p in rings[-1]])
    surface = Surface(decimals=5)
    loft(surface, rings + rings[:1])
    return surface


def files():
    """{file name: bytes} of the wall."""
    return {"field_wall.ply": plain_mesh(wall())}

