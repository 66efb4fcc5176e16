#!/usr/bin/env python3
"""Writes the scenarios that come with Resect: python3 make_scenarios.py FOLDER [--check].

The organ is the built-in liver at rest on the table: x -0.11 to 0.11, y 0 to 0.125, z -0.10 to 0.10 m. An instrument's
position is its tip. A tool that must leave no cell behind in its way swings sideways by a little more than half a cell
while it advances by less than its own width.
"""
import math
import sys
from pathlib import Path

FRAME_RATE = 60
SIZES = {  # name: (spacing in mm, what people are told)
    "120": (24.6, " (120 particles, as in the thesis)"),
    "950": (11.96, " (950 particles, as in the thesis)"),
    "": (5.0, ""),
}


class Path3:
    """Keys of one tool: time, tip, how far its jaws are squeezed, and where handle and edge point; its pedal is pressed
    all the time or never."""

    def __init__(self, handle, edge, speed, pedal=0):
        self.handle, self.edge, self.speed, self.pedal = handle, edge, speed, pedal
        self.keys = []
        self.time = 0.0
        self.squeeze = 0.0

    def wait(self, seconds):
        self.time += round(seconds * FRAME_RATE) / FRAME_RATE

    def to(self, *tip, speed=None):
        if self.keys:
            # Keys fall on frames, so that the corners of the way are passed and not cut off between two frames.
            seconds = math.dist(tip, self.keys[-1][1]) / (speed or self.speed)
            self.time += max(1, math.ceil(seconds * FRAME_RATE - 1e-6)) / FRAME_RATE
        self.keys.append((round(self.time, 5), tip, self.squeeze, self.edge))
        return self

    def turn(self, edge):
        """Turns the instrument so that its edge points elsewhere, by the next key."""
        self.edge = edge
        return self

    def snip(self, seconds=0.3):
        """Closes the jaws where they are and opens them again."""
        for self.squeeze in (1.0, 0.0):
            self.wait(seconds)
            self.keys.append((round(self.time, 5), self.keys[-1][1], self.squeeze, self.edge))
        return self

    def grasp(self, seconds):
        """Closes the jaws where they are for a time, and opens them again."""
        for self.squeeze, wait in ((1.0, 0.1), (1.0, seconds), (0.0, 0.1)):
            self.wait(wait)
            self.keys.append((round(self.time, 5), self.keys[-1][1], self.squeeze, self.edge))
        return self

    def hold_until(self, time):
        """Stays where it is, as it is."""
        self.time = time
        self.keys.append((round(self.time, 5), self.keys[-1][1], self.squeeze, self.edge))
        return self

    def jaws(self, squeeze, seconds=0.3):
        """Closes or opens the jaws where they are."""
        self.squeeze = squeeze
        self.wait(seconds)
        self.keys.append((round(self.time, 5), self.keys[-1][1], self.squeeze, self.edge))
        return self

    def text(self):
        vector = lambda v: "[" + ", ".join(f"{x:.4f}".rstrip("0").rstrip(".") for x in v) + "]"
        turn = lambda edge: f"{{ handle = {vector(self.handle)}, edge = {vector(edge)} }}"
        jaws = lambda squeeze: f", squeeze = {squeeze:g}" if squeeze else ""
        pedal = f", pedal = {self.pedal:g}" if self.pedal else ""
        rows = [
            f"  {{ time = {t:.7g}, position = {vector(p)}, rotation = {turn(edge)}{jaws(s)}{pedal} }},"
            for t, p, s, edge in self.keys
        ]
        return "keys = [\n" + "\n".join(rows) + "\n]\n"


def saw(path, start, end, half_width, advance):
    """From start to end while swinging by +-half_width along x; each swing advances by `advance`."""
    steps = max(1, math.ceil(math.dist(start, end) / advance))
    for i in range(steps + 1):
        share = i / steps
        x, y, z = (a + share * (b - a) for a, b in zip(start, end))
        path.to(x + (half_width if i % 2 else -half_width), y, z)


