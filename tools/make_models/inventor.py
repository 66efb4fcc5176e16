"""Open Inventor 2.1 ascii text of the models: materials and TriangleStripSets with a normal for
every vertex."""

import textwrap

from shapes.normals import corner_normals
from shapes.strips import make_strips

HEADER = "#Inventor V2.1 ascii\n"


class Material:
    """Colours in 0..1; shininess in 0..1 (Inventor's 1 is OpenGL's exponent 128)."""

    def __init__(self, diffuse, specular, shininess, ambient=None):
        self.diffuse = diffuse
        self.specular = specular
        self.shininess = shininess
        self.ambient = ambient if ambient else tuple(0.35 * x for x in diffuse)

    def text(self, indent):
        lines = [
            "Material {",
            f"  ambientColor {numbers(self.ambient, 3)}",
            f"  diffuseColor {numbers(self.diffuse, 3)}",
            f"  specularColor {numbers(self.specular, 3)}",
            f"  shininess {number(self.shininess, 3)}",
            "}",
        ]
        return "".join(f"{indent}{line}\n" for line in lines)


def number(x, decimals):
    """Shortest decimal text of x rounded to `decimals` places."""
    text = f"{x:.{decimals}f}"
    if "." in text:
        text = text.rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


def numbers(values, decimals):
    return " ".join(number(x, decimals) for x in values)


def comment(text):
    """The text as comment lines of at most 100 characters; an empty line begins a paragraph."""
    lines = []
    for paragraph in text.strip().split("\n\n"):
        lines += textwrap.wrap(paragraph, 98, break_on_hyphens=False) + [""]
    return "".join(f"# {line}".rstrip() + "\n" for line in lines[:-1])


def model_text(description, surface, materials, decimals=7, crease_degrees=50.0, before=None):
    """The whole file: one Separator for each part of the surface, in the order of `materials`
    {part: Material}. `before`: {part: text of nodes that begin its Separator}."""
    normals = corner_normals(surface, crease_degrees)
    text = HEADER + "\n" + comment(description) + "\nSeparator {\n"
    text += "  ShapeHints {\n    vertexOrdering COUNTERCLOCKWISE\n    shapeType SOLID\n  }\n"
    for part, material in materials.items():
        corners = [
            tuple(zip(triangle, normals[k]))
            for k, triangle in enumerate(surface.triangles)
            if surface.parts[k] == part
        ]
        name = "" if part == "all" else f"DEF {part} "
        text += f"  {name}Separator {{\n"
        text += textwrap.indent((before or {}).get(part, ""), "    ")
        text += material.text("    ")
        text += strip_set(make_strips(corners), surface.points, decimals, "    ") + "  }\n"
    return text + "}\n"


def strip_set(strips, points, decimals, indent):
    """Coordinate3, Normal and TriangleStripSet of `strips`, whose entries are (point index,
    normal)."""
    positions = [[numbers(points[p], decimals) for p, _ in strip] for strip in strips]
    normals = [[numbers(n, 4) for _, n in strip] for strip in strips]
    counts = [str(len(strip)) for strip in strips]
    text = (
        f"{indent}Coordinate3 {{\n{indent}  point [\n"
        + _rows(positions, indent)
        + f"{indent}  ]\n{indent}}}\n"
    )
    text += (
        f"{indent}Normal {{\n{indent}  vector [\n"
        + _rows(normals, indent)
        + f"{indent}  ]\n{indent}}}\n"
    )
    text += f"{indent}NormalBinding {{\n{indent}  value PER_VERTEX\n{indent}}}\n"
    text += f"{indent}TriangleStripSet {{\n{indent}  numVertices [\n"
    text += "".join(
        f"{indent}    {', '.join(counts[i:i + 24])},\n" for i in range(0, len(counts), 24)
    )
    return text + f"{indent}  ]\n{indent}}}\n"


def _rows(strips, indent, per_line=4):
    """Comma-separated vectors, a few on a line, each strip on lines of its own."""
    lines = []
    for strip in strips:
        for i in range(0, len(strip), per_line):
            lines.append(f"{indent}    {', '.join(strip[i:i + per_line])},\n")
    return "".join(lines)
