"""Checks that a list of triangles is a closed, outward-oriented solid. Slow and obvious."""

import math


def subtract(a, b):
    return tuple(x - y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def length(a):
    return math.sqrt(dot(a, a))


def weld(positions, grid=1e-8):
    """Index of each position among the distinct ones; equal means equal after rounding to
    `grid`."""
    index = {}
    return [index.setdefault(tuple(round(x / grid) for x in p), len(index)) for p in positions]


def unmatched_edges(faces):
    """Directed edges that do not occur exactly once, or whose opposite does not: empty for a closed
    oriented surface."""
    count = {}
    for a, b, c in faces:
        for edge in ((a, b), (b, c), (c, a)):
            count[edge] = count.get(edge, 0) + 1
    return [e for e, n in count.items() if n != 1 or count.get((e[1], e[0]), 0) != 1]


def shells(faces):
    """The faces grouped into connected pieces: list of lists of face numbers."""
    root = {}

    def find(p):
        while root.setdefault(p, p) != p:
            root[p] = root[root[p]]
            p = root[p]
        return p

    for a, b, c in faces:
        root[find(b)] = find(a)
        root[find(c)] = find(a)
    groups = {}
    for number, face in enumerate(faces):
        groups.setdefault(find(face[0]), []).append(number)
    return list(groups.values())


def area(triangle):
    a, b, c = triangle
    return 0.5 * length(cross(subtract(b, a), subtract(c, a)))


def volume(triangles):
    return sum(dot(a, cross(b, c)) for a, b, c in triangles) / 6.0


def winding_number(point, triangles):
    """1 inside, 0 outside (van Oosterom and Strackee, 1983); other values where a surface overlaps
    itself."""
    total = 0.0
    for triangle in triangles:
        a, b, c = (subtract(p, point) for p in triangle)
        la, lb, lc = length(a), length(b), length(c)
        total += math.atan2(
            dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb
        )
    return total / (2.0 * math.pi)


def distance_to_triangle(p, triangle):
    """Distance from p to the nearest point of the triangle: its plane's foot when inside, else its
    nearest side."""
    a, b, c = triangle
    n = cross(subtract(b, a), subtract(c, a))
    sides = ((a, b), (b, c), (c, a))
    if all(dot(cross(subtract(e, s), subtract(p, s)), n) >= 0.0 for s, e in sides):
        return abs(dot(subtract(p, a), n)) / length(n)
    return min(_distance_to_segment(p, s, e) for s, e in sides)


def _distance_to_segment(p, s, e):
    along = subtract(e, s)
    t = min(max(dot(subtract(p, s), along) / dot(along, along), 0.0), 1.0)
    return length(tuple(x - y - t * z for x, y, z in zip(p, s, along)))


def distance(p, triangles):
    """Distance from p to the nearest triangle; those whose bounding box is farther than the best so
    far are skipped."""
    best = math.inf
    for triangle in triangles:
        box = [max(min(axis) - x, x - max(axis), 0.0) for x, axis in zip(p, zip(*triangle))]
        if dot(box, box) < best * best:
            best = min(best, distance_to_triangle(p, triangle))
    return best