def cut(spacing):
    """A groove drawn with the scalpel over the dome, from the far side to the surgeon."""
    path = Path3(handle=(0, 0.9, 0.45), edge=(0, -0.45, 0.9), speed=0.12)
    half, advance = 0.52 * spacing, min(0.008, 0.75 * spacing)
    path.wait(0.2)
    path.to(-0.03, 0.22, -0.06).to(-0.03, 0.125, -0.06)
    saw(path, (-0.03, 0.098, -0.075), (-0.03, 0.098, 0.02), half, advance)
    saw(path, (-0.03, 0.095, 0.02), (-0.03, 0.06, 0.07), half, advance)
    path.to(-0.03, 0.16, 0.12).to(0.05, 0.24, 0.14, speed=0.3)
    return [("scalpel", path), ("hook", None), ("baton", None)]


def perforate(spacing):
    """The baton is driven through the liver at three places, turning in a small circle."""
    path = Path3(handle=(0, 1, 0.12), edge=(0, 0.12, -1), speed=0.2)
    path.wait(0.2)
    for x, z, top in ((-0.055, 0.005, 0.12), (-0.005, 0.03, 0.12), (0.055, 0.05, 0.08)):
        path.to(x, top + 0.06, z)
        turns = 12
        radius = 0.3 * spacing
        for i in range(turns + 1):
            angle = 2 * math.pi * i / 4
            path.to(x + radius * math.cos(angle), top - i / turns * (top + 0.004), z + radius * math.sin(angle))
        path.to(x, top + 0.06, z, speed=0.4)
    path.to(0.1, 0.24, 0.12, speed=0.4)
    return [("scalpel", None), ("hook", None), ("baton", path)]


def deform(spacing):
    """The hook is dragged over the dome again and again, each time a little deeper: the liver is hollowed out."""
    path = Path3(handle=(0.35, 0.9, 0.25), edge=(0, -0.25, 0.9), speed=0.25)
    path.wait(0.2)
    path.to(0.02, 0.2, -0.07)
    for depth in (0.112, 0.104, 0.096, 0.088):
        for i in range(7):
            x = -0.055 + 0.012 * i
            saw(path, (x, depth, -0.045 if i % 2 == 0 else 0.02), (x, depth, 0.02 if i % 2 == 0 else -0.045),
                0.35 * spacing, min(0.008, 0.75 * spacing))
    path.to(0.02, 0.2, 0.05).to(0.1, 0.24, 0.12, speed=0.4)
    return [("scalpel", None), ("hook", path), ("baton", None)]


def resect_segment(spacing):
    """The left lateral part is cut off along a plane, stroke by stroke, each one deeper."""
    x = 0.05
    half = 0.52 * spacing  # with the 0.4 mm of the blade just a cell
    path = Path3(handle=(0, 0.96, 0.28), edge=(0, -0.28, 0.96), speed=0.22)
    path.wait(0.3)
    path.to(x, 0.22, -0.03).to(x, 0.12, -0.045, speed=0.3)
    for stroke, depth in enumerate((0.064, 0.032, -0.003)):
        ends = (-0.055, 0.098) if stroke % 2 == 0 else (0.098, -0.055)
        saw(path, (x, depth, ends[0]), (x, depth, ends[1]), half, spacing)
    path.to(x, 0.13, -0.06, speed=0.4).to(0.02, 0.25, -0.02, speed=0.4)
    return [("scalpel", path), ("hook", None), ("baton", None)]


def ligaments(x):
    """Where a living liver is held, at rest: behind the dome; x: where its middle lies, m."""
    return f"""[[tissue.attachment]]
kind = "ligament"
box = [[{x - 0.05:g}, 0.05, -0.11], [{x + 0.05:g}, 0.13, -0.07]]
stiffness = 300
"""


ASIDE = -0.07  # m: where a sagging liver is clear of the tray
PINNED_TOP = """[[tissue.attachment]]
kind = "pin"
box = [[-0.08, 0.19, -0.08], [0.06, 0.25, 0.05]]
"""


