"""Motions in a liver that bleeds."""
from paths import Path3
from scenario_text import all_instruments

# The portal branch of 2.7 mm that `bleed` cuts, once the liver has sagged: in its middle (-0.017, 0.028, 0.044), 21 mm
# under the skin.
VESSEL = (-0.017, 0.028, 0.044)


# The other vessels that are cut with it, once the clip is on the branch; those that bleed most come first.
BLEEDING = (
    (-0.0247, 0.0343, 0.0443), (0.0066, 0.0162, 0.0425), (0.0023, 0.0303, 0.0441), (-0.0140, 0.0217, 0.0434),
    (-0.0040, 0.0303, 0.0440), (-0.0217, 0.0316, 0.0442), (-0.0410, 0.0531, 0.0446), (-0.0195, 0.0264, 0.0442),
    (-0.0441, 0.0596, 0.0452), (-0.0312, 0.0417, 0.0449), (-0.0048, 0.0224, 0.0434), (0.0076, 0.0222, 0.0426),
    (-0.0063, 0.0191, 0.0436), (-0.0127, 0.0397, 0.0447), (-0.0168, 0.0301, 0.0447),
    (-0.0007, 0.0373, 0.0452),
)


def cut_branch(path):
    """A stroke across the branch, in from the dome's flank and out where the lobe is thin."""
    z = VESSEL[2]
    path.to(-0.07, 0.2, z).to(-0.055, 0.1, z)
    for x, y in ((-0.045, 0.056), (-0.030, 0.040), (-0.017, 0.0235), (-0.005, 0.018), (0.010, 0.014), (0.022, 0.016)):
        path.to(x, y, z, speed=0.05)
    path.to(0.05, 0.12, z, speed=0.3).to(0.05, 0.24, 0.14, speed=0.4)


def bleed():
    """The scalpel cuts a portal branch of 3 mm; nobody stops the bleeding."""
    path = Path3(handle=(0.6, 0.8, 0), edge=(0.8, -0.6, 0), speed=0.12)
    path.wait(0.9)
    cut_branch(path)
    return all_instruments(scalpel=path)


def suck_at_vessel(begin, seconds):
    """Suction that comes to the branch, takes blood away for a time, and stays above."""
    x, y, z = VESSEL
    suction = Path3(handle=(-0.5, 0.86, 0.1), edge=(0, -0.1, 0.86), speed=0.3)
    suction.wait(begin)
    suction.to(-0.1, 0.2, 0.1).to(x - 0.008, y + 0.028, z, speed=0.3)
    suction.wait(seconds)
    return suction.to(x - 0.008, y + 0.028, z).to(x - 0.03, y + 0.055, z + 0.012, speed=0.05)


def stop_bleeding():
    """The same cut; suction clears the wound, a clip closes the branch, and bipolar forceps seal what is left."""
    scalpel = Path3(handle=(0.6, 0.8, 0), edge=(0.8, -0.6, 0), speed=0.12)
    scalpel.wait(0.9)
    cut_branch(scalpel)
    x, y, z = VESSEL
    suction = suck_at_vessel(scalpel.time - 1.0, 1.5)
    clip = Path3(handle=(0.2, 0.9, 0.4), edge=(0, -0.4, 0.9), speed=0.15)
    clip.wait(scalpel.time - 0.3)
    clip.to(x + 0.05, 0.2, z + 0.1).to(x + 0.004, y + 0.045, z + 0.01).to(x, y + 0.004, z, speed=0.05).snip()
    clip.to(x + 0.05, 0.2, z + 0.1, speed=0.3)
    bipolar = Path3(handle=(0.1, 0.9, 0.42), edge=(0, -0.42, 0.9), speed=0.15)
    bipolar.wait(clip.time - 0.6)
    bipolar.to(x + 0.02, 0.2, z + 0.12)
    for place in BLEEDING:
        bipolar.to(place[0], place[1] + 0.012, place[2], speed=0.15).to(*place, speed=0.1).grasp(1.6)
        bipolar.to(place[0], place[1] + 0.012, place[2], speed=0.15)
    bipolar.to(x + 0.02, 0.2, z + 0.12, speed=0.3)
    # At the lower end of the wound, where the blood runs out, and then over the table.
    suction.to(x + 0.045, y + 0.02, z + 0.015, speed=0.2).to(x + 0.041, y - 0.014, z + 0.006, speed=0.1)
    suction.hold_until(bipolar.time)
    suction.to(0.04, 0.08, 0.12, speed=0.2)
    for px, pz in ((0.02, 0.105), (0.012, 0.075), (-0.005, 0.09), (-0.02, 0.085), (-0.02, 0.07)):
        suction.to(px, 0.004, pz, speed=0.05)
    suction.to(-0.02, 0.12, 0.16)
    return all_instruments(scalpel=scalpel, suction=suction, clip_applier=clip, bipolar=bipolar)


