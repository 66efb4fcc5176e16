"""Smooth random numbers in space: the same on every machine."""

import math


def _hash(i, j, k, seed):
    """A whole number of 32 bits for a lattice point."""
    h = (i * 374761393 + j * 668265263 + k * 2147483647 + seed * 1274126177) & 0xFFFFFFFF
    h = ((h ^ (h >> 13)) * 1274126177) & 0xFFFFFFFF
    h = ((h ^ (h >> 16)) * 2246822519) & 0xFFFFFFFF
    return h ^ (h >> 15)


def _share(i, j, k, seed):
    return _hash(i, j, k, seed) / 4294967295.0


def noise(point, wavelength, seed=0):
    """Value noise, -1 to 1: smooth over `wavelength`."""
    x, y, z = (c / wavelength for c in point)
    i, j, k = math.floor(x), math.floor(y), math.floor(z)
    u, v, w = (t * t * (3.0 - 2.0 * t) for t in (x - i, y - j, z - k))
    total = 0.0
    for a, wa in ((0, 1.0 - u), (1, u)):
        for b, wb in ((0, 1.0 - v), (1, v)):
            for c, wc in ((0, 1.0 - w), (1, w)):
                total += wa * wb * wc * _share(i + a, j + b, k + c, seed)
    return 2.0 * total - 1.0


def lobules(point, size, seed=0):
    """Cushions side by side: 1 in the middle of each, 0 in the grooves between them (the distance
    between the two nearest of random points, Worley 1996). `size`: of a cushion."""
    x, y, z = (c / size for c in point)
    i, j, k = math.floor(x), math.floor(y), math.floor(z)
    first = second = 9.0
    for a in (-1, 0, 1):
        for b in (-1, 0, 1):
            for c in (-1, 0, 1):
                cell = (i + a, j + b, k + c)
                dx = cell[0] + _share(*cell, seed) - x
                dy = cell[1] + _share(*cell, seed + 1) - y
                dz = cell[2] + _share(*cell, seed + 2) - z
                distance = math.sqrt(dx * dx + dy * dy + dz * dz)
                if distance < first:
                    first, second = distance, first
                elif distance < second:
                    second = distance
    edge = min((second - first) / 0.45, 1.0)
    return edge * (2.0 - edge)