def press():
    """The baton presses on the dome, stays, lets go, and presses again beside it."""
    path = Path3(handle=(0, 0.95, 0.3), edge=(0, 0.3, -0.95), speed=0.08)
    path.wait(0.9)
    path.to(-0.03, 0.16, 0.01).to(-0.03, 0.06, 0.01, speed=0.06)
    path.wait(0.5)
    path.to(-0.03, 0.06, 0.01).to(-0.03, 0.16, 0.01, speed=0.15).to(0.03, 0.14, 0.02)
    path.to(0.03, 0.05, 0.02, speed=0.06)
    path.wait(0.3)
    path.to(0.03, 0.05, 0.02).to(0.03, 0.2, 0.08, speed=0.2)
    return [("scalpel", None), ("hook", None), ("baton", path)]


def lift():
    """The hook enters the front margin, pulls it up and out, holds it, and pulls until it slips."""
    path = Path3(handle=(0, 0.75, 0.66), edge=(0, -0.66, 0.75), speed=0.1)
    path.wait(0.9)
    path.to(0.055, 0.12, 0.14).to(0.055, 0.022, 0.04)
    path.wait(0.1)
    path.to(0.055, 0.022, 0.04).to(0.055, 0.046, 0.056, speed=0.05)
    path.wait(0.6)
    path.to(0.055, 0.046, 0.056).to(0.055, 0.2, 0.14, speed=0.08)
    path.to(0.1, 0.24, 0.2, speed=0.3)
    return [("scalpel", None), ("hook", path), ("baton", None)]


def incise():
    """One long cut over the dome, towards the surgeon, some two centimetres deep."""
    path = Path3(handle=(0, 0.8, 0.6), edge=(0, -0.6, 0.8), speed=0.12)
    path.wait(0.9)
    x = -0.02  # the dome, once it has sagged, is 0.098 m high here and slopes down from z = 0.01 on
    path.to(x, 0.2, -0.06).to(x, 0.12, -0.065)
    for z, y in ((-0.05, 0.076), (-0.03, 0.079), (-0.01, 0.078), (0.01, 0.072), (0.02, 0.066), (0.03, 0.057),
                 (0.04, 0.047), (0.05, 0.036), (0.058, 0.028)):
        path.to(x, y, z, speed=0.05)
    path.to(x, 0.14, 0.12, speed=0.3).to(0.05, 0.24, 0.14, speed=0.3)
    return [("scalpel", path), *((name, None) for name in (
        "hook", "baton", "scissors", "suction", "clip_applier", "bipolar"))]


# The portal branch of 2.7 mm that `bleed` cuts, once the liver has sagged: in its middle (-0.017, 0.028, 0.044), 21 mm
# under the skin.
VESSEL = (-0.017, 0.028, 0.044)


# What bleeds most of the vessels that are cut with it, from the flank to the lobe's margin.
BLEEDING = (
    (-0.0434, 0.0594, 0.0450), (-0.0313, 0.0416, 0.0450), (-0.0197, 0.0276, 0.0440), (-0.0169, 0.0303, 0.0446),
    (-0.0141, 0.0218, 0.0434), (-0.0181, 0.0246, 0.0440), (-0.0050, 0.0223, 0.0432), (-0.0040, 0.0302, 0.0439),
    (0.0023, 0.0301, 0.0440), (0.0053, 0.0237, 0.0435), (0.0065, 0.0165, 0.0427), (0.0167, 0.0151, 0.0412),
)


def cut_branch(path):
    """A stroke across the branch, in from the dome's flank and out where the lobe is thin."""
    z = VESSEL[2]
    path.to(-0.07, 0.2, z).to(-0.055, 0.1, z)
    for x, y in ((-0.045, 0.056), (-0.030, 0.040), (-0.017, 0.0235), (-0.005, 0.018), (0.010, 0.014), (0.022, 0.016)):
        path.to(x, y, z, speed=0.05)
    path.to(0.05, 0.12, z, speed=0.3).to(0.05, 0.24, 0.14, speed=0.4)


INSTRUMENTS = ("scalpel", "hook", "baton", "scissors", "suction", "clip_applier", "bipolar", "gauze", "inflow_clamp",
               "pencil", "aspirator")


