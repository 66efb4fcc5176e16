"""A triangle surface whose points are rounded and welded as they are added, so that what is written
is what is closed."""

from shapes.vector import cross, length, subtract


class Surface:
    """Points on a decimal grid, triangles counterclockwise seen from outside.

    Each triangle carries a `part` (which material it gets) and a `smooth` label: normals are
    averaged only over triangles with the same label, so two labels that meet make a visible line.
    """

    def __init__(self, unit=1.0, decimals=7):
        """Points are given in `unit` metres (0.001: millimetres) and stored in metres, rounded to
        `decimals` places."""
        self.points = []
        self.triangles = []
        self.parts = []
        self.smooth = []
        self._unit = unit
        self._decimals = decimals
        self._index = {}

    def point(self, position):
        """Index of the point at `position`; equal positions share one index."""
        key = tuple(round(x * self._unit, self._decimals) + 0.0 for x in position)
        if key not in self._index:
            self._index[key] = len(self.points)
            self.points.append(key)
        return self._index[key]

    def triangle(self, a, b, c, part="all", smooth=0):
        if a == b or b == c or c == a:
            raise ValueError(
                f"degenerate triangle at {self.points[a]}: two corners fall on one point"
            )
        self.triangles.append((a, b, c))
        self.parts.append(part)
        self.smooth.append(smooth)

    def quad(self, a, b, c, d, part="all", smooth=0):
        """Two triangles for the quadrilateral a b c d, split along a c unless b d is clearly
        shorter (equal splits make long strips)."""
        if self._distance(a, c) <= 1.02 * self._distance(b, d):
            self.triangle(a, b, c, part, smooth)
            self.triangle(a, c, d, part, smooth)
        else:
            self.triangle(a, b, d, part, smooth)
            self.triangle(b, c, d, part, smooth)

    def _distance(self, a, b):
        return length(subtract(self.points[a], self.points[b]))

    def area_vector(self, triangle):
        """Twice the triangle's area times its outward unit normal."""
        a, b, c = (self.points[i] for i in triangle)
        return cross(subtract(b, a), subtract(c, a))
