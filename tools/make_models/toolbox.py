"""The tool box: a stainless instrument tray with a rolled rim, lined with a cloth that has three
lanes for instruments."""

import math

from inventor import Material, model_text
from shapes.loft import close_end, close_start, loft
from shapes.outline import arcs, grid, square
from shapes.surface import Surface

HALF_WIDTH = 0.150  # over the rim
HALF_DEPTH = 0.110
HEIGHT = 0.025
CORNER = 0.024
WALL = 0.001
FLANGE = 0.006  # how far the rim reaches out over the wall
FILLET = 0.006
DRAFT = 0.003  # the wall leans out by this much from bottom to top
LANES = (-0.085, 0.0, 0.085)  # x of the instruments' axes, which lie along z

CLOTH_HALF_WIDTH = 0.131
CLOTH_HALF_DEPTH = 0.092
CLOTH_THICKNESS = 0.0015
RIDGE = 0.004  # height of the padded folds between the lanes

STAINLESS = Material((0.64, 0.65, 0.67), (0.7, 0.7, 0.72), 0.35)
LINEN = Material((0.15, 0.31, 0.37), (0.04, 0.05, 0.05), 0.05)


def profile():
    """(inset from the rim's outer border, y) of the wall's section from the middle of the bottom
    outside, over the rim, to the floor inside, and which stretch is one smooth face."""
    wall = FLANGE  # inset of the wall's outer side at the top
    foot = wall + DRAFT
    points = [(0.06, 0.0, "bottom"), (foot + FILLET, 0.0, "bottom")]
    for angle in (30.0, 60.0, 90.0):
        a = math.radians(angle)
        points.append((foot + FILLET * (1.0 - math.sin(a)), FILLET * (1.0 - math.cos(a)), "bottom"))
    roll = 0.0022
    points.append((wall, HEIGHT - 2.0 * roll, "outside"))
    points.append((roll, HEIGHT - 2.0 * roll, "under rim"))
    for angle in (45.0, 90.0, 135.0, 180.0):
        a = math.radians(angle)
        points.append((roll * (1.0 - math.sin(a)), HEIGHT - roll - roll * math.cos(a), "rim"))
    points.append((wall + 0.2 * roll, HEIGHT, "rim"))
    points.append((wall + WALL, HEIGHT - 0.8 * roll, "rim"))
    inside = foot + WALL
    radius = FILLET - 0.5 * WALL
    for angle in (0.0, 30.0, 60.0, 90.0):
        a = math.radians(angle)
        points.append(
            (inside + radius * (1.0 - math.cos(a)), WALL + radius * (1.0 - math.sin(a)), "inside")
        )
    points.append((0.06, WALL, "inside"))
    return points


def tray(surface):
    """Rings seen from above turn from +z to +x, as a skin that climbs the outside must."""
    rings = []
    for inset, y, _ in profile():
        corner = max(CORNER - inset, 0.004)
        outline = arcs(HALF_WIDTH - inset, HALF_DEPTH - inset, corner, (4, 3), 6)
        rings.append([(a, y, b) for a, b in reversed(outline)])
    names = [name for _, _, name in profile()]

    def label(row, column):
        return ("tray", names[row + 1] if row >= 0 else ("bottom" if row == -1 else "inside"))

    close_start(surface, rings[0], (0.0, 0.0, 0.0), label)
    loft(surface, rings, label)
    close_end(surface, rings[-1], (0.0, WALL, 0.0), label)


def cloth_height(x, z):
    """Top of the lining: flat lanes, soft ridges halfway between them, and a slight wrinkle."""
    between = 0.5 * (LANES[1] + LANES[2])
    ridge = sum(math.exp(-(((x - side) / 0.009) ** 2)) for side in (-between, between))
    wrinkle = 0.0004 * math.sin(61.0 * x + 23.0 * z) * math.sin(47.0 * z + 1.0)
    return WALL + 0.0003 + CLOTH_THICKNESS + RIDGE * ridge + wrinkle


def lining(surface):
    """A closed thin shell that lies 0.3 mm above the tray's floor."""
    columns, rows = 36, 10
    directions = square(columns, rows)

    def top(u, v):
        x, z = u * CLOTH_HALF_WIDTH, v * CLOTH_HALF_DEPTH
        return (x, cloth_height(x, z), z)

    grid(surface, columns, rows, top, "lining", "top")
    border = [top(u, v) for u, v in directions]
    lower = [(x, WALL + 0.0003, z) for x, _, z in border]
    label = lambda row, column: ("lining", "side" if row == 0 else "under")
    loft(surface, [border, lower], label)
    close_end(surface, lower, (0.0, WALL + 0.0003, 0.0), label)


def build():
    """Tray and lining: two closed surfaces that do not touch."""
    surface = Surface(decimals=6)
    tray(surface)
    lining(surface)
    return surface


def files():
    """{file name: text} of the tool box."""
    floor = 1000.0 * (WALL + 0.0003 + CLOTH_THICKNESS)
    description = f"""
Tool box: stainless instrument tray of {2 * HALF_WIDTH:.2f} x {2 * HALF_DEPTH:.2f} x {HEIGHT:.3f} m,
lined with a cloth; in metres. The origin is the middle of its bottom. Three instruments lie in it
along z at x = {LANES[0]}, 0 and {LANES[2]}, on the cloth at y = {floor:.1f} mm; folds of the cloth
keep them apart. Two closed surfaces: tray and lining.
"""
    materials = {"tray": STAINLESS, "lining": LINEN}
    return {"toolbox.iv": model_text(description, build(), materials, decimals=6)}
