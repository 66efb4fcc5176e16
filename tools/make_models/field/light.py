"""How much of the room's light arrives at each place of the scenery: ambient occlusion over its height
map, worked out once and written into the colours."""

import math

CELL = 0.004


class HeightMap:
    def __init__(self, sheets):
        self.top = {}
        for sheet in sheets:
            if sheet.part in ("steel", "dome"):
                continue
            for row, following in zip(sheet.rows, sheet.rows[1:]):
                for j in range(len(row) - 1):
                    self._fill(row[j], row[j + 1], following[j], following[j + 1])

    def _fill(self, a, b, c, d):
        longest = max(math.dist(a, b), math.dist(a, c), math.dist(b, d))
        if a[0] ** 2 + a[2] ** 2 > 0.16:
            return
        n = max(1, math.ceil(longest / CELL))
        for i in range(n + 1):
            for j in range(n + 1):
                u, v = i / n, j / n
                p = [
                    (1 - u) * ((1 - v) * a[k] + v * b[k]) + u * ((1 - v) * c[k] + v * d[k])
                    for k in range(3)
                ]
                key = (math.floor(p[0] / CELL), math.floor(p[2] / CELL))
                if p[1] > self.top.get(key, -9.0):
                    self.top[key] = p[1]

    def height(self, x, z):
        """Between the middles of four cells."""
        u, v = x / CELL - 0.5, z / CELL - 0.5
        i, j = math.floor(u), math.floor(v)
        u, v = u - i, v - j
        a, b = self.top.get((i, j), -0.02), self.top.get((i + 1, j), -0.02)
        c, d = self.top.get((i, j + 1), -0.02), self.top.get((i + 1, j + 1), -0.02)
        return (a + (b - a) * u) * (1.0 - v) + (c + (d - c) * u) * v


DIRECTIONS = [(math.cos(math.pi * k / 6), math.sin(math.pi * k / 6)) for k in range(12)]
STEPS = (0.006, 0.011, 0.018, 0.028, 0.042, 0.062, 0.09)


def light_over(sheets):
    """light(point, normal) for sheet_text()."""
    heights = HeightMap(sheets)

    def light(p, normal):
        if p[0] ** 2 + p[2] ** 2 > 0.12:
            return 1.0
        x, y, z = (p[k] + 0.002 * normal[k] for k in range(3))
        seen = 0.0
        for c, s in DIRECTIONS:
            steepest = 0.0
            for step in STEPS:
                rise = (heights.height(x + step * c, z + step * s) - y - 0.001) / step
                steepest = max(steepest, rise)
            seen += 1.0 - steepest / math.sqrt(1.0 + steepest * steepest)
        seen /= len(DIRECTIONS)
        over = heights.height(x, z) - y
        seen *= 1.0 - 0.55 * min(max((over - 0.003) / 0.006, 0.0), 1.0)  # something lies on it
        return 0.30 + 0.70 * seen

    return light
