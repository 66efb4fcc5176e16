"""Skins over rows of rings: the one way in which all the round things here are made.

A ring is a closed row of points, right-handed about the direction of travel from ring to ring. All
rings of a skin have the same number of points; ring[i] of one is joined to ring[i] of the next, so
the skin's normals point outwards. `label(row, column)` returns (part, smooth) for the band between
rings row and row + 1, points column and column + 1; row is -1 for the fan that closes the start and
-2 for the one that closes the end. Where it returns None, the quad is left out.
"""

import math


def plain(row, column):
    return ("all", 0)


def loft(surface, rings, label=plain):
    """Quads between consecutive rings. The two ends stay open."""
    indices = [[surface.point(p) for p in ring] for ring in rings]
    for row, (here, there) in enumerate(zip(indices, indices[1:])):
        count = len(here)
        for i in range(count):
            j = (i + 1) % count
            found = label(row, i)
            if found:
                surface.quad(here[i], here[j], there[j], there[i], *found)


def close_start(surface, ring, apex, label=plain):
    """A fan from `apex` that closes the skin before its first ring."""
    _fan(surface, list(reversed(ring)), apex, lambda i: label(-1, (len(ring) - 2 - i) % len(ring)))


def close_end(surface, ring, apex, label=plain):
    """A fan from `apex` that closes the skin after its last ring."""
    _fan(surface, ring, apex, lambda i: label(-2, i))


def _fan(surface, ring, apex, label):
    centre = surface.point(apex)
    indices = [surface.point(p) for p in ring]
    for i, here in enumerate(indices):
        surface.triangle(centre, here, indices[(i + 1) % len(indices)], *label(i))


def widen(surface, ring, wider, part="all", smooth=0):
    """Joins a ring of n points to one of 2n points (wider[2i] belongs to ring[i]): three triangles
    for each point."""
    inner = [surface.point(p) for p in ring]
    outer = [surface.point(p) for p in wider]
    for i, here in enumerate(inner):
        j = (i + 1) % len(inner)
        first, middle, last = outer[2 * i], outer[2 * i + 1], outer[(2 * i + 2) % len(outer)]
        surface.triangle(here, middle, first, part, smooth)
        surface.triangle(here, inner[j], middle, part, smooth)
        surface.triangle(inner[j], last, middle, part, smooth)


def circle(count, half_width, half_height=None):
    """`count` points (x, y) of an ellipse, counterclockwise from +x."""
    half_height = half_width if half_height is None else half_height
    angles = [2.0 * math.pi * i / count for i in range(count)]
    return [(half_width * math.cos(a), half_height * math.sin(a)) for a in angles]


def smoothstep(low, high, x):
    """0 below `low`, 1 above `high`, smooth in between."""
    t = min(max((x - low) / (high - low), 0.0), 1.0)
    return t * t * (3.0 - 2.0 * t)


def through(knots, x):
    """The value at x of a smooth curve through `knots` [(x, value), ...]; monotone between knots
    (Fritsch and Carlson, 1980), so a handle drawn by a few widths never bulges between them.
    Constant outside."""
    if x <= knots[0][0]:
        return knots[0][1]
    if x >= knots[-1][0]:
        return knots[-1][1]
    steps = [(b[1] - a[1]) / (b[0] - a[0]) for a, b in zip(knots, knots[1:])]
    slopes = [0.0]
    for left, right in zip(steps, steps[1:]):
        slopes.append(0.0 if left * right <= 0.0 else 2.0 * left * right / (left + right))
    slopes.append(0.0)
    k = max(i for i in range(len(knots) - 1) if knots[i][0] <= x)
    (x0, y0), (x1, y1) = knots[k], knots[k + 1]
    h = x1 - x0
    t = (x - x0) / h
    return (
        y0 * (1 + 2 * t) * (1 - t) ** 2
        + h * slopes[k] * t * (1 - t) ** 2
        + y1 * t * t * (3 - 2 * t)
        + h * slopes[k + 1] * t * t * (t - 1)
    )