def all_instruments(**paths):
    """Every instrument, in the order of their keys, those without a path on the table."""
    return [(name, paths.get(name)) for name in INSTRUMENTS]


def bleed():
    """The scalpel cuts a portal branch of 3 mm; nobody stops the bleeding."""
    path = Path3(handle=(0.6, 0.8, 0), edge=(0.8, -0.6, 0), speed=0.12)
    path.wait(0.9)
    cut_branch(path)
    return all_instruments(scalpel=path)


def stop_bleeding():
    """The same cut; suction clears the wound, a clip closes the branch, and bipolar forceps seal what is left."""
    scalpel = Path3(handle=(0.6, 0.8, 0), edge=(0.8, -0.6, 0), speed=0.12)
    scalpel.wait(0.9)
    cut_branch(scalpel)
    x, y, z = VESSEL
    suction = Path3(handle=(-0.5, 0.86, 0.1), edge=(0, -0.1, 0.86), speed=0.3)
    suction.wait(scalpel.time - 1.0)
    suction.to(-0.1, 0.2, 0.1).to(x - 0.008, y + 0.028, z, speed=0.3)
    suction.wait(1.5)
    suction.to(x - 0.008, y + 0.028, z).to(x - 0.03, y + 0.055, z + 0.012, speed=0.05)
    clip = Path3(handle=(0.2, 0.9, 0.4), edge=(0, -0.4, 0.9), speed=0.15)
    clip.wait(scalpel.time - 0.3)
    clip.to(x + 0.05, 0.2, z + 0.1).to(x + 0.004, y + 0.045, z + 0.01).to(x, y + 0.004, z, speed=0.05).snip()
    clip.to(x + 0.05, 0.2, z + 0.1, speed=0.3)
    bipolar = Path3(handle=(0.1, 0.9, 0.42), edge=(0, -0.42, 0.9), speed=0.15)
    bipolar.wait(clip.time - 0.6)
    bipolar.to(x + 0.02, 0.2, z + 0.12)
    for place in BLEEDING:
        bipolar.to(place[0], place[1] + 0.012, place[2], speed=0.15).to(*place, speed=0.1).grasp(1.0)
        bipolar.to(place[0], place[1] + 0.012, place[2], speed=0.15)
    bipolar.to(x + 0.02, 0.2, z + 0.12, speed=0.3)
    suction.wait(bipolar.time - 1.5 - suction.time)
    suction.to(x - 0.03, y + 0.055, z + 0.012).to(x + 0.010, y + 0.022, z + 0.015, speed=0.05)
    suction.to(x + 0.025, y + 0.005, z + 0.03, speed=0.02)
    suction.wait(0.5)
    suction.to(x + 0.025, y + 0.005, z + 0.03)
    return all_instruments(scalpel=scalpel, suction=suction, clip_applier=clip, bipolar=bipolar)


# Skin of the sagged lobe at z = 0.044, x to y, m; and vessels that the groove of `transect` bares: middle, direction,
# length in mm.
SKIN = ((-0.05, 0.078), (-0.04, 0.0682), (-0.03, 0.0562), (-0.02, 0.0479), (-0.01, 0.0432), (0.0, 0.040), (0.01, 0.035))
BARED = (
    ((-0.0266, 0.0295, 0.0445), (-0.27, 0.11, 0.95), 4.7),
    ((-0.0138, 0.0205, 0.0447), (0.58, -0.36, 0.73), 9.8),
    ((-0.0179, 0.0273, 0.0439), (0.69, 0.07, 0.72), 6.9),
)


# Ends of thin vessels in the groove.
OPENED = (
    (-0.0345, 0.0374, 0.0455), (-0.0320, 0.0263, 0.0462), (-0.0272, 0.0299, 0.0465), (-0.0234, 0.0265, 0.0413),
    (-0.0196, 0.0250, 0.0452), (-0.0173, 0.0196, 0.0463), (-0.0150, 0.0280, 0.0475), (-0.0100, 0.0310, 0.0460),
    (-0.0060, 0.0190, 0.0430), (-0.0060, 0.0270, 0.0460), (-0.0110, 0.0150, 0.0454), (-0.0221, 0.0208, 0.0468),
    (-0.0331, 0.0264, 0.0450),
)