# Skin of the sagged lobe at z = 0.044, x to y, m.
SKIN = ((-0.05, 0.078), (-0.04, 0.0682), (-0.03, 0.0562), (-0.02, 0.0479), (-0.01, 0.0432), (0.0, 0.040), (0.01, 0.035))
# Of the vessels that the groove of `transect` bares: where three of them are divided, each after two clips; the left
# hepatic vein of 4.2 mm, a branch of it of 2.9 mm, the portal branch of 2.7 mm.
DIVIDED = (
    ((-0.0265, 0.0296, 0.0440), ((-0.0263, 0.0298, 0.0415), (-0.0268, 0.0290, 0.0475))),
    ((-0.0143, 0.0204, 0.0447), ((-0.0170, 0.0215, 0.0415), (-0.0115, 0.0189, 0.0484))),
    ((-0.0181, 0.0273, 0.0434), ((-0.0199, 0.0270, 0.0411), (-0.0155, 0.0278, 0.0467))),
)


# Vessels beside those that are divided, which are sealed first.
SEALED = ((-0.0255, 0.0295, 0.0454), (-0.0269, 0.0300, 0.0476), (-0.0247, 0.0340, 0.0466), (-0.0222, 0.0197, 0.0443))
# Ends that bleed once the vessels are divided.
SEEN = ((-0.0291, 0.0246, 0.0430), (-0.0128, 0.0221, 0.0459), (-0.0346, 0.0369, 0.0467), (-0.0242, 0.0358, 0.0470))
# Ends of thin vessels that bleed once the inflow is open again.
SEEN_WITH_INFLOW = (
    (-0.0222, 0.0195, 0.0441), (-0.0317, 0.0441, 0.0496), (-0.0103, 0.0228, 0.0401), (-0.0075, 0.0182, 0.0403),
    (-0.0150, 0.0279, 0.0483), (-0.0222, 0.0312, 0.0456), (-0.0235, 0.0365, 0.0475),
)
# Where the walls of the groove ooze.
OOZES = (
    (-0.014, 0.030, 0.0385), (-0.022, 0.034, 0.0505), (-0.030, 0.048, 0.0385), (-0.030, 0.048, 0.0500),
    (-0.022, 0.040, 0.0385), (-0.013, 0.036, 0.0500), (-0.006, 0.034, 0.0385),
)
# Thin vessels in the groove, which are sealed before those beside them are divided.
OPENED = (
    (-0.0306, 0.0317, 0.0471), (-0.0350, 0.0289, 0.0462), (-0.0330, 0.0263, 0.0450), (-0.0110, 0.0150, 0.0454),
    (-0.0064, 0.0243, 0.0480), (-0.0017, 0.0205, 0.0461), (-0.0347, 0.0384, 0.0433), (-0.0380, 0.0380, 0.0479),
    (-0.0318, 0.0442, 0.0496), (-0.0268, 0.0267, 0.0468), (-0.0201, 0.0261, 0.0447), (-0.0222, 0.0271, 0.0417),
    (-0.0177, 0.0196, 0.0459), (-0.0122, 0.0222, 0.0464), (-0.0070, 0.0261, 0.0398),
)


