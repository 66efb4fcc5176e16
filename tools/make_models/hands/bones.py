"""The skeleton of a right hand of an adult (glove size 7.5). Millimetres.

The hand's frame: the origin in the middle of the wrist's crease, +X to the little finger's side,
+Y along the middle finger, +Z out of the back of the hand.
"""

import math

from shapes.vector import add, dot, scale, subtract, unit

WRIST = (0.0, 0.0, 0.0)
FINGERS = ("index", "middle", "ring", "little")
# Where the fingers begin: the middles of the knuckles.
KNUCKLE = {
    "index": (-28.0, 84.0, 1.0),
    "middle": (-7.5, 87.0, 3.5),
    "ring": (12.0, 81.5, 2.0),
    "little": (29.5, 72.5, -3.0),
}
# Of the three bones, the last to the middle of the fingertip's rounding.
BONES = {
    "index": (42.0, 25.0, 15.5),
    "middle": (46.0, 28.5, 16.5),
    "ring": (43.0, 27.0, 16.5),
    "little": (34.0, 20.0, 15.0),
}
# With the glove, at the knuckle, at both joints and at the tip.
RADII = {
    "index": (10.3, 9.5, 8.5, 7.3),
    "middle": (10.3, 9.6, 8.6, 7.4),
    "ring": (9.8, 9.1, 8.2, 7.1),
    "little": (8.9, 8.1, 7.3, 6.4),
}
# Bent fingers do not stay side by side: their tips all point to the root of the thumb. This is
# how far the plane in which a finger bends leans to the little finger's side.
LEAN = {"index": 0.10, "middle": -0.04, "ring": -0.18, "little": -0.34}

THUMB_ROOT = (-21.0, 19.0, -11.0)
THUMB_BONES = (46.0, 32.0, 20.0)
THUMB_RADII = (13.5, 11.6, 10.4, 8.3)


def finger(name, spread, bends):
    """The four points of a finger from its knuckle to its tip. `spread`: degrees to the little
    finger's side; `bends`: of the three joints, degrees."""
    angle = math.radians(spread)
    ahead = (math.sin(angle), math.cos(angle), 0.0)
    down = (LEAN[name], 0.0, -1.0)
    down = unit(subtract(down, scale(ahead, dot(down, ahead))))
    points, turned = [KNUCKLE[name]], 0.0
    for bend, length in zip(bends, BONES[name]):
        turned += math.radians(bend)
        along = add(scale(ahead, math.cos(turned)), scale(down, math.sin(turned)))
        points.append(add(points[-1], scale(along, length)))
    return points


def thumb(directions):
    """The four points of the thumb from its root to its tip. `directions`: of its three bones, not
    yet of length 1."""
    points = [THUMB_ROOT]
    for direction, length in zip(directions, THUMB_BONES):
        points.append(add(points[-1], scale(unit(direction), length)))
    return points
