"""The scene that the environments share: the built-in liver on the table, held at its back by a ligament."""

import resect

#: s that a decision lasts: one frame of the simulation.
DECISION = 0.1
#: Volume of the built-in liver, m^3.
LIVER = 1.625e-3

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


def scene_text(title, tools, particles=1000, tissue="plain", young=5000.0, labels="", view="surgeon"):
    """The scenario as TOML. particles: about so many; young: Pa."""
    if tissue not in TISSUES:
        raise resect.Error(f"tissue is \"{tissue}\"; use plain or liver")
    if not 50 <= particles <= 100_000:
        raise resect.Error(f"{particles} particles were asked for; give 50 to 100000")
    text = SCENE.format(title=title, spacing=(LIVER / particles)**(1 / 3), tissue=TISSUES[tissue], young=young,
                        labels=labels, view=view)
    return text + "".join(f"[[tool]]\nmodel = \"{tool}\"\n" for tool in tools)
