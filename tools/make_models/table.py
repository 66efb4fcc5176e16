"""The operating table: a slab under a green drape that hangs over its border in soft folds, and a
darker cloth on top."""

import math

from inventor import Material, model_text
from shapes.loft import close_end, loft, smoothstep, widen
from shapes.outline import grid, rounded, square
from shapes.surface import Surface

HALF_WIDTH = 0.45
HALF_DEPTH = 0.30
CORNER = 0.07
BORDER_ROUNDING = 0.018
HANG = 0.30  # the hem lies this far below the top
CLOTH_HALF_WIDTH = 0.23
CLOTH_HALF_DEPTH = 0.17
SEAM_DEPTH = 0.0015
COLUMNS = 22
ROWS = 16

DRAPE = Material((0.10, 0.36, 0.30), (0.03, 0.05, 0.05), 0.05)
CLOTH = Material((0.06, 0.24, 0.21), (0.02, 0.04, 0.04), 0.05)


def fold(turn, corner):
    """How far the hanging drape stands out at `turn` of the way round (0..1), in 0..1; fuller at
    the corners."""
    t = 2.0 * math.pi * turn
    wave = 0.5 + 0.26 * math.sin(17.0 * t + 0.9 * math.sin(3.0 * t))
    wave += 0.17 * math.sin(26.0 * t + 1.3) + 0.07 * math.sin(11.0 * t)
    return max(wave, 0.0) * (0.75 + 0.5 * corner)


def gathered(directions):
    """The same directions, three times denser at the corners of the square, where the drape
    turns."""
    return [
        (0.35 * u * (3.0 - u * u) + 0.3 * u, 0.35 * v * (3.0 - v * v) + 0.3 * v)
        for u, v in directions
    ]


def turns(outline):
    """How far round the outline each of its points lies, 0..1."""
    steps = [math.dist(p, q) for (p, _), (q, _) in zip(outline, outline[1:] + outline[:1])]
    return [sum(steps[:k]) / sum(steps) for k in range(len(steps))]


def flat_ring(directions, half_width, half_depth, radius, y):
    return [(a, y, b) for (a, b), _ in rounded(directions, half_width, half_depth, radius)]


def hanging_ring(directions, outset, y):
    """The drape at height y, `outset` inside (negative) or outside the slab's border; folds open
    towards the hem."""
    ring = []
    opened = smoothstep(0.0, 1.3 * HANG, -y - BORDER_ROUNDING)
    outline = rounded(directions, HALF_WIDTH, HALF_DEPTH, CORNER)
    for turn, ((a, b), (na, nb)) in zip(turns(outline), outline):
        corner = 2.0 * abs(na * nb)
        out = outset + opened * (0.012 + 0.05 * fold(turn, corner) + 0.02 * corner)
        ring.append((a + out * na, y - 0.004 * opened * corner, b + out * nb))
    return ring


def build():
    """Cloth and drape as one closed surface, whose flat top is at y = 0."""
    surface = Surface(decimals=5)
    coarse = square(COLUMNS, ROWS)
    fine = gathered(square(2 * COLUMNS, 2 * ROWS))

    def cloth_point(u, v):
        return (u * CLOTH_HALF_WIDTH, 0.0, v * CLOTH_HALF_DEPTH)

    grid(surface, COLUMNS, ROWS, cloth_point, "cloth", "top")
    seam = [
        flat_ring(coarse, CLOTH_HALF_WIDTH + out, CLOTH_HALF_DEPTH + out, 0.0, y)
        for out, y in ((0.0, 0.0), (0.001, -SEAM_DEPTH), (0.003, -SEAM_DEPTH), (0.004, 0.0))
    ]
    loft(surface, seam, lambda row, column: ("cloth" if row < 1 else "drape", ("seam", row)))
    outer = HALF_WIDTH - BORDER_ROUNDING
    inner = HALF_DEPTH - BORDER_ROUNDING
    middle = flat_ring(
        coarse, 0.5 * (CLOTH_HALF_WIDTH + outer), 0.5 * (CLOTH_HALF_DEPTH + inner), 0.02, 0.0
    )
    border = flat_ring(fine, outer, inner, CORNER - BORDER_ROUNDING, 0.0)
    loft(surface, [seam[-1], middle], lambda row, column: ("drape", "drape"))
    widen(surface, middle, border, "drape", "drape")

    rings = [border]
    for angle in (30.0, 60.0, 90.0):
        a = math.radians(angle)
        rings.append(
            hanging_ring(
                fine, BORDER_ROUNDING * (math.sin(a) - 1.0), BORDER_ROUNDING * (math.cos(a) - 1.0)
            )
        )
    for share in (0.08, 0.2, 0.35, 0.52, 0.7, 0.86, 1.0):
        rings.append(hanging_ring(fine, 0.0, -BORDER_ROUNDING - share * (HANG - BORDER_ROUNDING)))
    loft(surface, rings, lambda row, column: ("drape", "drape"))
    hem = [rings[-1], [(0.8 * x, -HANG + 0.01, 0.8 * z) for x, y, z in rings[-1]]]
    loft(surface, hem, lambda row, column: ("drape", "under"))
    close_end(surface, hem[-1], (0.0, -HANG + 0.01, 0.0), lambda row, column: ("drape", "under"))
    return surface


def files():
    """{file name: text} of the table."""
    description = f"""
Operating table: slab of {2 * HALF_WIDTH:.1f} x {2 * HALF_DEPTH:.1f} m under a green drape; in
metres. A darker cloth lies where the organ will. The top is flat at y = 0 with the origin in its
middle; the drape hangs {HANG:.2f} m down. One closed surface.
"""
    materials = {"drape": DRAPE, "cloth": CLOTH}
    return {
        "table.iv": model_text(description, build(), materials, decimals=5, crease_degrees=70.0)
    }
