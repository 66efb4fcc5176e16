"""The tool box: a stainless instrument tray with a rolled rim, lined with a cloth that has three
lanes for instruments; and a tray of the same make, lower and larger, for eight more."""

import math
from dataclasses import dataclass

from inventor import Material, model_text
from shapes.loft import close_end, close_start, loft
from shapes.outline import arcs, grid, square
from shapes.surface import Surface

CORNER = 0.024
WALL = 0.001
FLANGE = 0.006  # how far the rim reaches out over the wall
FILLET = 0.006
DRAFT = 0.003  # the wall leans out by this much from bottom to top

BORDER = 0.018  # from the rim to the cloth
CLOTH_THICKNESS = 0.0015
RIDGE = 0.004  # height of the padded folds between the lanes

STAINLESS = Material((0.64, 0.65, 0.67), (0.7, 0.7, 0.72), 0.35)
LINEN = Material((0.15, 0.31, 0.37), (0.04, 0.05, 0.05), 0.05)


@dataclass(frozen=True)
class Tray:
    """Sizes over the rim, m, and the places of the folds between the instruments."""

    half_width: float
    half_depth: float
    height: float
    folds: tuple  # x
    columns: int  # of the cloth's grid
    rows: int


TOOL_BOX = Tray(0.150, 0.110, 0.025, (-0.0425, 0.0425), 36, 10)
TRAY = Tray(0.102, 0.212, 0.014, (-0.045, 0.0, 0.045), 36, 20)


def profile(height):
    """(inset from the rim's outer border, y) of the wall's section from the middle of the bottom
    outside, over the rim, to the floor inside, and which stretch is one smooth face."""
    wall = FLANGE  # inset of the wall's outer side at the top
    foot = wall + DRAFT
    points = [(0.06, 0.0, "bottom"), (foot + FILLET, 0.0, "bottom")]
    for angle in (30.0, 60.0, 90.0):
        a = math.radians(angle)
        points.append((foot + FILLET * (1.0 - math.sin(a)), FILLET * (1.0 - math.cos(a)), "bottom"))
    roll = 0.0022
    points.append((wall, height - 2.0 * roll, "outside"))
    points.append((roll, height - 2.0 * roll, "under rim"))
    for angle in (45.0, 90.0, 135.0, 180.0):
        a = math.radians(angle)
        points.append((roll * (1.0 - math.sin(a)), height - roll - roll * math.cos(a), "rim"))
    points.append((wall + 0.2 * roll, height, "rim"))
    points.append((wall + WALL, height - 0.8 * roll, "rim"))
    inside = foot + WALL
    radius = FILLET - 0.5 * WALL
    for angle in (0.0, 30.0, 60.0, 90.0):
        a = math.radians(angle)
        points.append(
            (inside + radius * (1.0 - math.cos(a)), WALL + radius * (1.0 - math.sin(a)), "inside")
        )
    points.append((0.06, WALL, "inside"))
    return points


def shell(surface, size):
    """Rings seen from above turn from +z to +x, as a skin that climbs the outside must."""
    rings = []
    for inset, y, _ in profile(size.height):
        corner = max(CORNER - inset, 0.004)
        outline = arcs(size.half_width - inset, size.half_depth - inset, corner, (4, 3), 6)
        rings.append([(a, y, b) for a, b in reversed(outline)])
    names = [name for _, _, name in profile(size.height)]

    def label(row, column):
        return ("tray", names[row + 1] if row >= 0 else ("bottom" if row == -1 else "inside"))

    close_start(surface, rings[0], (0.0, 0.0, 0.0), label)
    loft(surface, rings, label)
    close_end(surface, rings[-1], (0.0, WALL, 0.0), label)


def cloth_height(x, z, folds):
    """Top of the lining: flat lanes, soft ridges halfway between them, and a slight wrinkle."""
    ridge = sum(math.exp(-(((x - side) / 0.009) ** 2)) for side in folds)
    wrinkle = 0.0004 * math.sin(61.0 * x + 23.0 * z) * math.sin(47.0 * z + 1.0)
    return WALL + 0.0003 + CLOTH_THICKNESS + RIDGE * ridge + wrinkle


def lining(surface, size):
    """A closed thin shell that lies 0.3 mm above the tray's floor."""
    directions = square(size.columns, size.rows)

    def top(u, v):
        x, z = u * (size.half_width - BORDER - 0.001), v * (size.half_depth - BORDER)
        return (x, cloth_height(x, z, size.folds), z)

    grid(surface, size.columns, size.rows, top, "lining", "top")
    border = [top(u, v) for u, v in directions]
    lower = [(x, WALL + 0.0003, z) for x, _, z in border]
    label = lambda row, column: ("lining", "side" if row == 0 else "under")
    loft(surface, [border, lower], label)
    close_end(surface, lower, (0.0, WALL + 0.0003, 0.0), label)


def build(size):
    """Tray and lining: two closed surfaces that do not touch."""
    surface = Surface(decimals=6)
    shell(surface, size)
    lining(surface, size)
    return surface


def described(name, size, instruments):
    """What the file says of itself."""
    floor = 1000.0 * (WALL + 0.0003 + CLOTH_THICKNESS)
    return f"""
{name}: stainless instrument tray of {2 * size.half_width:.2f} x {2 * size.half_depth:.2f} x {size.height:.3f} m,
lined with a cloth; in metres. The origin is the middle of its bottom. {instruments}, on the cloth
at y = {floor:.1f} mm; folds of the cloth keep them apart. Two closed surfaces: tray and lining.
"""


def files():
    """{file name: text} of the tool box and the tray."""
    materials = {"tray": STAINLESS, "lining": LINEN}
    three = described("Tool box", TOOL_BOX, "Three instruments lie in it along z at x = -0.085, 0 and 0.085")
    eight = described("Tray", TRAY, "Eight instruments lie in it along z, in two rows of four")
    return {
        "toolbox.iv": model_text(three, build(TOOL_BOX), materials, decimals=6),
        "tray.iv": model_text(eight, build(TRAY), materials, decimals=6),
    }
