"""The scene that the environments share: the built-in liver on the table, held at its back by a ligament."""

import resect

#: s that a decision lasts: one frame of the simulation.
DECISION = 0.1
#: Volume of the built-in liver, m^3.
LIVER = 1.625e-3
#: Pa: least and largest Young's modulus.
YOUNG = 1, 1e8

#: tissue="plain": elastic, without capsule, relaxation and resistance to a blade, the fastest. "liver": with all of
#: them (docs/methods/tissue.md).
TISSUES = {"plain": "plain = true", "liver": ""}

SCENE = """
title = "{title}"
mode = "operation"
frame_rate = 10
duration = 60
view = "{view}"
close_up = [[-0.12, 0, -0.11], [0.12, 0.13, 0.11]]
[room]
tool_box = false
[organ]
source = "liver"
spacing = {spacing:.6f}
{labels}
[tissue]
model = "elastic"
young = {young}
{tissue}
[[tissue.attachment]]
kind = "ligament"
frame = "organ"
box = [[0.25, 0.35, 0.0], [0.75, 1.0, 0.22]]
stiffness = 300
"""


def number(value, name, low, high):
    """`value` as a float; resect.Error if it is not a number from `low` to `high`. name: what it is called."""
    try:
        one = float(value)
    except (TypeError, ValueError):
        one = float("nan")
    if not low <= one <= high:
        raise resect.Error(f"{name} is {value!r}; give a number from {low:g} to {high:g}")
    return one


def whole_number(value, name, low, high):
    """As number(), for an int."""
    one = number(value, name, low, high)
    if one != int(one):
        raise resect.Error(f"{name} is {value!r}; give a whole number from {low} to {high}")
    return int(one) if isinstance(value, str) else int(value)  # a float does not hold every large number


def scene_text(title, tools, particles=1000, tissue="plain", young=5000.0, labels="", view="surgeon"):
    """The scenario as TOML. particles: about so many; young: Pa."""
    if tissue not in TISSUES:
        raise resect.Error(f"tissue is \"{tissue}\"; use plain or liver")
    particles = number(particles, "particles", 50, 100_000)
    text = SCENE.format(title=title, spacing=(LIVER / particles)**(1 / 3), tissue=TISSUES[tissue],
                        young=number(young, "young", *YOUNG), labels=labels, view=view)
    return text + "".join(f"[[tool]]\nmodel = \"{tool}\"\n" for tool in tools)