def skin(x):
    for (a, low), (b, high) in zip(SKIN, SKIN[1:]):
        if a <= x <= b:
            return low + (high - low) * (x - a) / (b - a)
    raise ValueError(x)


def coagulate(bipolar, places):
    """The forceps close for 1.8 s at each place, and go aside."""
    for x, y, z in places:
        bipolar.to(x, y + 0.014, z, speed=0.2).to(x, y, z, speed=0.12).grasp(1.8).to(x, y + 0.014, z, speed=0.2)
    bipolar.to(0.03, 0.18, 0.1)


def transect():
    """A part of a left lateral sectionectomy: inflow clamped, capsule scored, parenchyma aspirated over 6 cm^2, three
    vessels clipped, thin ones sealed, all divided, the inflow opened again, what still bleeds coagulated."""
    z = VESSEL[2]
    clamp = Path3(handle=(0.75, 0.66, 0.1), edge=(0.66, -0.75, 0), speed=0.25)
    clamp.wait(0.6)
    clamp.to(0.12, 0.15, 0.03).to(0.042, 0.022, 0.012).jaws(1.0)
    pencil = Path3(handle=(0.5, 0.86, 0.1), edge=(0.86, -0.5, 0), speed=0.2)
    pencil.wait(1.2)
    pencil.to(-0.06, 0.2, z).to(-0.036, skin(-0.036) + 0.01, z)
    for i in range(8):
        x = -0.034 + 0.0045 * i
        pencil.to(x, skin(x) - 0.003, z, speed=0.02)
    pencil.to(0.01, 0.12, z, speed=0.3).to(0.03, 0.2, 0.1, speed=0.3)
    aspirator = Path3(handle=(0.1, 0.9, 0.42), edge=(0, -0.42, 0.9), speed=0.3)
    aspirator.wait(pencil.time - 1)
    aspirator.to(0.0, 0.2, 0.12).to(-0.032, skin(-0.032) + 0.02, z)
    for layer, depth in enumerate((0.003, 0.008, 0.013, 0.018, 0.022)):
        way = [-0.032 + 0.03 * i / 8 for i in range(9)]
        for x in reversed(way) if layer % 2 else way:
            aspirator.to(x, skin(x) - depth, z, speed=0.035)
    aspirator.to(0.0, 0.12, z, speed=0.3).to(0.03, 0.2, 0.12, speed=0.3)
    clip = Path3(handle=(0.1, 0.95, 0.3), edge=(0, -0.3, 0.95), speed=0.3)
    clip.wait(aspirator.time - 0.8)
    clip.to(0.03, 0.18, 0.1)
    for _, clips in DIVIDED:
        for x, y, z_ in clips:
            clip.to(x, y + 0.03, z_, speed=0.25).to(x, y, z_, speed=0.15).jaws(1.0, 0.2).jaws(0.0, 0.2)
            clip.to(x, y + 0.03, z_, speed=0.15)
    clip.to(0.03, 0.18, 0.1)
    bipolar = Path3(handle=(0.1, 0.95, 0.3), edge=(0, -0.3, 0.95), speed=0.3)
    bipolar.wait(clip.time - 0.6)
    bipolar.to(0.03, 0.18, 0.1)
    coagulate(bipolar, SEALED + OPENED)
    scissors = Path3(handle=(0, 0.95, 0.3), edge=(1, 0, 0), speed=0.3)
    scissors.wait(bipolar.time - 0.6)
    scissors.to(-0.02, 0.18, 0.1)
    for (x, y, z_), _ in DIVIDED:
        scissors.to(x, y + 0.034, z_, speed=0.25).to(x, y - 0.006, z_, speed=0.1).jaws(1.0).jaws(0.0)
        scissors.to(x, y + 0.034, z_, speed=0.15)
    scissors.to(-0.02, 0.18, 0.1)
    bipolar.wait(scissors.time - 0.6 - bipolar.time)
    coagulate(bipolar, SEEN)
    clamp.hold_until(bipolar.time)
    clamp.jaws(0.0).to(0.12, 0.15, 0.03)
    coagulate(bipolar, SEEN_WITH_INFLOW + OOZES)
    suction = Path3(handle=(-0.3, 0.9, 0.3), edge=(0, -0.3, 0.9), speed=0.3)
    suction.wait(aspirator.time - 6)
    suction.to(-0.06, 0.16, 0.1).to(-0.012, skin(-0.012) + 0.004, z + 0.008)
    suction.hold_until(bipolar.time)
    for x in (-0.034, -0.02, -0.006):
        suction.to(x, skin(x) - 0.012, z, speed=0.03)
    suction.to(0.02, 0.08, 0.12)
    # The pool before the liver, row by row.
    rows = ((0.15, -0.055, 0.02), (0.13, 0.045, -0.06), (0.11, -0.07, 0.06), (0.092, 0.055, -0.085), (0.07, -0.095, -0.07))
    for z_, begin, end in rows:
        suction.to(begin, 0.004, z_, speed=0.09).to(end, 0.004, z_, speed=0.09)
    suction.to(-0.02, 0.12, 0.16)
    return all_instruments(inflow_clamp=clamp, pencil=pencil, aspirator=aspirator, clip_applier=clip,
                           scissors=scissors, bipolar=bipolar, suction=suction)


