"""The skin of a gloved hand as far as the glove goes. Millimetres, in the hand's frame."""

import math

from field.noise import noise
from hands.bones import KNUCKLE, THUMB_RADII, WRIST, thumb
from hands.distance import Body, Cone
from shapes.loft import smoothstep
from shapes.vector import add, cross, dot, scale, subtract, unit

CUFF_END = 66.0  # from the wrist along the forearm
HIDDEN = 6.0  # so much longer is the skin, within the sleeve
CUFF_HALF_WIDTHS = (30.5, 20.0)  # at the wrist: to the side and to the back
FOREARM_HALF_WIDTHS = (38.5, 28.0)  # where the cuff ends

# The bones of the palm and the pads under them: ends and radii.
PALM = [
    ((-12.0, 20.0, 2.0), 13.0, (-20.0, 52.0, 2.5), 10.5),
    ((-20.0, 52.0, 2.5), 10.5, KNUCKLE["index"], 10.4),
    ((-3.0, 20.0, 4.0), 12.5, (-5.5, 54.0, 5.0), 10.5),
    ((-5.5, 54.0, 5.0), 10.5, KNUCKLE["middle"], 10.6),
    ((6.0, 19.0, 3.0), 12.5, (9.0, 50.0, 4.0), 10.5),
    ((9.0, 50.0, 4.0), 10.5, KNUCKLE["ring"], 10.2),
    ((13.0, 18.0, 0.0), 12.5, (22.0, 46.0, 0.0), 10.5),
    ((22.0, 46.0, 0.0), 10.5, KNUCKLE["little"], 9.4),
    ((-16.0, 73.0, -8.0), 10.0, (20.0, 64.0, -9.0), 9.0),
    ((17.0, 18.0, -9.0), 13.0, (26.0, 54.0, -10.0), 10.0),
]


def forearm_frame(grip):
    """Directions to the little finger's side, to the elbow and to the back of the forearm."""
    along = grip.forearm
    side = unit(subtract((1.0, 0.0, 0.0), scale(along, along[0])))
    return side, along, cross(along, side)


def forearm_point(grip, out, side, up):
    a, b, c = forearm_frame(grip)
    return add(WRIST, add(scale(a, side), add(scale(b, out), scale(c, up))))


def thumb_root(grip):
    """The ball of the thumb and the web between it and the index finger."""
    points = thumb(grip.thumb)
    root, joint = points[0], points[1]

    def between(a, b, share):
        return add(scale(a, 1.0 - share), scale(b, share))

    middle = between(root, joint, 0.55)
    index = KNUCKLE["index"]
    cones = [
        (root, THUMB_RADII[0], joint, THUMB_RADII[1]),
        ((-6.0, 24.0, -13.0), 12.5, between(root, joint, 0.7), 12.0),
        ((-14.0, 44.0, -7.0), 10.0, middle, 11.0),
    ]
    web = between(index, (-20.0, 52.0, 0.0), 0.45)
    for share, radius in ((0.75, 6.0), (0.97, 4.5)):
        end = between(web, index, share - 0.6)
        cones.append((between(root, joint, share), radius + 2.0, end, radius))
    return cones


def forearm(grip):
    """Three cones side by side make an oval."""
    cones = []
    (w0, h0), (w1, h1) = CUFF_HALF_WIDTHS, FOREARM_HALF_WIDTHS
    for side in (-1.0, 0.0, 1.0):
        a = forearm_point(grip, -6.0, side * (w0 - h0), 0.0)
        b = forearm_point(grip, 14.0, side * (w0 - h0 + 0.5), 0.0)
        c = forearm_point(grip, CUFF_END + 6.0, side * (w1 - h1), 0.0)
        thick = 0.5 if side == 0.0 else 0.0
        cones += [(a, h0 + thick, b, h0 + thick), (b, h0 + thick, c, h1 + thick)]
    return cones


def relief(grip):
    """Folds of the rubber: round the wrist, and fine ones elsewhere."""
    along = grip.forearm

    def height(x, y, z):
        p = (x, y, z)
        out = dot(p, along)
        at = out + 5.0 * noise(p, 30.0, 3)
        near = max(1.0 - ((out - 6.0) / 26.0) ** 2, 0.0)
        folds = 0.8 * near * math.sin(at * 0.5)
        fine = 0.35 * noise(p, 11.0, 5)
        return folds + fine + 0.9 * smoothstep(-25.0, 0.0, out) * noise(p, 24.0, 8)

    return height


def glove(grip):
    """The whole glove; it ends where its cuff does."""
    palm = [Cone(*cone) for cone in PALM + thumb_root(grip) + forearm(grip)]
    return Body(palm, grip.limbs(), relief(grip), (grip.forearm, CUFF_END + HIDDEN))
