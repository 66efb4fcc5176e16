"""Blades that hold the wound open, of steel: two under the ribs."""

import math

from field.opening import rim, skin_height
from field.sheet import Sheet
from shapes.loft import through

STEEL = (0.50, 0.52, 0.54)  # matt, so as not to dazzle
# Along the blade from its lip in the cavity over the rim and away: (metres outside the rim, metres
# above the skin, half the width).
PATH = [
    (-0.021, -0.040, 0.019), (-0.018, -0.043, 0.021), (-0.0135, -0.041, 0.022), (-0.012, -0.035, 0.0225),
    (-0.012, -0.026, 0.0225), (-0.012, -0.014, 0.0225), (-0.0115, -0.003, 0.0225), (-0.009, 0.005, 0.022),
    (-0.003, 0.010, 0.021), (0.006, 0.013, 0.018), (0.016, 0.0155, 0.012), (0.026, 0.019, 0.0085),
    (0.06, 0.033, 0.0065), (0.12, 0.060, 0.0065), (0.20, 0.098, 0.0065), (0.34, 0.165, 0.0065),
]


def thickness(half_width):
    """Half of it: the blade is a sheet, the handle a bar."""
    return 0.0011 + 0.0030 * max(1.0 - half_width / 0.0125, 0.0)


def blade(angle):
    """One blade at this place of the rim, as a closed band."""
    x0, z0 = rim(angle)
    x1, z1 = rim(angle, 0.01)
    nx, nz = (x1 - x0) / 0.01, (z1 - z0) / 0.01
    base = skin_height(angle)
    rows = []
    for k, (out, up, half) in enumerate(PATH):
        a, b = PATH[max(k - 1, 0)], PATH[min(k + 1, len(PATH) - 1)]
        step = math.hypot(b[0] - a[0], b[1] - a[1])
        across = (-(b[1] - a[1]) / step, (b[0] - a[0]) / step)  # of the sheet: (out, up)
        row = []
        outline = []
        for u in (-1.0, -0.985, -0.93, -0.5, 0.0, 0.5, 0.93, 0.985, 1.0):
            outline.append((u, {1.0: 0.0, 0.985: 0.75}.get(abs(u), 1.0)))
        outline += [(u, -t) for u, t in reversed(outline) if abs(u) < 0.99]
        for u, t in outline:
            o, y = out + thickness(half) * t * across[0], up + thickness(half) * t * across[1]
            row.append((x0 + o * nx - u * half * nz, base + y, z0 + o * nz + u * half * nx))
        rows.append(row)
    return Sheet("steel", rows, lambda p, i, j: STEEL)


def blades():
    return [blade(math.radians(d)) for d in (-128.0, -52.0)]