def pringle():
    """The same cut as `bleed`; a clamp closes the inflow for eight seconds, and opens it again."""
    scalpel = Path3(handle=(0.6, 0.8, 0), edge=(0.8, -0.6, 0), speed=0.12)
    scalpel.wait(0.9)
    cut_branch(scalpel)
    clamp = Path3(handle=(0.75, 0.66, 0.1), edge=(0.66, -0.75, 0), speed=0.25)
    clamp.wait(scalpel.time)
    clamp.to(0.12, 0.15, 0.03).to(0.042, 0.022, 0.012).jaws(1.0)
    clamp.hold_until(clamp.time + 8)
    clamp.jaws(0.0).to(0.12, 0.15, 0.03)
    return all_instruments(scalpel=scalpel, inflow_clamp=clamp)


# Ends of the small arteries that bleed on the raw surface of `cautery`.
OOZING = (
    (-0.0226, 0.0415, 0.0375), (-0.0201, 0.0333, 0.0426), (-0.0188, 0.0317, 0.0516), (-0.0074, 0.0343, 0.0476),
    (-0.0022, 0.0370, 0.0315), (0.0016, 0.0268, 0.0522), (0.0057, 0.0284, 0.0307),
)


def cautery():
    """The aspirator takes a shallow patch of the lobe away; the pencil, its pedal pressed, coagulates what bleeds."""
    z = VESSEL[2]
    aspirator = Path3(handle=(0.1, 0.9, 0.42), edge=(0, -0.42, 0.9), speed=0.3)
    aspirator.wait(0.9)
    aspirator.to(0.0, 0.2, 0.12)
    for depth in (0.002, 0.006):
        for dz in (-0.009, 0.0, 0.009):
            for i in range(5):
                aspirator.to(-0.022 + 0.006 * i, skin(-0.022 + 0.006 * i) - depth, z + dz, speed=0.06)
    aspirator.to(0.0, 0.12, z, speed=0.3).to(0.03, 0.2, 0.12, speed=0.3)
    pencil = Path3(handle=(0.3, 0.9, 0.3), edge=(0.9, -0.3, 0), speed=0.2, pedal=1)
    pencil.wait(aspirator.time - 0.5)
    pencil.to(-0.04, 0.2, z)
    for x, y, z_ in OOZING:
        pencil.to(x, y + 0.015, z_).to(x, y, z_, speed=0.1).hold_until(pencil.time + 1.2)
        pencil.to(x, y + 0.015, z_)
    pencil.to(0.01, 0.12, z, speed=0.3).to(0.03, 0.2, 0.1, speed=0.3)
    return all_instruments(aspirator=aspirator, pencil=pencil)