def skin(x):
    for (a, low), (b, high) in zip(SKIN, SKIN[1:]):
        if a <= x <= b:
            return low + (high - low) * (x - a) / (b - a)
    raise ValueError(x)


def transect():
    """A part of a left lateral sectionectomy: inflow clamped, capsule scored, parenchyma aspirated over 6 cm^2, three
    vessels clipped and divided, what bleeds coagulated, the inflow opened again, the field sucked dry."""
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
    for middle, along, length in BARED:
        for side in (-1, 1):
            x, y, z_ = (m + side * a * (0.0005 * length - 0.0008) for m, a in zip(middle, along))
            clip.to(x, y + 0.03, z_, speed=0.25).to(x, y, z_, speed=0.15).jaws(1.0, 0.2).jaws(0.0, 0.2)
            clip.to(x, y + 0.03, z_, speed=0.15)
    clip.to(0.03, 0.18, 0.1)
    scissors = Path3(handle=(0, 0.95, 0.3), edge=(1, 0, 0), speed=0.3)
    scissors.wait(clip.time - 0.6)
    scissors.to(-0.02, 0.18, 0.1)
    for (x, y, z_), _, _ in BARED:
        scissors.to(x, y + 0.034, z_, speed=0.25).to(x, y - 0.006, z_, speed=0.1).jaws(1.0).jaws(0.0)
        scissors.to(x, y + 0.034, z_, speed=0.15)
    scissors.to(-0.02, 0.18, 0.1)
    bipolar = Path3(handle=(0.1, 0.95, 0.3), edge=(0, -0.3, 0.95), speed=0.3)
    bipolar.wait(scissors.time - 0.6)
    bipolar.to(0.03, 0.18, 0.1)
    for place in OPENED:
        bipolar.to(place[0], place[1] + 0.014, place[2], speed=0.2).to(*place, speed=0.12).grasp(0.9)
        bipolar.to(place[0], place[1] + 0.014, place[2], speed=0.2)
    bipolar.to(0.03, 0.18, 0.1)
    clamp.hold_until(bipolar.time)
    clamp.jaws(0.0).to(0.12, 0.15, 0.03)
    suction = Path3(handle=(-0.3, 0.9, 0.3), edge=(0, -0.3, 0.9), speed=0.3)
    suction.wait(bipolar.time - 0.8)
    suction.to(-0.03, 0.18, 0.1)
    for x in (-0.034, -0.02, -0.006, -0.02):
        suction.to(x, skin(x) - 0.012, z, speed=0.03)
    suction.wait(1.0)
    suction.to(-0.02, skin(-0.02) - 0.012, z)
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


def incise_under_traction():
    """The hook pulls the left lobe aside, the scalpel is drawn over it across the pull, and the wound opens."""
    caught, pulled, opened = (0.051, 0.022, 0.03), (0.061, 0.029, 0.03), (0.067, 0.033, 0.03)
    hook = Path3(handle=(0.8, 0.6, 0), edge=(0.6, -0.8, 0), speed=0.12)
    hook.wait(0.6)
    hook.to(0.125, 0.12, 0.03).to(*caught)
    hook.wait(0.1)
    hook.to(*caught).to(*pulled, speed=0.03)
    # The lobe's top along the cut, after it has sagged: the blade's edge must reach out of the tissue, or it tunnels.
    top = ((-0.005, 0.047), (0.005, 0.048), (0.015, 0.048), (0.025, 0.047), (0.035, 0.045), (0.045, 0.043),
           (0.055, 0.041), (0.065, 0.038), (0.075, 0.033))
    x, depth = 0.03, 0.018
    scalpel = Path3(handle=(0, 0.8, 0.6), edge=(0, -0.6, 0.8), speed=0.15)
    scalpel.wait(2.2)
    scalpel.to(x, 0.2, -0.03).to(x, top[0][1] + 0.03, top[0][0] - 0.01)
    for z, y in top:
        scalpel.to(x, y - depth, z, speed=0.05)
    scalpel.to(x, 0.093, 0.135, speed=0.3).to(0.05, 0.24, 0.16, speed=0.4)
    hook.wait(scalpel.time - 0.6 - hook.time)
    hook.to(*pulled).to(*opened, speed=0.03)
    hook.wait(1.2)
    hook.to(*opened)
    return [("scalpel", scalpel), ("hook", hook), ("baton", None)]


