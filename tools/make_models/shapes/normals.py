"""One normal per triangle corner: averaged over the neighbours that belong to the same smooth
face."""

import math

from shapes.vector import add, dot, length, scale, subtract, unit


def corner_normals(surface, crease_degrees=50.0, decimals=4):
    """For each triangle three unit normals, rounded to `decimals`.

    Two triangles at a point share a normal when their smooth labels agree and their faces meet at
    less than the crease angle. Neighbours weigh by area times corner angle, so wide flat faces stay
    flat beside narrow rounded ones.
    """
    faces = [unit(surface.area_vector(t)) for t in surface.triangles]
    around = {}
    for number, triangle in enumerate(surface.triangles):
        for point in triangle:
            around.setdefault(point, []).append(number)
    limit = math.cos(math.radians(crease_degrees))
    result = []
    for number, triangle in enumerate(surface.triangles):
        corners = []
        for point in triangle:
            total = (0.0, 0.0, 0.0)
            for other in around[point]:
                same = surface.smooth[other] == surface.smooth[number]
                if other == number or (same and dot(faces[other], faces[number]) > limit):
                    total = add(total, scale(faces[other], _weight(surface, other, point)))
            corners.append(tuple(round(x, decimals) + 0.0 for x in unit(total)))
        result.append(corners)
    return result


def _weight(surface, number, point):
    triangle = surface.triangles[number]
    k = triangle.index(point)
    here, next_, last = (surface.points[triangle[(k + i) % 3]] for i in range(3))
    cosine = dot(unit(subtract(next_, here)), unit(subtract(last, here)))
    return length(surface.area_vector(triangle)) * math.acos(min(max(cosine, -1.0), 1.0))
