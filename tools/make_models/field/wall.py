"""The abdominal wall: drapes, skin, and the layers of the wound's edge."""

import math

from field.noise import lobules, noise
from field.opening import angles, rim, skin_height
from field.sheet import Sheet, mix
from shapes.loft import smoothstep

COLUMNS = 120
SKIN = (0.74, 0.56, 0.45)  # painted with iodine
FAT = (0.88, 0.69, 0.46)
FAT_GROOVE = (0.74, 0.45, 0.28)
MUSCLE = (0.66, 0.25, 0.20)
PERITONEUM = (0.70, 0.45, 0.40)
DRAPE = (0.10, 0.36, 0.30)

# The wound's edge from the skin inwards: (metres outside the rim, metres below the skin, layer).
SECTION = [
    (0.012, 0.000, "skin"), (0.006, 0.0005, "skin"), (0.003, 0.0015, "skin"), (0.001, 0.003, "skin"),
    (0.004, 0.0030, "fat"), (0.0005, 0.0038, "fat"), (-0.003, 0.0052, "fat"), (-0.0055, 0.008, "fat"),
    (-0.0065, 0.011, "fat"), (-0.006, 0.014, "fat"), (-0.004, 0.017, "fat"), (0.000, 0.0195, "fat"),
    (0.005, 0.0215, "fat"),
    (0.003, 0.0180, "muscle"), (0.000, 0.0192, "muscle"), (-0.002, 0.0215, "muscle"), (-0.0035, 0.0245, "muscle"),
    (-0.003, 0.0275, "muscle"), (-0.0005, 0.030, "muscle"),
    (0.001, 0.0305, "muscle"), (-0.001, 0.032, "muscle"), (0.001, 0.036, "muscle"), (0.005, 0.042, "muscle"),
]


def body_height(angle, out):
    """Height of the body's surface `out` metres outside the rim: ribs and the screen at the head's
    end, flanks that fall, thighs."""
    s, c = math.sin(angle), math.cos(angle)
    head, side, feet = max(-s, 0.0), abs(c), max(s, 0.0)
    y = skin_height(angle)
    y += head * head * (0.055 * smoothstep(0.0, 0.22, out) + 0.42 * smoothstep(0.24, 0.46, out))
    y -= side * side * (0.9 * max(out - 0.16, 0.0) ** 1.15)
    return y - feet * 0.05 * smoothstep(0.02, 0.5, out)


DRAPE_ROWS = [0.0065, 0.0055, 0.006, 0.008, 0.012, 0.018, 0.027, 0.036, 0.046, 0.058, 0.07, 0.083, 0.097, 0.112]
DRAPE_ROWS += [0.13, 0.15, 0.175, 0.20, 0.23, 0.26, 0.30, 0.35, 0.42, 0.55, 0.95]  # metres outside the rim
DRAPE_LIFTS = [-0.003, 0.002, 0.0055, 0.0075, 0.0075, 0.006, 0.0045]  # above the body


def drape_edge(row, angle):
    """How far outside the rim a row of the drape lies at this place of the rim: the edge of the towels
    is clamped straight, an oval with four soft corners."""
    return DRAPE_ROWS[row] + 0.005 * abs(math.sin(2.0 * angle)) ** 3


def drape_point(row, angle):
    out = DRAPE_ROWS[row]
    x, z = rim(angle, drape_edge(row, angle))
    y = body_height(angle, out) + DRAPE_LIFTS[min(row, len(DRAPE_LIFTS) - 1)]
    place = (x, 0.0, z)
    y += smoothstep(0.012, 0.16, out) * fold_height(angle, out, place)
    y += 0.0010 * smoothstep(0.02, 0.05, out) * noise(place, 0.022, 9)
    return (x, y, z)


def drape():
    """Green cloth round the opening, to the picture's edges."""
    outs = DRAPE_ROWS
    rows = [[drape_point(k, a) for a in angles(COLUMNS)] for k in range(len(outs))]

    def colour(p, i, j):
        # Light that the folds take from each other, as for the tissues in light.py.
        a = angles(COLUMNS)[j % COLUMNS]
        fold = smoothstep(0.012, 0.16, outs[i]) * fold_height(a, outs[i], (p[0], 0.0, p[2]))
        return mix((0.0, 0.0, 0.0), DRAPE, min(max(0.85 + 26.0 * fold, 0.6), 1.4))

    return Sheet("drape", rows, colour)