def snip():
    """The scissors come from the front and cut into the left lobe, snip by snip."""
    path = Path3(handle=(0, 0.42, 0.91), edge=(0, -0.91, 0.42), speed=0.1)
    path.wait(0.9)
    path.to(0.058, 0.09, 0.2, speed=0.2)
    for i in range(5):
        z = 0.078 - 0.014 * i
        path.to(0.058, 0.012 + 0.0045 * i, z, speed=0.06).snip()
    path.to(0.058, 0.09, 0.16, speed=0.15).to(0.1, 0.2, 0.2, speed=0.3)
    return [("scalpel", None), ("hook", None), ("baton", None), ("scissors", path)]


def resect_segment_elastic():
    """The scalpel, held upright, cuts the left lateral part off from both sides; the hook pulls it aside, and the
    scalpel cuts the strands that are left; the hook lifts the part away."""
    x, there, back = 0.062, (0, -0.05, 1), (0, 0.05, -1)
    scalpel = Path3(handle=(0, 1, 0.05), edge=there, speed=0.15)

    def cut_off(x, speed):
        """There, and back with the edge turned: where a cut leaves the tissue, the last of it gives way uncut."""
        scalpel.to(x, 0.2, -0.12, speed=0.4).to(x, 0.001, -0.12, speed=0.4).to(x, 0.001, 0.13, speed=speed)
        scalpel.turn(back).to(x, 0.001, 0.16, speed=0.1).to(x, 0.001, -0.06, speed=speed)
        scalpel.turn(there).to(x, 0.14, -0.06, speed=0.4).to(0.05, 0.24, 0.14, speed=0.5)

    scalpel.wait(0.9)
    cut_off(x, 0.12)
    caught, pulled, lifted = (0.075, 0.016, 0.02), (0.095, 0.03, 0.025), (0.14, 0.075, 0.04)
    hook = Path3(handle=(0.45, 0.85, 0.27), edge=(0.85, -0.52, 0.1), speed=0.15)
    hook.wait(scalpel.time + 0.2)
    hook.to(0.17, 0.13, 0.03, speed=0.3).to(*caught)
    hook.wait(0.1)
    hook.to(*caught).to(*pulled, speed=0.06)
    scalpel.wait(hook.time - scalpel.time)
    scalpel.to(0.05, 0.24, 0.14)
    cut_off(0.07, 0.15)
    hook.wait(scalpel.time - hook.time - 1)
    hook.to(*pulled).to(*lifted, speed=0.06)
    hook.wait(0.6)
    hook.to(*lifted)
    return [("scalpel", scalpel), ("hook", hook), ("baton", None)]


def lift_gallbladder():
    """The hook catches the fundus from the front, lifts it, holds it, lays it down and lets go."""
    path = Path3(handle=(0, 0.8, 0.6), edge=(0, -0.6, 0.8), speed=0.12)
    caught, lifted = (-0.055, 0.079, 0.08), (-0.055, 0.09, 0.0825)
    path.wait(0.8)
    path.to(-0.055, 0.2, 0.19).to(*caught)
    path.wait(0.1)
    path.to(*caught).to(*lifted, speed=0.04)
    path.wait(0.8)
    path.to(*lifted).to(*caught, speed=0.04)
    path.wait(0.2)
    path.to(*caught)
    return [("scalpel", None), ("hook", path), ("baton", None)]


