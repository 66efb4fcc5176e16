"""Hoses and cables: round tubes along a path in a plane x = constant. Millimetres."""

from shapes.jaws import middle
from shapes.loft import circle, close_end, close_start, loft
from shapes.vector import add, scale, subtract, unit


def tube_rings(path, radii, sides):
    """Rings across the path [(x, y, z), ...] with one radius for each point; at a corner the ring
    halves the angle."""
    rings = []
    for k, (centre, radius) in enumerate(zip(path, radii)):
        first, last = max(k - 1, 0), min(k + 1, len(path) - 1)
        steps = [unit(subtract(path[i + 1], path[i])) for i in range(first, last)]
        along = unit(add(steps[0], steps[-1]))
        up = (0.0, along[2], -along[1])
        rings.append([add(centre, (u, v * up[1], v * up[2])) for u, v in circle(sides, radius)])
    return rings


def tube(surface, part, path, radii, sides=12, bore=None):
    """A closed tube. `bore`: (part, radius, depth) of the hollow that is seen in its end."""
    rings = tube_rings(path, radii, sides)
    close_start(surface, rings[0], middle(rings[0]), lambda row, column: (part, "start"))
    loft(surface, rings, lambda row, column: (part, "body"))
    end = path[-1]
    if bore is None:
        close_end(surface, rings[-1], end, lambda row, column: (part, "end"))
        return
    inner, radius, depth = bore
    deep = subtract(end, scale(unit(subtract(end, path[-2])), depth))
    hollow = [tube_rings([path[-2], p], [radius, radius], sides)[1] for p in (end, deep)]
    loft(surface, [rings[-1], hollow[0]], lambda row, column: (part, "end"))
    loft(surface, hollow, lambda row, column: (inner, "wall"))
    close_end(surface, hollow[1], deep, lambda row, column: (inner, "floor"))
