#!/usr/bin/env python3
"""Draws docs/images/layers.svg from tools/layers.txt.

One row per storey, the ground at the bottom: a layer stands one storey above the highest layer that
it may include. A layer without a folder in src/ is drawn with a dashed line: it is not built yet.
With --check: writes nothing, exits with 1 when the drawing is not what it would draw.
"""

import sys
from pathlib import Path
from xml.sax.saxutils import escape

ROOT = Path(__file__).resolve().parent.parent
DRAWING = ROOT / "docs" / "images" / "layers.svg"
WIDTH, STOREY, BOX, NAME = 760, 44, 36, 130
# Background and outline by what a layer is about: ground, tissue, operation, outside world.
COLOURS = {
    "ground": ("#e8eef5", "#5b7fa6"), "tissue": ("#f7e6e2", "#b4553f"),
    "operation": ("#e9f2e4", "#5f8a45"), "outside": ("#f4eedc", "#a98a34"),
}
ABOUT = {
    "base": "ground", "geometry": "ground", "collision": "ground",
    "sph": "tissue", "isosurface": "tissue", "wound": "tissue", "surface": "tissue", "tissue": "tissue", "organ": "tissue",
    "tools": "operation", "simulation": "operation", "operation": "operation", "haptics": "operation",
    "skills": "operation",
}


def read_layers():
    """[(name, layers it may include, what it is for)] in the order of the file."""
    layers = []
    for line in (ROOT / "tools" / "layers.txt").read_text().splitlines():
        rule, _, purpose = line.partition("#")
        name, colon, below = rule.partition(":")
        if colon:
            above = [layer[0] for layer in layers]
            layers.append((name.strip(), above if below.split() == ["*"] else below.split(), purpose.strip()))
    return layers


def storeys(layers):
    """Rows of layers, the ground first."""
    height = {}
    for name, below, _ in layers:
        height[name] = 1 + max((height[other] for other in below), default=-1)
    rows = [[] for _ in range(max(height.values()) + 1)]
    for layer in layers:
        rows[height[layer[0]]].append(layer)
    return rows


def drawing(rows):
    high = STOREY * len(rows) + 34
    out = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{high}" '
        f'viewBox="0 0 {WIDTH} {high}" font-family="sans-serif">',
        f'<rect width="{WIDTH}" height="{high}" fill="white"/>',
    ]
    for storey, row in enumerate(rows):
        y = 8 + STOREY * (len(rows) - 1 - storey)
        width = (WIDTH - 16 - 8 * (len(row) - 1)) / len(row)
        for place, (name, _, purpose) in enumerate(row):
            x = 8 + place * (width + 8)
            fill, line = COLOURS[ABOUT.get(name, "outside")]
            dashed = "" if (ROOT / "src" / name).is_dir() else ' stroke-dasharray="5 4"'
            indent = NAME if len(row) == 1 else 100
            out += [
                f'<rect x="{x:g}" y="{y}" width="{width:g}" height="{BOX}" rx="5" fill="{fill}" '
                f'stroke="{line}"{dashed}/>',
                f'<text x="{x + 14:g}" y="{y + 23}" font-size="15" font-weight="bold" '
                f'fill="{line}">{escape(name)}</text>',
                f'<text x="{x + indent:g}" y="{y + 23}" font-size="13" fill="#333">{escape(purpose)}</text>',
            ]
    out.append(f'<text x="14" y="{high - 10}" font-size="12" fill="#666">Each layer includes only what '
               'lies below it. Dashed: not built yet.</text>')
    return "\n".join(out + ["</svg>", ""])


def main():
    wanted = drawing(storeys(read_layers()))
    if sys.argv[1:] == ["--check"]:
        if DRAWING.is_file() and DRAWING.read_text() == wanted:
            return 0
        print("docs/images/layers.svg is not what tools/layers.txt says; run tools/draw_layers.py")
        return 1
    DRAWING.parent.mkdir(parents=True, exist_ok=True)
    DRAWING.write_text(wanted)
    return 0


if __name__ == "__main__":
    sys.exit(main())
