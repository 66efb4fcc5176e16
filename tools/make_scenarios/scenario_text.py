"""What the scenarios share: their text, where the organ lies, what holds it, the instruments."""
import math

import lying_liver
from paths import FRAME_RATE

ASIDE = -0.07  # m: where a sagging liver is clear of the tray
INSTRUMENTS = ("scalpel", "hook", "baton", "scissors", "suction", "clip_applier", "bipolar", "gauze", "inflow_clamp",
               "pencil", "aspirator", "forceps")


def all_instruments(**paths):
    """Every instrument, in the order of their keys, those without a path on the table."""
    return [(name, paths.get(name)) for name in INSTRUMENTS]


def ligaments(x):
    """Where a living liver is held, at rest: behind the dome; x: where its middle lies, m."""
    return f"""[[tissue.attachment]]
kind = "ligament"
box = [[{x - 0.05:g}, 0.05, -0.11], [{x + 0.05:g}, 0.13, -0.07]]
stiffness = 300
"""


# The same in fractions of the organ's box.
ORGAN_LIGAMENTS = """[[tissue.attachment]]
kind = "ligament"
frame = "organ"
box = [[0.28, 0.4, -0.05], [0.72, 1.05, 0.145]]
stiffness = 300
"""


def elastic(title, description, spacing_mm, tools, extra="", tissue="", duration=None, organ="", close_up=None, x=0.0,
            setting="field", bleeds=True, tail=0.4, view="surgeon"):
    """A scenario whose tissue moves; x: organ and instruments stand so far to the side, m; tail: s after the last key."""
    if x:
        for _, path in tools:
            if path and not path.way:
                path.keys = [(time, (tip[0] + x, *tip[1:]), *rest) for time, tip, *rest in path.keys]
        organ = f"position = [{x:g}, 0, 0]  # clear of the tray\n" + organ
    text = scenario(title, description, spacing_mm, tools, view, tail=tail, duration=duration, thesis=False)
    if bleeds:
        organ += 'vessels = "built-in"\n'
    if close_up:
        text = text.replace(f'view = "{view}"\n', f'view = "{view}"\nclose_up = {close_up}\n', 1)
    if setting != "table":
        text = text.replace("[organ]", f'[room]\nsetting = "{setting}"\n\n[organ]', 1)
    settings = f'[tissue]\nmodel = "elastic"\n{tissue}\n{extra}'
    return text.replace("[[tool]]", settings.rstrip("\n") + "\n\n[[tool]]", 1).replace(
        'source = "liver"\n', 'source = "liver"\n' + organ, 1)


def way_of(path):
    """The keys of a path; if arguments of lying_liver.way() come with it, in the liver's coordinates."""
    return lying_liver.way(path, *path.way) if isinstance(path.way, tuple) else path.text()


def scenario(title, description, spacing_mm, tools, view, tail=0.4, duration=None, thesis=True):
    on_organ = any(path and path.way for _, path in tools)
    last = 0 if on_organ or duration else max(path.keys[-1][0] for _, path in tools if path)
    lines = [
        "# Written by tools/make_scenarios; change it there. Metres and seconds; docs/scenarios.md explains the keys.",
        f'title = "{title}"',
        f'description = "{description}"',
        f"frame_rate = {FRAME_RATE}",
        f"after = {tail:g}" if on_organ else f"duration = {duration or math.ceil(10 * (last + tail)) / 10:g}",
        f'view = "{view}"',
        *(['mode = "thesis"'] if thesis else []),
        "",
        "[organ]",
        'source = "liver"',
        f'spacing = "{spacing_mm:g}mm"',
        "",
    ]
    for name, path in tools:
        lines += ["[[tool]]", f'model = "{name}"', way_of(path) if path else ""]
    return "\n".join(lines).rstrip("\n") + "\n"