# A left hepatic vein of 3.1 mm that runs 12 mm under the skin of the left lobe, once the liver has sagged: its middle and
# its direction, m; where clips close it and scissors divide it; and arteries that the groove over it opens.
TRIBUTARY, ALONG = (0.0105, 0.0215, 0.0168), (0.89, -0.18, 0.41)
CLIPPED, PARTED = ((0.0063, 0.0223, 0.0143), (0.0117, 0.0206, 0.0174)), (0.0088, 0.0217, 0.0156)
SPURTING = ((-0.0039, 0.0275, 0.0146), (-0.0046, 0.0327, 0.0101), (-0.0043, 0.0305, 0.0107), (-0.0038, 0.0280, 0.0119),
            (0.0020, 0.0328, 0.0201), (-0.0030, 0.0220, 0.0109))
# Ends that bleed once the vein is divided.
LEFT_OPEN = ((0.0037, 0.0318, 0.0213), (0.0049, 0.0294, 0.0198), (0.0121, 0.0237, 0.0070))


def bare_clip_divide():
    """The aspirator bares the vein; bipolar forceps stop the arteries; two clips close the vein, scissors divide it."""
    aspirator = Path3(handle=(0.1, 0.9, 0.42), edge=(0, -0.42, 0.9), speed=0.3)
    aspirator.wait(0.6)
    aspirator.to(0.03, 0.16, 0.1).to(0.004, 0.055, 0.014)
    for layer, height in enumerate((0.034, 0.030, 0.026, 0.022, 0.020)):
        ends = (0.013, -0.013) if layer % 2 else (-0.013, 0.013)
        for k in range(5):
            way = ends[0] + (ends[1] - ends[0]) * k / 4
            x, z = (TRIBUTARY[a] + ALONG[a] * way for a in (0, 2))
            aspirator.to(x, height + ALONG[1] * way, z, speed=0.05)
    aspirator.to(TRIBUTARY[0], 0.06, TRIBUTARY[2]).to(0.03, 0.16, 0.1)
    bipolar = Path3(handle=(0.1, 0.95, 0.3), edge=(0, -0.3, 0.95), speed=0.3)
    bipolar.wait(aspirator.time - 0.6)
    bipolar.to(0.03, 0.18, 0.1)
    coagulate(bipolar, SPURTING)
    clip = Path3(handle=(0.1, 0.95, 0.3), edge=(0, -0.3, 0.95), speed=0.3)
    clip.wait(bipolar.time - 0.6)
    clip.to(0.03, 0.18, 0.1)
    for x, y, z in CLIPPED:
        clip.to(x, y + 0.025, z, speed=0.2).to(x, y + 0.002, z, speed=0.08).jaws(1.0, 0.3).jaws(0.0, 0.3)
        clip.to(x, y + 0.025, z, speed=0.1)
    clip.to(0.03, 0.18, 0.1)
    scissors = Path3(handle=(-0.2, 0.95, 0.25), edge=(0.41, 0, -0.89), speed=0.3)
    scissors.wait(clip.time - 0.6)
    x, y, z = PARTED
    scissors.to(0.0, 0.18, 0.1).to(x, y + 0.03, z, speed=0.2).to(x, y - 0.002, z, speed=0.06)
    for aside in (0.0, 0.002, -0.002):
        scissors.to(x + 0.41 * aside, y - 0.002, z - 0.89 * aside, speed=0.02).jaws(1.0).jaws(0.0)
    scissors.to(x, y + 0.03, z, speed=0.1).to(0.0, 0.18, 0.1)
    bipolar.wait(scissors.time - 0.6 - bipolar.time)
    coagulate(bipolar, LEFT_OPEN)
    suction = Path3(handle=(-0.3, 0.9, 0.3), edge=(0, -0.3, 0.9), speed=0.3)
    suction.wait(aspirator.time - 3)
    suction.to(-0.04, 0.14, 0.06).to(-0.008, 0.038, 0.012, speed=0.1)
    suction.hold_until(bipolar.time - 1)
    suction.to(-0.04, 0.14, 0.06)
    return all_instruments(aspirator=aspirator, bipolar=bipolar, clip_applier=clip, scissors=scissors,
                           suction=suction)
