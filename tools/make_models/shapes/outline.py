"""Rounded rectangles as rings, all sampled alike, so that one can be lofted to the next."""

import math


def square(columns, rows):
    """Directions on the border of the square [-1, 1]^2, from (1, -1) to (1, 1) and on round: 2
    (columns + rows) of them, `columns` steps along the first coordinate and `rows` along the
    second."""
    right = [(1.0, -1.0 + 2.0 * k / rows) for k in range(rows)]
    top = [(1.0 - 2.0 * k / columns, 1.0) for k in range(columns)]
    left = [(-1.0, 1.0 - 2.0 * k / rows) for k in range(rows)]
    bottom = [(-1.0 + 2.0 * k / columns, -1.0) for k in range(columns)]
    return right + top + left + bottom


def rounded(directions, half_width, half_depth, radius):
    """For each direction the point (a, b) of the rounded rectangle and its outward unit normal
    there."""
    result = []
    for u, v in directions:
        a, b = u * half_width, v * half_depth
        core_a = min(max(a, radius - half_width), half_width - radius)
        core_b = min(max(b, radius - half_depth), half_depth - radius)
        across = math.hypot(a - core_a, b - core_b)
        if radius == 0.0 or across == 0.0:
            normal = (
                (math.copysign(1.0, u), 0.0) if abs(u) >= abs(v) else (0.0, math.copysign(1.0, v))
            )
            result.append(((a, b), normal))
        else:
            normal = ((a - core_a) / across, (b - core_b) / across)
            result.append(((core_a + radius * normal[0], core_b + radius * normal[1]), normal))
    return result


def arcs(half_width, half_depth, radius, per_side, per_corner):
    """The same rounded rectangle by its corners: `per_corner` steps round each and per_side =
    (along a, along b) steps between them, so that corners are equally round at any size. Turns from
    +a to +b like the others.
    """
    result = []
    wide, deep = half_width - radius, half_depth - radius
    corners = ((wide, -deep), (wide, deep), (-wide, deep), (-wide, -deep))
    for k, (a, b) in enumerate(corners):
        for i in range(per_corner):
            angle = 0.5 * math.pi * (k - 1 + i / per_corner)
            result.append((a + radius * math.cos(angle), b + radius * math.sin(angle)))
        angle = 0.5 * math.pi * k
        start = (a + radius * math.cos(angle), b + radius * math.sin(angle))
        next_a, next_b = corners[(k + 1) % 4]
        steps = per_side[1] if k % 2 == 0 else per_side[0]
        for i in range(steps):
            share = i / steps
            result.append((start[0] + share * (next_a - a), start[1] + share * (next_b - b)))
    return result


def grid(surface, columns, rows, at, part, smooth):
    """A sheet of columns x rows quads that faces +Y; at(u, v) gives the point for u, v in -1..1 (u
    along x, v along z). Its border is square(columns, rows)."""
    index = [
        [
            surface.point(at(-1.0 + 2.0 * i / columns, -1.0 + 2.0 * k / rows))
            for i in range(columns + 1)
        ]
        for k in range(rows + 1)
    ]
    for k in range(rows):
        for i in range(columns):
            surface.quad(
                index[k][i], index[k + 1][i], index[k + 1][i + 1], index[k][i + 1], part, smooth
            )
