"""What of the operative field stops tissue: the wall round the opening, the stomach and the colon, each as one
closed mesh. They follow the drawn surfaces within 3 mm (test/inventor/field_body_test.cpp), without the relief
that a distance grid of some millimetres cannot hold. Gauze pads and steel blades are left out."""

from field.opening import angles, rim, skin_height
from field.viscera import colon, floor_point, stomach
from field.wall import COLUMNS, DRAPE_ROWS, SECTION, drape_edge, drape_point, edge_point
from plain_mesh import plain_mesh
from shapes.loft import close_end, close_start, loft
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


def tube(sheet, row_step, column_step):
    """The drawn tube with fewer points, closed at its ends."""
    rows = sheet.rows[::row_step]
    if rows[-1] is not sheet.rows[-1]:
        rows.append(sheet.rows[-1])
    rings = [row[:-1][::column_step] for row in rows]
    surface = Surface(decimals=5)
    middle = [tuple(sum(p[k] for p in ring) / len(ring) for k in range(3)) for ring in (rings[0], rings[-1])]
    close_start(surface, rings[0], middle[0])
    loft(surface, rings)
    close_end(surface, rings[-1], middle[1])
    return surface


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
    """{file name: bytes} of the parts."""
    parts = {"wall": wall(), "stomach": tube(stomach(), 2, 2), "colon": tube(colon(), 2, 2)}
    return {f"field_{name}.ply": plain_mesh(surface) for name, surface in parts.items()}

