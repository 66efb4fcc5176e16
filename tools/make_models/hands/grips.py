"""How the hand holds: angles of the fingers and where the handle is, in the frame of bones.py.
Millimetres and degrees. The angles are such that the pads touch the handle; they were fitted once,
and rounded."""

from hands.bones import KNUCKLE, RADII, THUMB_RADII, finger, thumb
from hands.distance import Cone, Limb
from shapes.vector import cross, dot, scale, subtract, unit


class Grip:
    """`fingers`: {name: (spread, (bends))}. `thumb`: directions of its bones. `forearm`: direction
    from the wrist to the elbow. `origin`, `handle`: of the handle's axis, away from the tip.
    `across`: which way +X of the written model points, as far as the handle allows it."""

    def __init__(self, fingers, thumb, forearm, origin, handle, across):
        self.fingers = fingers
        self.thumb = thumb
        self.forearm = unit(forearm)
        self.origin = origin
        z = unit(handle)
        x = unit(subtract(across, scale(z, dot(across, z))))
        self.axes = (x, cross(z, x), z)

    def turned(self, direction):
        """A direction of the hand's frame in that of the written model."""
        return tuple(dot(direction, axis) for axis in self.axes)

    def placed(self, point):
        """A point of the hand's frame in that of the written model, metres."""
        return scale(self.turned(subtract(point, self.origin)), 0.001)

    def limbs(self):
        """The fingers and the two outer bones of the thumb."""
        result = []
        for name, (spread, bends) in self.fingers.items():
            points, radii = finger(name, spread, bends), RADII[name]
            cones = [Cone(points[k], radii[k], points[k + 1], radii[k + 1]) for k in range(3)]
            result.append(Limb(KNUCKLE[name], cones))
        points, radii = thumb(self.thumb), THUMB_RADII
        cones = [Cone(points[k], radii[k], points[k + 1], radii[k + 1]) for k in (1, 2)]
        result.append(Limb(points[1], cones))
        return result


PEN = Grip(
    fingers={
        "index": (-3.3, (19.6, 74.5, 15.2)),
        "middle": (-2.2, (41.7, 65.7, 20.3)),
        "ring": (0.0, (58.0, 72.0, 36.0)),
        "little": (3.0, (60.0, 74.0, 40.0)),
    },
    thumb=((-0.200, 0.847, -0.493), (-0.139, 0.856, -0.497), (0.026, 0.863, -0.505)),
    forearm=(0.10, -0.90, 0.42),
    origin=(-23.2, 107.4, -57.4),
    handle=(-0.2514, -0.4552, 0.8542),
    across=(0.10, -0.90, 0.42),
)
ROD = Grip(
    fingers={
        "index": (-2.2, (21.5, 87.1, 73.9)),
        "middle": (-1.0, (44.6, 112.4, 50.0)),
        "ring": (3.9, (56.3, 111.3, 53.6)),
        "little": (3.5, (54.4, 101.4, 51.0)),
    },
    thumb=((-0.476, 0.837, -0.271), (-0.290, 0.931, -0.220), (-0.021, 0.981, -0.194)),
    forearm=(0.16, -0.96, 0.22),
    origin=(2.7, 83.4, -23.3),
    handle=(0.84, -0.5415, 0.0337),
    across=(0.16, -0.96, 0.22),
)
RINGS = Grip(
    fingers={
        "index": (-9.5, (28.1, 19.0, 10.1)),
        "middle": (1.7, (36.2, 57.2, 30.0)),
        "ring": (-3.3, (49.3, 65.7, 32.0)),
        "little": (4.0, (50.0, 70.0, 38.0)),
    },
    thumb=((-0.529, 0.814, -0.240), (0.235, 0.947, -0.219), (0.214, 0.328, -0.920)),
    forearm=(0.10, -0.97, 0.20),
    origin=(-16.5, 96.2, -41.8),
    handle=(0.324, -0.8804, 0.3462),
    across=(0.015, 0.3707, 0.9286),
)