# Across a pad that lies over the wound's edge, as SECTION, but above the skin.
PAD = [
    (0.062, 0.006), (0.058, 0.009), (0.045, 0.011), (0.028, 0.012), (0.012, 0.0115), (0.001, 0.010),
    (-0.007, 0.006), (-0.011, -0.001), (-0.0125, -0.009), (-0.0125, -0.016), (-0.0115, -0.022),
    (-0.008, -0.026), (-0.003, -0.028), (0.003, -0.029),
]
GAUZE = (0.66, 0.67, 0.65)


def pad(angle, half_width, seed):
    """A folded gauze pad that protects the edge at this place."""
    rows = []
    for out, up in PAD:
        row = []
        for k in range(25):
            u = (12 - k) / 12.0
            a = angle - u * half_width / 0.17
            wave = noise((2.2 * u, 10.0 * out, 0.0), 0.5, seed)
            edge = 0.004 * max(abs(u) - 0.85, 0.0) / 0.15
            x, z = rim(a, out + 0.0020 * wave + 0.006 * u * u * (1.0 if out < 0 else -1.0))
            lift = 0.0022 * wave - edge + 0.0016 * noise((7.0 * u, 25.0 * out, 3.0), 0.6, seed + 1)
            row.append((x, max(skin_height(a) + up + lift, -0.001 + 0.001 * wave), z))
        rows.append(row)
    shade = lambda p, i, j: mix(GAUZE, (0.5, 0.5, 0.48), 0.5 - 0.5 * noise(p, 0.012, seed))
    return Sheet("drape", rows, shade, closed=False)


def pads():
    return [pad(math.radians(152.0), 0.045, 71), pad(math.radians(18.0), 0.036, 81)]

def fold_height(angle, out, place):
    """Folds of the cloth: sharp ridges that run away from the opening, and soft hills."""
    ridges = 0.0
    for length, height, seed in ((0.115, 0.016, 3), (0.06, 0.007, 5)):
        along = (0.26 * angle + 0.25 * out, 0.45 * out, 0.05 * math.sin(2.0 * angle))
        ridges += height * (1.0 - abs(noise(along, length, seed)) ** 0.8 * 1.6)
    return 1.5 * ridges - 0.006 + 0.007 * noise(place, 0.08, 7)


def edge_point(layer, out, below, angle, relief=True):
    """A point of the wound's edge; `relief`: with the lobules of the fat, else with their mean."""
    # The cut wanders, and the layers have drawn back by different lengths.
    x, z = rim(angle, out)
    place = (x, -below, z)
    wander = 0.0025 * noise((x, 0.0, z), 0.045, 11) + 0.0012 * noise(place, 0.014, 12)
    if layer == "fat":
        inside = smoothstep(0.003, 0.007, below) * smoothstep(0.0215, 0.016, below)
        wander -= inside * (0.0042 * (lobules(place, 0.013, 21) if relief else 0.55) - 0.0025)
    if layer == "muscle":
        wander += 0.0012 * noise((3.0 * x, below, 3.0 * z), 0.012, 13)
    x, z = rim(angle, out + wander * smoothstep(0.02, 0.0, out))
    return (x, skin_height(angle) - below, z)


def wound_edge():
    """One sheet for each layer."""
    sheets = []
    for layer in ("skin", "fat", "muscle"):
        section = [(out, below) for out, below, name in SECTION if name == layer]
        turn = angles(COLUMNS if layer != "fat" else 2 * COLUMNS)
        rows = [[edge_point(layer, out, below, a) for a in turn] for out, below in section]
        sheets.append(Sheet(layer, rows, lambda p, i, j, layer=layer: layer_colour(layer, p)))
    return sheets


def layer_colour(layer, p):
    blotch = noise(p, 0.02, 31)
    if layer == "skin":
        return mix(SKIN, (0.86, 0.66, 0.50), 0.5 + 0.5 * noise(p, 0.05, 32))
    if layer == "fat":
        return mix(FAT_GROOVE, FAT, min(lobules(p, 0.013, 21) + 0.15 + 0.15 * blotch, 1.0))
    return mix(MUSCLE, PERITONEUM, max(0.25 * blotch, 0.0))
