#!/usr/bin/env python3
"""Puts the figures that the tests of the tissue measured into docs/validation.md and its plot.

python3 make_validation.py BUILD_FOLDER/validation DOCS_FOLDER
The tests (test_tissue, test_organ) write one table per experiment: quantity, measured, reference, allowed. This replaces the table
between the marks in DOCS_FOLDER/validation.md and draws DOCS_FOLDER/images/validation.svg: each error as a share of
what the test allows.
"""
import csv
import math
import sys
from html import escape
from pathlib import Path

BEGIN, END = "<!-- figures: begin -->", "<!-- figures: end -->"
ORDER = ["moduli", "law", "law far out", "stiffening", "relaxation", "loss factor", "capsule pressed", "capsule stability", "patch", "slope", "momentum", "energy", "cut energy", "cantilever",
         "nearly incompressible beam", "turned beams", "sagging liver", "deep press", "laminate", "elastica", "frequency", "torsion", "cook", "slit", "tear energy", "tear rate", "cut force", "slicing", "cut ledger", "own weight", "hertz",
         "resolution", "substep", "stability"]


def rows_of(folder):
    """(experiment, quantity, measured, reference or None, error, allowed) in the order of the page."""
    names = [n for n in ORDER if (folder / f"{n}.csv").exists()]
    names += sorted(p.stem for p in folder.glob("*.csv") if p.stem not in ORDER)
    for name in names:
        for row in csv.DictReader((folder / f"{name}.csv").open()):
            measured, allowed = float(row["measured"]), float(row["allowed"])
            reference = float(row["reference"]) if row["reference"] else None
            error = abs(measured / reference - 1) if reference else max(0.0, measured)
            yield name, row["quantity"], measured, reference, error, allowed


def number(x):
    return f"{x:.4g}"


def percent(x):
    return f"{100 * x:.2f} %" if x >= 1e-4 else f"{x:.1e}"


def table(rows):
    lines = ["| experiment | quantity | measured | reference | error | allowed |", "|---|---|---|---|---|---|"]
    for name, quantity, measured, reference, error, allowed in rows:
        lines.append(f"| {name} | {quantity.replace(chr(124), chr(92) + chr(124))} | {number(measured)} | "
                     f"{number(reference) if reference else ''} | {percent(error)} | {percent(allowed)} |")
    return "\n".join(lines)


def plot(rows):
    """A bar per figure on a logarithmic scale of error / allowed; 1 is where the test fails."""
    height, left, width = 18, 380, 420
    total = 40 + height * len(rows)
    x = lambda share: left + width * (math.log10(min(max(share, 1e-3), 1)) + 3) / 3
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{left + width + 40}" height="{total}" '
             'font-family="sans-serif" font-size="11">', '<rect width="100%" height="100%" fill="white"/>']
    for share, told in ((1e-3, "1/1000"), (1e-2, "1/100"), (1e-1, "1/10"), (1, "allowed")):
        parts.append(f'<line x1="{x(share)}" x2="{x(share)}" y1="22" y2="{total - 8}" '
                     f'stroke="{"#c00" if share == 1 else "#ccc"}"/>')
        parts.append(f'<text x="{x(share)}" y="15" text-anchor="middle" fill="#444">{told}</text>')
    for i, (name, quantity, _, _, error, allowed) in enumerate(rows):
        y = 26 + height * i
        parts.append(f'<text x="{left - 8}" y="{y + 11}" text-anchor="end">{escape(quantity)}</text>')
        parts.append(f'<rect x="{left}" y="{y + 2}" width="{x(error / allowed) - left:.1f}" height="{height - 6}" '
                     'fill="#3a7ca5"/>')
    return "\n".join(parts) + "\n</svg>\n"


def main():
    folder, docs = Path(sys.argv[1]), Path(sys.argv[2])
    rows = list(rows_of(folder))
    if not rows:
        sys.exit(f"there are no tables in {folder}; run test_tissue in the build folder first")
    page = docs / "validation.md"
    text = page.read_text()
    before, rest = text.split(BEGIN)
    page.write_text(before + BEGIN + "\n" + table(rows) + "\n" + END + rest.split(END)[1])
    (docs / "images" / "validation.svg").write_text(plot(rows))


if __name__ == "__main__":
    main()
