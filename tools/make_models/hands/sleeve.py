"""The gown's sleeve, and the rolled edge of the glove's cuff that lies over it. Millimetres, in the
hand's frame."""

import math

from field.noise import noise
from hands.glove import CUFF_END, forearm_point
from shapes.loft import close_end, close_start, loft, smoothstep, through
from shapes.surface import Surface

COLUMNS = 36
EDGE = CUFF_END + 0.9  # of the rolled edge's middle line, along the forearm
EDGE_RADIUS = 1.7
EDGE_SIDES = 8
# From the wrist along the forearm against how far the cloth is outside the glove's cuff: within the
# cuff it is tight, behind it the gown is wide.
CLOTH = ((46.0, -5.0), (58.0, -3.4), (66.0, -0.8), (68.5, 2.4), (70.0, 4.0), (73.0, 5.6))
CLOTH += ((80.0, 7.6), (96.0, 8.6), (160.0, 10.0), (320.0, 18.0))
STATIONS = (50.0, 58.0, 64.0, 66.5, 68.5, 70.5, 73.5, 77.0, 81.0, 86.0, 92.0, 98.0, 105.0, 112.0)
STATIONS += (120.0, 128.0, 137.0, 146.0, 156.0, 167.0, 178.0, 190.0, 203.0, 217.0, 232.0, 248.0)
STATIONS += (266.0, 285.0, 305.0)


def angles():
    """Round the forearm so that rings towards the elbow have their front outside."""
    return [2.0 * math.pi * k / COLUMNS for k in range(COLUMNS)]


def cuff_radius(body, grip, out, angle):
    """From the forearm's middle to the glove there."""
    low, high = 5.0, 60.0
    for _ in range(24):
        radius = 0.5 * (low + high)
        point = forearm_point(grip, out, radius * math.cos(angle), radius * math.sin(angle))
        if body.distance(*point) < 0.0:
            low = radius
        else:
            high = radius
    return high


def fold(angle, out):
    """How far the cloth stands out: folds aslant along the arm, and gathers at the cuff."""
    place = (40.0 * math.cos(angle), 40.0 * math.sin(angle), out)
    far = smoothstep(66.0, 95.0, out)
    drift = 1.3 * noise(place, 70.0, 21)
    aslant = math.sin(2.0 * angle + 0.050 * out + 2.0 * drift)
    aslant = aslant * abs(aslant) ** 0.5
    around = math.sin(0.125 * out + 1.1 * math.sin(angle + 0.8) + 2.2 * drift)
    near = smoothstep(66.0, 78.0, out) * (1.0 - smoothstep(110.0, 190.0, out))
    gathers = math.sin(11.0 * angle + 3.0 * drift) * (1.0 - smoothstep(84.0, 112.0, out))
    folds = 2.4 * far * aslant + 2.6 * near * around + far * 2.2 * noise(place, 30.0, 22)
    return folds + 0.9 * smoothstep(66.0, 74.0, out) * gathers


def sleeve(body, grip):
    """The cloth, closed at both ends."""
    surface = Surface(decimals=4)
    cuff = [cuff_radius(body, grip, 58.0, a) for a in angles()]
    rings = []
    for out in STATIONS:
        ring = []
        for a, radius in zip(angles(), cuff):
            radius += through(CLOTH, out) + fold(a, out)
            ring.append(forearm_point(grip, out, radius * math.cos(a), radius * math.sin(a)))
        rings.append(ring)
    close_start(surface, rings[0], forearm_point(grip, STATIONS[0], 0.0, 0.0))
    loft(surface, rings)
    close_end(surface, rings[-1], forearm_point(grip, STATIONS[-1], 0.0, 0.0))
    return surface


def rolled_edge(body, grip):
    """A ring of rubber round the end of the cuff."""
    surface = Surface(decimals=4)
    rings = []
    for a in angles():
        middle = cuff_radius(body, grip, EDGE, a)
        ring = []
        for k in range(EDGE_SIDES):
            turn = 2.0 * math.pi * k / EDGE_SIDES
            radius = middle + EDGE_RADIUS * math.cos(turn)
            out = EDGE - EDGE_RADIUS * math.sin(turn)
            ring.append(forearm_point(grip, out, radius * math.cos(a), radius * math.sin(a)))
        rings.append(ring)
    loft(surface, rings + rings[:1])
    return surface