def liver_and_gallbladder():
    """Two organs: the liver lies on its dome, held below; the gallbladder is on its bed above."""
    turn = "{ axis = [0.1954, 0.1288, -0.9722], degrees = 180 }"
    text = scenario("The gallbladder is lifted, and the liver follows",
                    "The hook holds the gallbladder up by its fundus, lays it down and lets go", 6.0, lift_gallbladder(),
                    "surgeon", thesis=False)
    organs = f"""[[organ]]
name = "liver"
source = "liver"
spacing = "6mm"
rotation = {turn}  # on its dome, the fundus towards the surgeon
position = [-0.07, 0, 0]  # clear of the tray
settle = false

[organ.tissue]
model = "elastic"

[[organ.tissue.attachment]]
kind = "pin"
box = [[-0.18, -0.01, -0.1], [0.04, 0.03, 0.1]]

[[organ]]
name = "gallbladder"
source = "gallbladder"
beside = "liver"
spacing = "4mm"

[organ.tissue]
model = "elastic"
young = 8000
tear_energy = 1000
density = 1020

[[joint]]
organs = ["gallbladder", "liver"]
reach = "8mm"
stiffness = 600
"""
    head, tools = text.split("[organ]\n", 1)
    return head + organs + "\n" + tools[tools.index("[[tool]]"):]


def no_tools():
    return [("scalpel", None), ("hook", None), ("baton", None)]


def elastic(title, description, spacing_mm, tools, extra="", tissue="", duration=None, organ="", close_up=None, x=0.0):
    """A scenario whose tissue moves; x: organ and instruments stand so far to the side, m."""
    if x:
        for _, path in tools:
            if path:
                path.keys = [(time, (tip[0] + x, *tip[1:]), *rest) for time, tip, *rest in path.keys]
        organ = f"position = [{x:g}, 0, 0]  # clear of the tray\n" + organ
    text = scenario(title, description, spacing_mm, tools, "surgeon", duration=duration, thesis=False)
    if close_up:
        text = text.replace('view = "surgeon"\n', f'view = "surgeon"\nclose_up = {close_up}\n', 1)
    settings = f'[tissue]\nmodel = "elastic"\n{tissue}\n{extra}'
    return text.replace("[[tool]]", settings.rstrip("\n") + "\n\n[[tool]]", 1).replace(
        'source = "liver"\n', 'source = "liver"\n' + organ, 1)


def scenario(title, description, spacing_mm, tools, view, tail=0.4, duration=None, thesis=True):
    end = duration - tail if duration else max(path.keys[-1][0] for _, path in tools if path)
    lines = [
        "# Written by tools/make_scenarios; change it there. Metres and seconds; docs/scenarios.md explains the keys.",
        f'title = "{title}"',
        f'description = "{description}"',
        f"frame_rate = {FRAME_RATE}",
        f"duration = {math.ceil(10 * (end + tail)) / 10:g}",
        f'view = "{view}"',
        *(['mode = "thesis"'] if thesis else []),
        "",
        "[organ]",
        'source = "liver"',
        f'spacing = "{spacing_mm:g}mm"',
        "",
    ]
    for name, path in tools:
        lines += ["[[tool]]", f'model = "{name}"', path.text() if path else ""]
    return "\n".join(lines).rstrip("\n") + "\n"


