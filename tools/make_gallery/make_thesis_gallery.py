#!/usr/bin/env python3
"""Draws figures 3.1, 4.5 and 4.6 of the original thesis anew, from what Resect computes, into docs/gallery/thesis.

    make_thesis_gallery.py [BUILD]      BUILD: the folder with resect and example_09_smoothing_kernel; build/release without it

Needs ImageMagick's convert.
"""
import math
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TARGET = ROOT / "docs" / "gallery" / "thesis"
BALL = 0.27  # radius of a drawn particle, in spacings
ROUND, HIGH = 14, 8  # corners of a ball


def read_obj(file):
    rows = [line.split() for line in file.read_text().splitlines()]
    return [tuple(map(float, row[1:])) for row in rows if row and row[0] == "v"]


def project(point):
    """Seen along the y axis, from 37 degrees to the left and 30 above; pixels, and how far away."""
    x, y, z = point[0] * 88, point[1] * 88, point[2] * 620
    a, b = math.radians(37), math.radians(30)
    right, away = x * math.cos(a) - y * math.sin(a), x * math.sin(a) + y * math.cos(a)
    return 370 + right, 380 - z * math.cos(b) - away * math.sin(b), away


def colour(share):
    """From blue at 0 through green and yellow to red at 1."""
    stops = [(58, 76, 160), (70, 165, 190), (110, 185, 90), (240, 205, 70), (200, 60, 45)]
    at = min(share, 0.9999) * (len(stops) - 1)
    low, part = int(at), at - int(at)
    return "#%02x%02x%02x" % tuple(round(a + part * (b - a)) for a, b in zip(stops[low], stops[low + 1]))


def kernel_figure(build, folder):
    """3.1: a 2D smoothing kernel, over x and y in smoothing lengths h."""
    subprocess.run([build / "example_09_smoothing_kernel", folder / "kernel.obj"], check=True, stdout=subprocess.DEVNULL)
    points = read_obj(folder / "kernel.obj")
    side, reach, top = math.isqrt(len(points)), points[-1][0], max(p[2] for p in points)
    out = ['<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 720 560" width="720" height="560" font-family="sans-serif" '
           'font-size="14">', '<rect width="100%" height="100%" fill="#ffffff"/>']

    def line(*corners, stroke="#dddddd"):
        out.append('<path d="M%s" fill="none" stroke="%s"/>'
                   % ("L".join("%.1f %.1f" % project(c)[:2] for c in corners), stroke))

    def text(where, shift, words, anchor="middle"):
        x, y, _ = project(where)
        out.append(f'<text x="{x + shift[0]:.0f}" y="{y + shift[1]:.0f}" text-anchor="{anchor}">{words}</text>')

    for at in range(-2, 3):
        line((at, -reach, 0), (at, reach, 0), (at, reach, 0.4))
        line((-reach, at, 0), (reach, at, 0), (reach, at, 0.4))
        text((at, -reach, 0), (12, 18), at)
        text((-reach, at, 0), (-12, 18), at)
    for tenths in range(5):
        line((-reach, reach, tenths / 10), (reach, reach, tenths / 10), (reach, -reach, tenths / 10))
        text((-reach, reach, tenths / 10), (-8, 5), tenths / 10, "end")
    line((-reach, reach, 0.4), (-reach, reach, 0), (-reach, -reach, 0), (reach, -reach, 0), stroke="#333333")
    text((0, -reach, 0), (36, 44), "x / h")
    text((-reach, 0, 0), (-36, 44), "y / h")
    text((-reach, reach, 0.4), (0, -14), "h² W")

    squares = []
    for j in range(side - 1):
        for i in range(side - 1):
            corners = [points[k] for k in (j * side + i, j * side + i + 1, (j + 1) * side + i + 1, (j + 1) * side + i)]
            squares.append((max(project(c)[2] for c in corners), corners))
    out.append('<g stroke="#fff" stroke-width=".5">')
    for _, corners in sorted(squares, key=lambda square: square[0], reverse=True):
        fill = colour(sum(c[2] for c in corners) / 4 / top)
        out.append('<path d="M%sZ" fill="%s"/>'
                   % ("L".join("%.1f %.1f" % project(c)[:2] for c in corners), fill))
    (TARGET / "3.1.svg").write_text("\n".join(out + ["</g>", "</svg>", ""]))


def particles(file):
    """Centres of those inside, and their distance, from a file of particles in the thesis's format."""
    lines = file.read_text().splitlines()
    inside = int(lines[2].split(":")[1])
    dims, box = ([float(word) for word in lines[k].split(":")[1].split()] for k in (3, 4))
    return [tuple(map(float, row.split()[1:4])) for row in lines[6:6 + inside]], (box[3] - box[0]) / dims[0]


def write_balls(file, centres, radius):
    corners = [(math.sin(math.pi * i / HIGH) * math.cos(2 * math.pi * j / ROUND),
                math.sin(math.pi * i / HIGH) * math.sin(2 * math.pi * j / ROUND), math.cos(math.pi * i / HIGH))
               for i in range(HIGH + 1) for j in range(ROUND)]
    with file.open("w") as out:
        for ball, centre in enumerate(centres):
            for corner in corners:
                out.write("v %.6f %.6f %.6f\n" % tuple(c + radius * d for c, d in zip(centre, corner)))
            for i in range(HIGH):
                for j in range(ROUND):
                    here, beside = (1 + ball * len(corners) + i * ROUND + k for k in (j, (j + 1) % ROUND))
                    out.write(f"f {here} {here + ROUND} {beside + ROUND}\nf {here} {beside + ROUND} {beside}\n")


def add_specks(file, box):
    """Two triangles too small to be seen, in the corners of a box: the camera shows all of it."""
    with file.open("a") as out:
        for corner in box:
            for axis in range(3):
                out.write("v %.6f %.6f %.6f\n" % tuple(c + 1e-5 * (k == axis) for k, c in enumerate(corner)))
            out.write("f -3 -2 -1\n")


def discretization_figure(build, folder, name, scenario):
    """4.5 and 4.6: the particles, and the surface that they make."""
    def resect(*arguments):
        subprocess.run([build / "resect", *arguments], check=True, stdout=subprocess.DEVNULL)

    resect("discretize", ROOT / "data" / "scenarios" / f"{scenario}.toml", "-o", folder / "cells.dis")
    resect("surface", folder / "cells.dis", "-o", folder / "surface.obj")
    centres, spacing = particles(folder / "cells.dis")
    write_balls(folder / "balls.obj", centres, BALL * spacing)
    skin = read_obj(folder / "surface.obj")
    box = [tuple(edge(place[axis] for place in skin) for axis in range(3)) for edge in (min, max)]
    for part in ("balls", "surface"):
        add_specks(folder / f"{part}.obj", box)
        resect("render", folder / f"{part}.obj", "-o", folder / f"{part}.png", "--no-room", "--pose", "keep", "--size", "1920x1080")
    subprocess.run(["convert", folder / "balls.png", folder / "surface.png", "-crop", "760x600+580+300", "+repage", "-resize", "420x",
                    "+append", "-colors", "128", f"PNG8:{TARGET / name}.png"], check=True)
    print(f"{name}: {len(centres)} particles {1e3 * spacing:.3g} mm apart")


def main():
    build = Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else ROOT / "build" / "release"
    TARGET.mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        kernel_figure(build, folder)
        discretization_figure(build, folder, "4.5", "cut-120")
        discretization_figure(build, folder, "4.6", "cut-950")


if __name__ == "__main__":
    main()
