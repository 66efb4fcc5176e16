"""What lies in the opened abdomen beside the liver: the omentum's apron over the bowel, the transverse
colon, the stomach, and the diaphragm's dome at the far end."""

import math

from field.noise import lobules, noise
from field.opening import angles, rim, skin_height
from field.sheet import Sheet, mix
from shapes.loft import circle, smoothstep, through
from shapes.vector import add, cross, scale, subtract, unit

OMENTUM = (0.88, 0.70, 0.47)
OMENTUM_GROOVE = (0.76, 0.47, 0.28)
BED = (0.66, 0.40, 0.35)  # peritoneum behind the liver
DIAPHRAGM = (0.56, 0.29, 0.26)
TENDON = (0.74, 0.56, 0.48)
COLON = (0.80, 0.59, 0.53)
TAENIA = (0.84, 0.68, 0.58)
STOMACH = (0.88, 0.68, 0.61)
WALL = 0.036  # thickness of the abdominal wall, as in wall.SECTION


def floor_height(u, angle):
    """Height of the floor at u of the way from the middle to the rim, without lobules: below the
    organ flat, under the ribs it rises to the dome."""
    s = math.sin(angle)
    head = smoothstep(0.15, 0.75, -s)
    under = skin_height(angle) - WALL
    rise = smoothstep(0.66, 1.0, u) * (under + 0.004)
    return -0.006 + rise - 0.004 * head * smoothstep(0.5, 0.7, u) * (1.0 - smoothstep(0.7, 1.0, u))


def floor_kind(u, angle):
    """How fatty the floor is here, 0 to 1, and how high its cushions stand."""
    x, z = rim(angle)
    x, z = u * x, u * z
    fatty = smoothstep(-0.35, 0.15, math.sin(angle) + 0.25 * noise((x, 0.0, z), 0.05, 41))
    return fatty * smoothstep(0.30, 0.55, u), lobules((x, 0.0, z), 0.014, 42)


def floor_point(u, angle, relief=True):
    """A point of the floor; `relief`: with the cushions of the fat, else with their mean."""
    x, z = rim(angle)
    x, z = u * x, u * z
    fatty, cushion = floor_kind(u, angle)
    y = floor_height(u, angle) + fatty * (0.0048 * (cushion if relief else 0.55) - 0.001)
    y += 0.0035 * fatty * noise((x, 0.0, z), 0.035, 43)
    y += 0.0014 * (1.0 - fatty) * noise((x, 0.0, z), 0.02, 44)
    return (x, y, z)


def cavity_floor():
    columns, shares = 180, [0.02, 0.15, 0.25, 0.33, 0.40]
    shares += [0.46 + 0.0205 * k for k in range(30)]
    rows, kinds = [], {}
    for i, u in enumerate(shares):
        rows.append([floor_point(u, a) for a in angles(columns)])
        for j, a in enumerate(angles(columns)):
            s = math.sin(a)
            kinds[i, j] = (*floor_kind(u, a), smoothstep(0.1, 0.6, -s) * smoothstep(0.62, 0.8, u), s)

    def colour(p, i, j):
        fatty, cushion, dome, s = kinds[i, j % columns]
        fat = mix(OMENTUM_GROOVE, OMENTUM, min(0.15 + cushion + 0.15 * noise(p, 0.03, 45), 1.0))
        tendon = smoothstep(0.0, 0.5, noise((p[0], 0.0, p[2]), 0.09, 46) + 0.8 * (-s - 0.75))
        muscle = mix(DIAPHRAGM, TENDON, 0.75 * tendon)
        return mix(mix(BED, muscle, dome), fat, fatty)

    # Each quad is of the tissue that most of it is: rows are cut where the kind changes.
    return [Sheet("omentum", rows, colour)]


def dome():
    """The wall from inside while gas lifts it, for the laparoscope: seen from below only."""
    rows = []
    for k in range(15):
        t = math.pi / 2.0 * k / 14.0
        row = []
        for a in angles(90):
            x, z = rim(a, 0.012)
            base = skin_height(a) - WALL - 0.004
            share, top = math.cos(t) ** 0.7, base + (0.27 - base) * math.sin(t)
            place = (x * share, top, z * share)
            row.append((place[0], top + 0.006 * noise(place, 0.07, 47) * share, place[2]))
        rows.append(row)

    def colour(p, i, j):
        pale = smoothstep(-0.2, 0.6, noise(p, 0.05, 48))
        return mix((0.52, 0.25, 0.22), (0.62, 0.41, 0.35), pale)

    return Sheet("dome", rows, colour)