def all_scenarios():
    kinds = {
        "cut": (cut, "Cut across the dome", "The scalpel draws a groove over the dome, from the far side to the surgeon"),
        "perforate": (perforate, "Three holes through the liver", "The baton is driven from the dome to the table, three times"),
        "deform": (deform, "Hollow out the dome", "The hook rakes the dome away, pass by pass"),
    }
    for kind, (make, title, description) in kinds.items():
        for size, (spacing_mm, told) in SIZES.items():
            name = kind + ("-" + size if size else "")
            yield name, scenario(title + told, description, spacing_mm, make(spacing_mm / 1000), "surgeon")
    yield "resect-segment", scenario(
        "Left lateral part of the liver taken off", "A scalpel path that parts the liver completely, in three strokes",
        3.0, resect_segment(0.003), "surgeon", tail=0.8)
    yield "press", elastic("The baton presses on a soft liver", "Elastic tissue on the table, pressed twice", 8.0,
                           press(), ligaments(ASIDE), x=ASIDE)
    yield "lift", elastic("The hook lifts the margin of the liver", "It catches, pulls, holds, and slips", 8.0, lift(),
                          ligaments(ASIDE), x=ASIDE)
    yield "incise", elastic("An incision over the dome", "The scalpel is drawn over the dome, towards the surgeon; the wound bleeds",
                            8.0, incise(), ligaments(ASIDE), x=ASIDE, organ='vessels = "built-in"\n',
                            close_up="[[-0.13, 0.05, -0.05], [-0.05, 0.1, 0.06]]")
    yield "incise-under-traction", elastic(
        "An incision under traction", "The hook pulls, the scalpel cuts across the pull, and the wound opens", 6.0,
        incise_under_traction(), ligaments(-0.035),
        organ="position = [-0.035, 0, 0]  # so that the lobe does not come to lie on the tray\n",
        close_up="[[-0.015, 0, -0.03], [0.095, 0.07, 0.08]]")
    bleeds = f"position = [{ASIDE:g}, 0, 0]  # clear of the tray\nvessels = \"built-in\"\n"
    yield "bleed", elastic(
        "A branch of the portal vein bleeds", "The scalpel cuts a branch of 3 mm; blood wells up, runs and pools", 8.0,
        bleed(), ligaments(ASIDE), organ=bleeds, duration=12, close_up="[[-0.09, 0, -0.02], [0.05, 0.09, 0.12]]")
    yield "stop-bleeding", elastic(
        "Bleeding is stopped", "Suction clears the wound, a clip closes the vessel, bipolar forceps seal the rest", 8.0,
        stop_bleeding(), ligaments(ASIDE), organ=bleeds, close_up="[[-0.09, 0, -0.02], [0.05, 0.09, 0.12]]")
    yield "transect", elastic(
        "Part of a left lateral sectionectomy", "The inflow is clamped, the aspirator bares the vessels, they are "
        "clipped and divided, forceps coagulate what bleeds", 8.0, transect(), ligaments(ASIDE), organ=bleeds,
        close_up="[[-0.09, 0, -0.02], [0.05, 0.09, 0.12]]")
    yield "pringle", elastic(
        "The inflow is clamped", "A cut bleeds; a clamp on the portal pedicle stops what flows in, until it is opened", 8.0,
        pringle(), ligaments(ASIDE), organ=bleeds, close_up="[[-0.09, 0, -0.02], [0.05, 0.09, 0.12]]")
    yield "cautery", elastic(
        "A raw surface is coagulated", "Where the aspirator took tissue away small arteries bleed; the pencil seals them", 8.0,
        cautery(), ligaments(ASIDE), organ=bleeds, close_up="[[-0.09, 0, -0.02], [0.05, 0.09, 0.12]]")
    yield "snip", elastic("Scissors cut into the left lobe", "Snip by snip from the front; nothing is lost", 8.0,
                          snip(), ligaments(ASIDE), x=ASIDE)
    yield "resect-segment-elastic", elastic(
        "A piece of a soft liver taken off", "The scalpel parts the left lateral part; the hook lifts it away", 8.0,
        resect_segment_elastic(), ligaments(ASIDE), "cut_energy = 17  # a new blade\n", x=ASIDE)
    yield "liver-and-gallbladder", liver_and_gallbladder()
    yield "hang", elastic("The liver hangs from its dome", "Pinned at the top, it sags and swings under its weight", 8.0,
                          no_tools(), PINNED_TOP, 'drag = 1\n', duration=3, organ="position = [0, 0.12, 0]\n")
    yield "drop", elastic("The liver is dropped on the table", "From 12 cm; it flattens, and comes to rest", 8.0,
                          no_tools(), "", 'drag = 1.5\n', duration=3, organ=f"position = [{ASIDE:g}, 0.12, 0]  # clear of the tray\n")


def main():
    folder, check = Path(sys.argv[1]), "--check" in sys.argv
    stale = []
    for name, text in all_scenarios():
        file = folder / f"{name}.toml"
        if not check:
            file.write_text(text)
        elif not file.exists() or file.read_text() != text:
            stale.append(str(file))
    if stale:
        sys.exit("not what tools/make_scenarios writes: " + ", ".join(stale))


if __name__ == "__main__":
    main()
