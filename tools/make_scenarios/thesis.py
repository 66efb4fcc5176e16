"""Motions in tissue that stands still: every tool removes what it touches, as in the thesis.

A tool that must leave no cell behind in its way swings sideways by a little more than half a cell while it advances by
less than its own width.
"""
import math

from paths import Path3, saw


def cut(spacing):
    """A groove drawn with the scalpel over the dome, from the far side to the surgeon."""
    path = Path3(handle=(0, 0.9, 0.45), edge=(0, -0.45, 0.9), speed=0.12)
    half, advance = 0.52 * spacing, min(0.008, 0.75 * spacing)
    path.wait(0.2)
    path.to(-0.03, 0.22, -0.06).to(-0.03, 0.125, -0.06)
    saw(path, (-0.03, 0.098, -0.075), (-0.03, 0.098, 0.02), half, advance)
    saw(path, (-0.03, 0.095, 0.02), (-0.03, 0.06, 0.07), half, advance)
    path.to(-0.03, 0.16, 0.12).to(0.05, 0.24, 0.14, speed=0.3)
    path.way = -0.03, spacing, 0.52
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