def tube(part, path, radius, colour, columns=40, squash=0.9):
    """A closed tube along `path`. radius(s): at s metres along it."""
    rings, along = [], 0.0
    up = (0.0, 1.0, 0.0)
    for k, centre in enumerate(path):
        if k:
            along += math.dist(path[k - 1], centre)
        ahead = unit(subtract(path[min(k + 1, len(path) - 1)], path[max(k - 1, 0)]))
        side = unit(cross(ahead, up))
        top = cross(side, ahead)
        ring = []
        for c, s in circle(columns, 1.0):
            r = radius(along, math.atan2(s, c))
            ring.append(add(centre, add(scale(side, -r * c), scale(top, squash * r * s))))
        rings.append(ring)
    return Sheet(part, rings, colour)


def curve(knots, count):
    """`count` points of a smooth curve through knots (x, y, z) (Catmull and Rom 1974)."""
    padded = [knots[0]] + list(knots) + [knots[-1]]
    points = []
    for k in range(count):
        t = k / (count - 1) * (len(knots) - 1)
        i = min(int(t), len(knots) - 2)
        t -= i
        a, b, c, d = padded[i : i + 4]
        points.append(
            tuple(
                0.5 * (2 * q + (r - p) * t + (2 * p - 5 * q + 4 * r - s) * t * t + (3 * q - p - 3 * r + s) * t**3)
                for p, q, r, s in zip(a, b, c, d)
            )
        )
    return points


def colon():
    """Haustra between folds every 24 mm or so, and the pale bands along it that gather them."""
    knots = [(-0.19, -0.004, 0.07), (-0.145, -0.001, 0.110), (-0.085, -0.002, 0.131), (0.0, -0.003, 0.136)]
    knots += [(0.078, -0.003, 0.127), (0.128, 0.001, 0.096), (0.172, 0.004, 0.056)]

    def band(angle):
        return max(math.exp(-((((angle - b + math.pi) % (2.0 * math.pi)) - math.pi) / 0.20) ** 2)
                   for b in (0.45, 2.3, 4.4))

    def phase(s):
        return s / 0.029 + 0.55 * math.sin(s / 0.035) + 0.25 * math.sin(s / 0.013)

    def crease(s, angle):
        t = phase(s + 0.004 * math.sin(3.0 * angle)) % 1.0
        return math.exp(-((min(t, 1.0 - t) / 0.16) ** 2)) * (1.0 - 0.6 * band(angle))

    def radius(s, angle):
        swell = 1.0 + 0.10 * math.sin(s / 0.027 + 1.0) + 0.05 * math.sin(s / 0.011 + angle)
        return 0.0205 * swell * (1.0 - 0.17 * crease(s, angle) - 0.10 * band(angle))

    path = curve(knots, 120)
    lengths = [0.0]
    for a, b in zip(path, path[1:]):
        lengths.append(lengths[-1] + math.dist(a, b))

    def colour(p, i, j):
        angle = 2.0 * math.pi * (j % 30) / 30
        c = mix(COLON, (0.62, 0.33, 0.29), 0.55 * crease(lengths[i], angle) + 0.15 * noise(p, 0.02, 51))
        return mix(c, TAENIA, 0.75 * band(angle))

    return tube("gut", path, radius, colour, columns=30)


def stomach():
    """Its body at the patient's left, partly under the left lobe."""
    knots = [(0.140, 0.008, -0.140), (0.158, 0.012, -0.095), (0.163, 0.008, -0.040), (0.148, 0.000, 0.022)]
    knots += [(0.105, -0.008, 0.068), (0.050, -0.016, 0.080)]
    widths = [(0.0, 0.016), (0.012, 0.036), (0.04, 0.047), (0.09, 0.047), (0.15, 0.037), (0.22, 0.020)]

    def radius(s, angle):
        place = (0.03 * math.cos(angle), s, 0.03 * math.sin(angle))
        return through(widths, s) * (1.0 + 0.07 * noise(place, 0.045, 63) + 0.02 * noise(place, 0.016, 64))

    def colour(p, i, j):
        return mix(STOMACH, (0.78, 0.53, 0.47), 0.5 + 0.5 * noise(p, 0.03, 61))

    return tube("gut", curve(knots, 44), radius, colour, columns=44)
