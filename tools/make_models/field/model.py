"""The file of the operative field."""

from field.light import light_over
from field.retractors import blades
from field.sheet import sheet_text
from field.viscera import cavity_floor, colon, stomach
from field.wall import drape, pads, wound_edge
from inventor import HEADER, Material, comment

# Specular colour and shininess for the shaders of steel; the colours stand at each point.
STEEL = Material((0.80, 0.82, 0.84), (0.75, 0.75, 0.75), 0.55)
WET = Material((0.6, 0.4, 0.3), (0.2, 0.2, 0.2), 0.3)
CLOTH = Material((0.10, 0.36, 0.30), (0.03, 0.05, 0.05), 0.05)
# In the order in which they are drawn: what hides others comes first.
PARTS = ("steel", "gut", "drape", "skin", "fat", "muscle", "omentum")

DESCRIPTION = """
Operative field: an abdomen opened for surgery of the liver, without the liver; in metres. The floor
is at y = 0 with the origin in its middle, the surgeon stands at +Z, the patient's left is at +X.
Each part is named by its tissue. Colours contain the light that neighbours take away.
"""


def files():
    """{file name: text} of the field."""
    sheets = [drape(), *wound_edge(), *pads(), *cavity_floor(), colon(), stomach(), *blades()]
    light = light_over(sheets)
    text = HEADER + "\n" + comment(DESCRIPTION) + "\nSeparator {\n"
    for part in PARTS:
        material = {"steel": STEEL, "drape": CLOTH}.get(part, WET)
        text += f"  DEF {part} Separator {{\n" + material.text("    ")
        text += "    MaterialBinding {\n      value PER_VERTEX\n    }\n"
        for sheet in sheets:
            if sheet.part == part:
                text += "    Separator {\n" + sheet_text(sheet, light, "      ") + "    }\n"
        text += "  }\n"
    return {"field.iv": text + "}\n"}
