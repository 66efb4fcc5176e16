"""Signed distances to bodies of cones with round ends that flow into each other. Millimetres."""

import math


class Cone:
    """All within a radius of a line, the radius going evenly from r to s."""

    def __init__(self, a, r, b, s):
        self.a, self.r = a, r
        self.along = tuple(q - p for p, q in zip(a, b))
        self.per_square = 1.0 / max(sum(c * c for c in self.along), 1e-9)
        self.growth = s - r

    def distance(self, x, y, z):
        ax, ay, az = self.a
        bx, by, bz = self.along
        x, y, z = x - ax, y - ay, z - az
        t = (x * bx + y * by + z * bz) * self.per_square
        t = 0.0 if t < 0.0 else 1.0 if t > 1.0 else t
        x, y, z = x - t * bx, y - t * by, z - t * bz
        return math.sqrt(x * x + y * y + z * z) - self.r - t * self.growth


def joined(a, b, blend):
    """The lesser of two distances, with the notch between the bodies filled within `blend`."""
    h = blend - abs(a - b)
    least = a if a < b else b
    return least - 0.25 * h * h / blend if h > 0.0 else least


def cones_distance(cones, blend, x, y, z):
    found = 1e9
    for cone in cones:
        d = cone.distance(x, y, z)
        h = blend - abs(d - found)
        found = (d if d < found else found) - (0.25 * h * h / blend if h > 0.0 else 0.0)
    return found


class Limb:
    """A finger: cones one after another. It flows into the palm near its knuckle, and further out
    it only lies against it."""

    BLEND = 5.0  # from bone to bone
    ROOT_BLEND = 11.0
    TIP_BLEND = 1.6
    ROOT = (16.0, 34.0)  # from the knuckle: until where it flows, from where it only lies

    def __init__(self, knuckle, cones):
        self.knuckle = knuckle
        self.cones = cones

    def root_blend(self, x, y, z):
        a, b, c = self.knuckle
        away = math.sqrt((x - a) ** 2 + (y - b) ** 2 + (z - c) ** 2)
        t = (away - self.ROOT[0]) / (self.ROOT[1] - self.ROOT[0])
        t = 0.0 if t < 0.0 else 1.0 if t > 1.0 else t
        return self.ROOT_BLEND + (self.TIP_BLEND - self.ROOT_BLEND) * t * t * (3.0 - 2.0 * t)


class Body:
    """The palm, whose cones flow into each other, and the limbs. `relief(x, y, z)`: how far the
    skin stands out. `end`: a direction, and how far along it the body ends."""

    PALM_BLEND = 12.0
    LIMBS_BLEND = 2.5  # where limbs touch each other
    FAR = 12.0  # a limb farther from the palm's skin than this does not change it

    def __init__(self, palm, limbs, relief, end):
        self.palm = palm
        self.limbs = limbs
        self.relief = relief
        self.end = end

    def distance(self, x, y, z):
        palm = cones_distance(self.palm, self.PALM_BLEND, x, y, z)
        found = palm
        for limb in self.limbs:
            d = cones_distance(limb.cones, limb.BLEND, x, y, z)
            if d < max(palm, found) + self.FAR:
                d = joined(palm, d, limb.root_blend(x, y, z))
                # No more than both stand out of the palm, so that nothing grows where none does.
                blend = min(self.LIMBS_BLEND, palm - d, palm - found)
                found = joined(found, d, blend) if blend > 1e-6 else min(found, d)
        if abs(found) < 8.0:
            found -= self.relief(x, y, z)
        (a, b, c), limit = self.end
        return max(found, a * x + b * y + c * z - limit)

    def near(self, x, y, z, reach):
        """The body without what is too far away to matter within `reach` of a point."""
        margin = reach + self.PALM_BLEND + 3.0
        limit = max(self.distance(x, y, z), 0.0) + 2.0 * margin

        def kept(cones):
            return [cone for cone in cones if cone.distance(x, y, z) < limit]

        limbs = [Limb(limb.knuckle, kept(limb.cones)) for limb in self.limbs]
        limbs = [limb for limb in limbs if limb.cones]
        return Body(kept(self.palm), limbs, self.relief, self.end)

    def extent(self, axis):
        """Between which values of a coordinate all of it lies."""
        cones = self.palm + [cone for limb in self.limbs for cone in limb.cones]
        low, high = [], []
        for cone in cones:
            a, b, r = cone.a[axis], cone.a[axis] + cone.along[axis], cone.r + max(cone.growth, 0.0)
            low.append(min(a, b) - r)
            high.append(max(a, b) + r)
        return min(low) - 3.0, max(high) + 3.0
