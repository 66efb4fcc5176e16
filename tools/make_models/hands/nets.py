"""Triangles on the surface where a distance is zero: a point in every cell that the surface passes
(surface nets, after Gibson 1998), then moved onto the surface along the gradient."""

import math

BLOCK = 4  # cells along each side of what is looked at together
CORNERS = [(i, j, k) for i in (0, 1) for j in (0, 1) for k in (0, 1)]
EDGES = [(a, b) for a in range(8) for b in range(a + 1, 8) if (a ^ b) in (1, 2, 4)]
STEP = 0.4  # of the differences that make the gradient, so wide that creases are soft


def gradient(distance, p):
    """Unit vector in which the distance grows."""
    x, y, z = p
    g = (
        distance(x + STEP, y, z) - distance(x - STEP, y, z),
        distance(x, y + STEP, z) - distance(x, y - STEP, z),
        distance(x, y, z + STEP) - distance(x, y, z - STEP),
    )
    size = math.sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2])
    return tuple(c / size for c in g)


def _samples(body, axes):
    """{(i, j, k): distance} at the grid's points near the surface, and {(i, j, k): body} that
    counts round them."""
    values = {}
    starts = [range(0, len(axis) - 1, BLOCK) for axis in axes]
    bodies = {}
    for i in starts[0]:
        for j in starts[1]:
            for k in starts[2]:
                low = [axis[n] for axis, n in zip(axes, (i, j, k))]
                ends = [min(n + BLOCK, len(axis) - 1) for axis, n in zip(axes, (i, j, k))]
                high = [axis[n] for axis, n in zip(axes, ends)]
                middle = [0.5 * (a + b) for a, b in zip(low, high)]
                reach = 0.5 * math.dist(low, high)
                if abs(body.distance(*middle)) > 1.25 * reach + 4.0:
                    continue
                few = body.near(*middle, reach)
                bodies[i, j, k] = few
                for a in range(i, ends[0] + 1):
                    for b in range(j, ends[1] + 1):
                        for c in range(k, ends[2] + 1):
                            if (a, b, c) not in values:
                                values[a, b, c] = few.distance(axes[0][a], axes[1][b], axes[2][c])
    return values, bodies


def polygonise(body, axes, rounds=2):
    """Points, unit normals and triangles (counterclockwise from outside). `axes`: the grid's places
    along x, y and z."""
    values, bodies = _samples(body, axes)
    cells, points, normals = {}, [], []
    for cell in sorted(values):
        corners = [tuple(n + s for n, s in zip(cell, shift)) for shift in CORNERS]
        if any(corner not in values for corner in corners):
            continue
        heights = [values[corner] for corner in corners]
        inside = sum(h < 0.0 for h in heights)
        if inside in (0, 8):
            continue
        crossings = []
        for a, b in EDGES:
            if (heights[a] < 0.0) != (heights[b] < 0.0):
                t = heights[a] / (heights[a] - heights[b])
                ends = [[axis[n] for axis, n in zip(axes, corners[e])] for e in (a, b)]
                crossings.append([p + t * (q - p) for p, q in zip(*ends)])
        point = tuple(sum(axis) / len(crossings) for axis in zip(*crossings))
        few = bodies[tuple(n - n % BLOCK for n in cell)].distance
        for _ in range(rounds):
            up, height = gradient(few, point), few(*point)
            point = tuple(p - height * u for p, u in zip(point, up))
        cells[cell] = len(points)
        points.append(point)
        normals.append(gradient(few, point))
    return points, normals, list(_triangles(values, cells, points))


def _triangles(values, cells, points):
    """Two for every edge of the grid through which the surface passes."""
    for corner in sorted(values):
        for axis in range(3):
            end = tuple(n + (k == axis) for k, n in enumerate(corner))
            if end not in values or (values[corner] < 0.0) == (values[end] < 0.0):
                continue
            u, v = (axis + 1) % 3, (axis + 2) % 3
            around = []
            for back_u, back_v in ((1, 1), (0, 1), (0, 0), (1, 0)):
                cell = list(corner)
                cell[u] -= back_u
                cell[v] -= back_v
                around.append(cells[tuple(cell)])
            if values[corner] >= 0.0:
                around.reverse()
            a, b, c, d = around
            if math.dist(points[a], points[c]) <= math.dist(points[b], points[d]):
                yield from ((a, b, c), (a, c, d))
            else:
                yield from ((a, b, d), (b, c, d))
