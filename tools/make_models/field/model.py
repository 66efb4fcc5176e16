"""The file of the operative field."""

from field.light import light_over
from field.retractors import blades
from field.sheet import sheet_text
from field.viscera import cavity_floor, colon, dome, stomach
from field.wall import drape, pads, wound_edge
from inventor import HEADER, Material, comment

# Specular colour and shininess for the shaders of steel; the colours stand at each point.
STEEL = Material((0.50, 0.52, 0.54), (0.40, 0.40, 0.40), 0.15)
WET = Material((0.6, 0.4, 0.3), (0.2, 0.2, 0.2), 0.3)
CLOTH = Material((0.10, 0.36, 0.30), (0.03, 0.05, 0.05), 0.05)
# In the order in which they are drawn: what hides others comes first.
PARTS = ("steel", "gut", "drape", "skin", "fat", "muscle", "dome", "omentum")

DESCRIPTION = """
Operative field: an abdomen opened for surgery of the liver, without the liver; in metres. The floor
is at y = 0 with the origin in its middle, the surgeon stands at +Z, the patient's left is at +X.
Each part is named by its tissue. Colours contain the light that neighbours take away. The dome is the
wall as a laparoscope sees it, in place of drapes, layers and blades.
"""


def unshaded(point, normal):
    """Of the dome, which is seen without what the light was worked out for."""
    return 1.0


def files():
    """{file name: text} of the field."""
    sheets = [drape(), *wound_edge(), *pads(), *cavity_floor(), colon(), stomach(), *blades(), dome()]
    light = light_over(sheets)
    text = HEADER + "\n" + comment(DESCRIPTION) + "\nSeparator {\n"
    for part in PARTS:
        material = {"steel": STEEL, "drape": CLOTH}.get(part, WET)
        text += f"  DEF {part} Separator {{\n" + material.text("    ")
        if part == "dome":  # its back is not drawn: the camera may stand outside
            hints = "vertexOrdering COUNTERCLOCKWISE shapeType SOLID"
            text += f"    ShapeHints {{\n      {hints}\n    }}\n"
        text += "    MaterialBinding {\n      value PER_VERTEX\n    }\n"
        for sheet in sheets:
            if sheet.part == part:
                text += "    Separator {\n" + sheet_text(sheet, light if part != "dome" else unshaded, "      ") + "    }\n"
        text += "  }\n"
    return {"field.iv": text + "}\n"}
