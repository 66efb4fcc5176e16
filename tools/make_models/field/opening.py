"""The opening in the abdominal wall: an oval of some 37 x 33 cm. Metres; the origin is the middle of
its floor, Y points up, +Z to the surgeon (and the patient's feet), +X to the patient's left."""

import math

HALF_WIDTH = 0.185
HALF_DEPTH = 0.165


def rim(angle, out=0.0):
    """A point (x, z) of the oval, `out` metres outside it. angle: 0 at +X, a quarter turn at +Z."""
    c, s = math.cos(angle), math.sin(angle)
    # Fuller than an ellipse.
    r = (abs(c) ** 2.4 + abs(s) ** 2.4) ** (-1.0 / 2.4)
    n = math.hypot(c / HALF_WIDTH, s / HALF_DEPTH)
    return (
        HALF_WIDTH * r * c + out * c / HALF_WIDTH / n,
        HALF_DEPTH * r * s + out * s / HALF_DEPTH / n,
    )


def skin_height(angle):
    """Of the skin at the rim: low before the surgeon, high at the ribs."""
    s = math.sin(angle)
    return 0.058 - 0.031 * s + 0.008 * s * s


def angles(count):
    """Round the oval so that rows of points have their front up: from +X by -Z."""
    return [-2.0 * math.pi * k / count for k in range(count)]
