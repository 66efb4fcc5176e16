"""Greedy triangle strips, in the order in which a TriangleStripSet consumes its vertices.

A strip v0 v1 v2 v3 ... stands for the triangles (v0, v1, v2), (v2, v1, v3), (v2, v3, v4), ...:
every second one is flipped.
"""


def make_strips(triangles):
    """Strips that together contain each of `triangles` (3-tuples of hashable corners) once, with
    its orientation.

    From the first unused triangle the longest of its three strips is taken. Corners are equal only
    when position and normal are, so a strip ends at a crease.
    """
    by_edge = {}
    for number, (a, b, c) in enumerate(triangles):
        for edge in ((a, b), (b, c), (c, a)):
            by_edge.setdefault(edge, number)
    used = [False] * len(triangles)
    strips = []
    for number, (a, b, c) in enumerate(triangles):
        if used[number]:
            continue
        candidates = [
            _follow(start, number, triangles, by_edge, used)
            for start in ((a, b, c), (b, c, a), (c, a, b))
        ]
        strip, members = max(candidates, key=lambda found: len(found[0]))
        for member in members:
            used[member] = True
        strips.append(strip)
    return strips


def _follow(start, number, triangles, by_edge, used):
    strip = list(start)
    members = [number]
    taken = {number}
    while True:
        edge = (strip[-1], strip[-2]) if len(members) % 2 else (strip[-2], strip[-1])
        following = by_edge.get(edge)
        if following is None or used[following] or following in taken:
            return strip, members
        strip.append(next(corner for corner in triangles[following] if corner not in edge))
        members.append(following)
        taken.add(following)
