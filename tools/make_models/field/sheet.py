"""Surfaces as rows of points with a colour at each, and how they are written as an Inventor file."""

import math

from shapes.vector import cross, dot, scale, subtract


class Sheet:
    """Rows of points, m; every row has as many. `closed`: a row's last point is followed by its
    first. `colour(point, row, column)`: sRGB, 0 to 1. `part`: the tissue, which names the shader.
    The front is where rows x columns points to."""

    def __init__(self, part, rows, colour, closed=True):
        self.part = part
        self.closed = closed
        self.rows = [list(row) + [row[0]] if closed else list(row) for row in rows]
        self.colours = [
            [colour(p, i, j) for j, p in enumerate(row)] for i, row in enumerate(self.rows)
        ]

    def normals(self):
        count, width = len(self.rows), len(self.rows[0])

        def along(i, j):
            a, b = max(i - 1, 0), min(i + 1, count - 1)
            return subtract(self.rows[b][j], self.rows[a][j])

        def across(i, j):
            if self.closed:
                a, b = (j - 1) % (width - 1), (j + 1) % (width - 1)
            else:
                a, b = max(j - 1, 0), min(j + 1, width - 1)
            return subtract(self.rows[i][b], self.rows[i][a])

        def normal(i, j):
            n = cross(along(i, j), across(i, j))
            size = math.sqrt(dot(n, n))
            return scale(n, 1.0 / size) if size > 0.0 else (0.0, 1.0, 0.0)

        return [[normal(i, j) for j in range(width)] for i in range(count)]


def mix(a, b, share):
    return tuple(x + (y - x) * share for x, y in zip(a, b))


def _number(x, decimals):
    text = f"{x:.{decimals}f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text.replace("0.", ".", 1) if abs(x) < 1 else text


def _listing(words, indent, separator=", ", width=118):
    lines, line = [], ""
    for word in words:
        if line and len(indent) + len(line) + len(separator) + len(word) > width:
            lines.append(indent + line + separator.rstrip())
            line = ""
        line += (separator if line else "") + word
    return "\n".join(lines + [indent + line]) + "\n"


def sheet_text(sheet, light, indent):
    """The nodes of one sheet. `light(point, normal)`: the share of the room's light that arrives
    there, 0 to 1; it is written into the colours."""
    normals = sheet.normals()
    points, directions, colours = [], [], []
    for row, row_normals, row_colours in zip(sheet.rows, normals, sheet.colours):
        for p, n, c in zip(row, row_normals, row_colours):
            shade = light(p, n)
            points.append(" ".join(_number(x, 4) for x in p))
            directions.append(" ".join(_number(x, 2) for x in n))
            r, g, b = (round(255.0 * min(max(x * shade, 0.0), 1.0)) for x in c)
            colours.append(f"0x{r:02x}{g:02x}{b:02x}ff")
    inner = indent + "  "
    text = f"{indent}PackedColor {{\n{inner}orderedRGBA [\n"
    text += _listing(colours, inner) + f"{inner}]\n{indent}}}\n"
    text += f"{indent}Coordinate3 {{\n{inner}point [\n"
    text += _listing(points, inner) + f"{inner}]\n{indent}}}\n"
    text += f"{indent}Normal {{\n{inner}vector [\n"
    text += _listing(directions, inner) + f"{inner}]\n{indent}}}\n"
    text += f"{indent}QuadMesh {{\n{inner}verticesPerColumn {len(sheet.rows)}\n"
    return text + f"{inner}verticesPerRow {len(sheet.rows[0])}\n{indent}}}\n"
