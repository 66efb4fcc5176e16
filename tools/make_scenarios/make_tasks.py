#!/usr/bin/env python3
"""Writes the tasks that come with Resect: python3 make_tasks.py FOLDER [--check] [--operator NAME].

Each is a scenario whose instruments do the task as a good operator does: the reference run. With --operator the same
tasks are done by another scripted operator, for tests: hurried (fast, leaves steps out), clumsy (shaky, too deep),
reckless (leaves out what keeps it safe).
For tests of smoothness touch-and-hold has one more, tremor: the good one with a trembling hand.
"""
import argparse
import math
import random
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from bleeding import VESSEL, suck_at_vessel  # noqa: E402
from parting import cut_off_left_lateral, cut_under_traction  # noqa: E402
from paths import FRAME_RATE, Path3  # noqa: E402
from scenario_text import ASIDE, INSTRUMENTS, elastic, ligaments  # noqa: E402
from reasons import WHY_CLIP, WHY_CONTROL, WHY_LATERAL, WHY_TOUCH, WHY_TWO_HANDS, WHY_WEDGE  # noqa: E402
from soft import incise_under_traction  # noqa: E402

OPERATORS = ("good", "hurried", "clumsy", "reckless")


def quicker(path, factor, start=0.9):
    """The same way, all after `start` in a part of the time."""
    path.keys = [(round(start + max(0, time - start) * factor if time > start else time, 5), *rest)
                 for time, *rest in path.keys]
    path.time = path.keys[-1][0]
    return path


def sampled(path, rate=FRAME_RATE):
    """The keys of the path, and places between them: a list of (time, tip, squeeze, edge)."""
    keys = []
    for before, after in zip(path.keys, path.keys[1:]):
        steps = max(1, round((after[0] - before[0]) * rate))
        for i in range(steps):
            share = i / steps
            tip = tuple(a + share * (b - a) for a, b in zip(before[1], after[1]))
            keys.append((round(before[0] + share * (after[0] - before[0]), 5), tip,
                         before[2] + share * (after[2] - before[2]), before[3]))
    return keys + [path.keys[-1]]


def smooth(path, rate=30):
    """The same way, each straight part of it with the speed of a calm hand: a bell, at rest at both ends."""
    keys = []
    for before, after in zip(path.keys, path.keys[1:]):
        moves = math.dist(before[1], after[1]) > 1e-6
        steps = max(1, round((after[0] - before[0]) * rate)) if moves else 1
        for i in range(steps):
            t = i / steps
            share = t ** 3 * (10 - 15 * t + 6 * t * t)  # minimum jerk
            tip = tuple(round(a + share * (b - a), 5) for a, b in zip(before[1], after[1]))
            keys.append((round(before[0] + t * (after[0] - before[0]), 5), tip, before[2] + t * (after[2] - before[2]),
                         before[3]))
    path.keys = keys + [path.keys[-1]]
    return path


def shaken(path, size, frequency, seed):
    """The path with a shaking hand: waves of about this size, m, and frequency, Hz, along each axis."""
    dice = random.Random(seed)
    waves = [[(frequency * dice.uniform(0.8, 1.2), dice.uniform(0, 2 * math.pi)) for _ in range(3)] for _ in range(3)]
    keys = []
    for time, tip, squeeze, edge in sampled(path):
        shift = [size / 1.7 * sum(math.sin(2 * math.pi * f * time + phase) for f, phase in waves[a]) for a in range(3)]
        keys.append((time, tuple(x + d for x, d in zip(tip, shift)), squeeze, edge))
    path.keys = keys
    return path


def tremble(path, seed=1):
    """A tremor of 8 Hz and 0.3 mm."""
    return shaken(path, 0.0003, 8, seed)


def task(teaches, goal, limits, levels=None, instruments=(), steps=(), bands=(), background="", force_limit=None,
         source=None, level="medium"):
    """The table [task] as text."""
    quoted = lambda words: "[" + ", ".join(f'"{word}"' for word in words) + "]"
    number = lambda v: v if isinstance(v, str) else f"{v:g}"
    table = lambda name, values: [f"[{name}]", *(f"{key} = {number(value)}" for key, value in values.items()), ""]
    lines = ["[task]", f'teaches = "{teaches}"', f'level = "{level}"', f"instruments = {quoted(instruments)}"]
    lines += ["steps = [", *(f'  "{step}",' for step in steps), "]"]
    if background:
        lines.append(f'background = "{background}"')
    if bands:
        lines.append(f"published = {quoted(bands)}")
    if force_limit:
        lines += [f"force_limit = {force_limit:g}", f'force_limit_source = "{source}"']
    lines += ["", *table("task.goal", goal), *table("task.limits", limits)]
    for name, values in (levels or {}).items():
        lines += table(f"task.levels.{name}", values)
    return "\n".join(lines).rstrip("\n") + "\n"


def places(*points, depth=None):
    deep = "" if depth is None else f", depth = {depth:g}"
    return "[\n" + "".join(f"  {{ place = [{x:g}, {y:g}, {z:g}]{deep} }},\n" for x, y, z in points) + "]"


# Of the box of the liver at rest; and where these are once the liver has sagged, m.
TARGETS = ((0.35, 0.95, 0.45), (0.6, 0.75, 0.6), (0.75, 0.5, 0.45), (0.2, 0.75, 0.7))
TARGETS_SAGGED = ((-0.112, 0.0885, 0.0056), (-0.0487, 0.0771, 0.0416), (-0.0198, 0.051, -0.0026), (-0.1339, 0.0444, 0.0423))


def touch_and_hold(operator):
    """The baton touches four targets on the liver one after the other, and holds each."""
    good, hurried, clumsy, reckless = (operator == one for one in OPERATORS)
    path = Path3(handle=(0, 0.8, 0.6), edge=(0, 0.6, -0.8), speed=0.25 if hurried else 0.12)
    path.wait(0.9)
    press = 0.025 if reckless else 0.012 if clumsy else 0.001
    hold = 0.4 if hurried else 1.3
    path.to(-0.07, 0.22, 0.15)
    for x, y, z in TARGETS_SAGGED:
        path.to(x, y + 0.03, z + 0.02).to(x, y - press, z, speed=0.25 if reckless else 0.06)
        path.wait(hold)
        path.to(x, y - press, z).to(x, y + 0.03, z + 0.02)
    path.to(-0.07, 0.22, 0.15)
    smooth(path)
    if clumsy:
        shaken(path, 0.005, 1.3, 3)
    if operator == "tremor":
        tremble(path)
    return [("scalpel", None), ("hook", None), ("baton", path)]


def touch_and_hold_scenario(operator):
    goal = {"kind": '"touch"', "places": places(*TARGETS, depth=0), "radius": '"8mm"', "hold": 1, "with": '"baton"'}
    text = task("Camera and depth: to find a place in space, touch it gently, and rest there.", goal,
                {"force_peak_n": 1.5, "total_time_s": 25, "path_length_m": 1.6},
                {"easy": {"total_time_s": 45, "force_peak_n": 3}, "hard": {"total_time_s": 18, "force_peak_n": 1}},
                ["baton"],
                ["Bring the tip over the first target.", "Touch it, and stay for a second.",
                 "Go on to the next one, in order; where one lies behind the liver, turn the view (Ctrl + 3: from the top)."],
                background=WHY_TOUCH,
                force_limit=1.5, source="setting of the task: no limit is published for the liver")
    return elastic("Touch and hold", "Four targets on the liver are touched one after the other and held", 10.0,
                   touch_and_hold(operator), ligaments(ASIDE),
                   organ=f"position = [{ASIDE:g}, 0, 0]  # clear of the tray\n", bleeds=False) + "\n" + text


def two_hands(operator):
    """The hook pulls the left lobe aside and holds it, while the scalpel follows a line over it."""
    good, hurried, clumsy, reckless = (operator == one for one in OPERATORS)
    tools = dict(incise_under_traction())
    scalpel, hook = tools["scalpel"], tools["hook"]
    scalpel.keys = scalpel.keys[:-7 if hurried else -4]  # hurried: not to the end
    scalpel.time = scalpel.keys[-1][0]
    scalpel.keys = [(t, (x - 0.003, y, z), *rest) for t, (x, y, z), *rest in scalpel.keys]
    x, y, z = scalpel.keys[-1][1]
    scalpel.to(x, y + 0.08, z, speed=0.2).to(0.05, 0.24, 0.16, speed=0.4)
    if hurried:  # and before the hook holds
        scalpel.keys = [(round(0.9 + 0.45 * (time - 2.2), 5), *rest) for time, *rest in scalpel.keys]
    if clumsy:
        shaken(scalpel, 0.016, 0.9, 5)
        shaken(hook, 0.003, 1.3, 6)
    if reckless:  # alone, beside the line, and too deep
        scalpel.keys = [(time, (x + 0.014, y - (0.012 if y < 0.04 else 0), z), *rest)
                        for time, (x, y, z), *rest in scalpel.keys]
        hook = None
    return [("scalpel", scalpel), ("hook", hook), ("baton", None)]


def two_hands_scenario(operator):
    line = places(*((0.795, 0.45, z) for z in (0.48, 0.56, 0.64, 0.72, 0.78, 0.83)), depth=0)
    goal = {"kind": '"follow"', "places": line, "radius": '"6mm"', "with": '"scalpel"', "hold_with": '"hook"'}
    text = task("Two hands: one holds tissue under tension, the other follows a line.", goal,
                {"off_line_mm": 3, "off_line_most_mm": 8, "held_pct": 80, "force_peak_n": 4, "total_time_s": 15},
                {"easy": {"off_line_mm": 5, "off_line_most_mm": 12, "total_time_s": 30}, "hard": {"off_line_mm": 2}},
                ["scalpel", "hook"],
                ["Catch the lobe beside the line with the hook, and pull a little.",
                 "Draw the scalpel along the line while the hook holds."], background=WHY_TWO_HANDS, force_limit=4,
                source="setting of the task: no limit is published for the liver")
    return elastic("Two hands", "The hook holds the left lobe, the scalpel follows a line over it", 8.0,
                   two_hands(operator), ligaments(-0.035),
                   organ="position = [-0.035, 0, 0]  # so that the lobe does not come to lie on the tray\n",
                   close_up="[[-0.015, 0, -0.03], [0.095, 0.07, 0.08]]", bleeds=False) + "\n" + text


# The wound of `control-bleeding`, which crosses the branch of `bleed`: the ends of its line and the way into the liver;
# and where the branch and two thin arteries bleed in it.
WOUND = ((-0.0053, 0.0556, 0.044), (0.0043, 0.0484, 0.044), (-0.6, -0.8, 0.0), 0.032)
WOUNDED = (-0.0185, 0.0280, 0.0429)
SEALED = (
    (-0.0131, 0.0202, 0.0463), (-0.0056, 0.0268, 0.0469), (-0.0167, 0.0244, 0.0470), (-0.0020, 0.0276, 0.0458),
    (-0.0144, 0.0277, 0.0473), (-0.0061, 0.0343, 0.0461),
)


def control_bleeding(operator):
    """A branch of the portal vein bleeds in a wound; suction, clip and bipolar forceps stop the bleeding."""
    good, hurried, clumsy, reckless = (operator == one for one in OPERATORS)
    x, y, z = VESSEL
    suction = Path3(handle=(-0.5, 0.86, 0.1), edge=(0, -0.1, 0.86), speed=0.3)
    suction.wait(0.5)
    suction.to(-0.1, 0.2, 0.1).to(0.002, 0.049, 0.046).to(0.012, 0.042, 0.050, speed=0.02)
    suction.wait(1.0)
    suction.to(0.012, 0.042, 0.050).to(0.018, 0.034, 0.056, speed=0.02).to(-0.03, 0.09, 0.06, speed=0.1)
    clip = Path3(handle=(0.2, 0.9, 0.4), edge=(0, -0.4, 0.9), speed=0.2)
    clip.wait(1.2)
    above = (WOUNDED[0] + 0.004, WOUNDED[1] + 0.03, WOUNDED[2] + 0.01)
    clip.to(x + 0.03, 0.15, z + 0.06).to(*above).to(*WOUNDED, speed=0.08).snip(0.2).to(*above)
    clip.to(x + 0.05, 0.2, z + 0.1, speed=0.4)
    bipolar = Path3(handle=(0.1, 0.9, 0.42), edge=(0, -0.42, 0.9), speed=0.2)
    bipolar.wait(clip.time - 0.5)
    bipolar.to(x + 0.02, 0.15, z + 0.08)
    for place in SEALED:
        bipolar.to(place[0], place[1] + 0.012, place[2]).to(*place, speed=0.1).grasp(1.8)
        bipolar.to(place[0], place[1] + 0.012, place[2])
    bipolar.to(x + 0.02, 0.2, z + 0.12, speed=0.4)
    tools = {name: None for name in INSTRUMENTS}
    tools.update(suction=suction, clip_applier=clip, bipolar=bipolar)
    if hurried:  # the clip, and nothing after it
        tools["bipolar"] = None
    if clumsy:  # the clip comes late
        for name in ("suction", "clip_applier", "bipolar"):
            tools[name].keys = [(round(time + 10, 5), *rest) for time, *rest in tools[name].keys]
            shaken(tools[name], 0.006, 1.2, 7)
    if reckless:  # cuts after the vessel, and leaves
        scalpel = Path3(handle=(0.6, 0.8, 0), edge=(0.8, -0.6, 0), speed=0.12)
        scalpel.wait(0.9)
        scalpel.to(-0.05, 0.2, z + 0.008).to(-0.034, 0.075, z + 0.008)
        for px, py in ((-0.030, 0.042), (-0.022, 0.026), (-0.015, 0.0205), (-0.010, 0.026)):
            scalpel.to(px, py, z + 0.008, speed=0.05)
        scalpel.to(0.01, 0.1, z, speed=0.3).to(0.05, 0.24, 0.14, speed=0.4)
        tools.update(scalpel=scalpel, suction=None, clip_applier=None, bipolar=None)
    return list(tools.items())


def control_bleeding_scenario(operator):
    goal = {"kind": '"stop-bleeding"', "rate_ml_min": 10, "from_ml_min": 60, "hold": 1}
    text = task("Control of a bleeding vessel: clear the wound, close the vessel, then what is left.", goal,
                {"blood_loss_ml": 120, "vessels_open": 0, "bleeding_s": 60, "total_time_s": 90},
                {"easy": {"blood_loss_ml": 240, "bleeding_s": 120, "total_time_s": 180},
                 "hard": {"blood_loss_ml": 60, "bleeding_s": 30, "total_time_s": 45}},
                ["suction", "clip_applier", "bipolar", "gauze"],
                ["Close the vessel at the largest ring with a clip: point at the ring until it is white.",
                 "Suck the blood away, or press a swab on it, where it hides the wound.",
                 "Seal what still bleeds with the bipolar forceps."],
                background=WHY_CONTROL, bands=("lefor-2022",))
    line = ", ".join("{} = [{}]".format(key, ", ".join(f"{v:g}" for v in value))
                     for key, value in zip(("from", "to", "into"), WOUND))
    wound = "[[organ.wound]]\nframe = \"world\"\n{}\ndepth = {:g}\n\n".format(line.replace("], ", "]\n"), WOUND[3])
    return elastic("Control of a bleeding vessel",
                   "The liver has a wound in which a branch of the portal vein bleeds; it is to be stopped",
                   8.0, control_bleeding(operator), ligaments(ASIDE),
                   organ=f"position = [{ASIDE:g}, 0, 0]  # clear of the tray\n",
                   duration=22 if operator in ("hurried", "reckless") else None,
                   close_up="[[-0.09, 0, -0.02], [0.05, 0.09, 0.12]]").replace("[tissue]", wound + "[tissue]", 1) + "\n" + text


# A branch of a hepatic vein of 2.1 mm that runs 10 mm under the skin: its middle and its direction at rest, m; and the
# normal of the skin above it.
BRANCH, ALONG, OUT = (-0.024, 0.046, 0.045), (0.55, 0.12, 0.83), (0.56, 0.74, 0.37)
ACROSS = (0.83, 0.0, -0.55)


def at_branch(along=0.0, out=0.0, across=0.0):
    return tuple(b + along * a + out * o + across * c for b, a, o, c in zip(BRANCH, ALONG, OUT, ACROSS))


def clip_and_divide(operator):
    """Two clips close the branch on either side, and the scalpel cuts between them."""
    good, hurried, clumsy, reckless = (operator == one for one in OPERATORS)
    clip = Path3(handle=OUT, edge=(-ALONG[0], -ALONG[1], -ALONG[2]), speed=0.1)
    clip.wait(0.5)
    sides = (-0.0045,) if hurried else () if reckless else (-0.0045, 0.0045)
    clip.to(*at_branch(out=0.1))
    for side in sides:
        clip.to(*at_branch(side, 0.03)).to(*at_branch(side + (0.012 if clumsy else 0), 0.001), speed=0.03).snip()
        clip.to(*at_branch(side, 0.04))
    clip.to(*at_branch(out=0.12))
    scalpel = Path3(handle=OUT, edge=ACROSS, speed=0.12)
    scalpel.wait(clip.time if sides else 0.5)
    scalpel.to(*at_branch(out=0.1, across=-0.03)).to(*at_branch(out=0.02, across=-0.02))
    deep = -0.006 if reckless else -0.003
    for across in (-0.016, -0.008, 0.0, 0.008, 0.016):
        scalpel.to(*at_branch(out=deep, across=across), speed=0.2 if reckless else 0.03)
    scalpel.to(*at_branch(out=0.02, across=0.02)).to(*at_branch(out=0.1, across=0.03))
    if clumsy:
        shaken(clip, 0.003, 1.5, 11)
        shaken(scalpel, 0.003, 1.2, 12)
    return [("scalpel", scalpel), ("clip_applier", clip if sides else None)]


def clip_and_divide_scenario(operator):
    place = f"[{{ place = [{BRANCH[0]:g}, {BRANCH[1]:g}, {BRANCH[2]:g}], frame = \"world\" }}]"
    goal = {"kind": '"divide"', "places": place, "vessel": '"hepatic-vein"', "thinnest": '"2mm"'}
    text = task("Clip and divide: a vessel is closed on both sides before it is cut between the clips.", goal,
                {"vessels_unsealed": 0, "clips": "{ least = 2, most = 2 }", "blood_loss_ml": 15, "path_length_m": 1.2, "total_time_s": 20},
                {"easy": {"clips": "{ least = 2, most = 4 }", "blood_loss_ml": 30, "total_time_s": 60}, "hard": {"total_time_s": 14}},
                ["scalpel", "clip_applier"],
                ["Find the vein, and close it with a clip on the side of the heart.",
                 "Close it with a second clip a centimetre away.", "Cut between the two clips."], background=WHY_CLIP)
    return elastic("Clip and divide", "A branch of a hepatic vein is clipped twice and cut between the clips", 6.0,
                   clip_and_divide(operator), "", duration=None,
                   organ=f"position = [{ASIDE:g}, 0, 0]  # clear of the tray\n",
                   close_up="[[-0.09, 0, -0.02], [0.05, 0.09, 0.12]]").replace(
                       'model = "elastic"', 'model = "still"  # so that the applier gets to the vessel', 1).replace(
                       'view = "surgeon"', 'view = "surgeon"\nmode = "operation"', 1) + "\n" + text


# Of the left lateral section: the plane at rest, m, before the liver is moved aside.
PLANE_X = 0.055


def left_lateral(operator):
    """The scalpel parts the left lateral section along a plane; the hook lifts it away."""
    good, hurried, clumsy, reckless = (operator == one for one in OPERATORS)
    tools = {name: path for name, path in cut_off_left_lateral() if name in ("scalpel", "hook", "baton")}
    if hurried:  # there and back once, and away
        scalpel = Path3(handle=(0, 1, 0.05), edge=(0, -0.05, 1), speed=0.25)
        scalpel.wait(0.9)
        scalpel.to(PLANE_X, 0.2, -0.12, speed=0.4).to(PLANE_X, 0.02, -0.12, speed=0.4).to(PLANE_X, 0.02, 0.1, speed=0.3)
        scalpel.to(PLANE_X, 0.2, 0.13, speed=0.4)
        tools.update(scalpel=scalpel, hook=None)
    if clumsy:
        shaken(tools["scalpel"], 0.03, 0.7, 13)
    if reckless:  # too far in the middle of the organ
        tools["scalpel"].keys = [(t, (x - 0.035, y, z), *rest) for t, (x, y, z), *rest in tools["scalpel"].keys]
        tools["hook"] = None
    return list(tools.items())


def left_lateral_scenario(operator):
    place = f"[{{ place = [{PLANE_X + ASIDE:g}, 0.03, 0], frame = \"world\" }}]"
    goal = {"kind": '"transect"', "places": place, "normal": "[1, 0, 0]", "radius": '"20mm"', "with": '"scalpel"'}
    text = task("Left lateral sectionectomy: to keep a plane through the whole organ. The inflow counts as closed: it "
                "does not bleed.",
                goal, {"specimen_ml": "{ least = 30, most = 140 }", "off_plane_mm": 8, "removed_ml": 6,
                       "force_peak_n": 6, "total_time_s": 30},
                {"easy": {"off_plane_mm": 15, "total_time_s": 90}, "hard": {"off_plane_mm": 6}},
                ["scalpel", "hook"],
                ["Mark the plane left of the ligament.", "Cut from the upper margin to the lower one.",
                 "Pull the section aside with the hook, cut the strands that are left, and lift it away."],
                background=WHY_LATERAL, bands=("takayama", "lefor-2022"), force_limit=6,
                source="setting of the task: no limit is published for the liver")
    return elastic("Left lateral sectionectomy", "The left lateral section is parted along a plane and lifted away",
                   8.0, left_lateral(operator), ligaments(ASIDE), "cut_energy = 17  # a new blade\n", x=ASIDE,
                   bleeds=False) + "\n" + text


# A tumour near the tip of the left lobe, at rest, m, before the liver is moved aside.
TUMOUR, TUMOUR_RADIUS = (0.096, 0.022, 0.035), 0.008


def wedge(operator):
    """The scalpel cuts the tip of the left lobe off from both sides, a centimetre from the tumour; the hook pulls it aside,
    the scalpel cuts what still holds, and the hook lifts it away. The lobe is no thicker there than the blade is long."""
    good, hurried, clumsy, reckless = (operator == one for one in OPERATORS)
    there, back = (0, -0.05, 1), (0, 0.05, -1)
    scalpel = Path3(handle=(0, 1, 0.05), edge=there, speed=0.15)

    def cut_off(x, speed):
        scalpel.to(x, 0.16, -0.06, speed=0.4).to(x, 0.001, -0.06, speed=0.4).to(x, 0.001, 0.13, speed=speed)
        scalpel.turn(back).to(x, 0.001, 0.15, speed=0.1).to(x, 0.001, -0.05, speed=speed)
        scalpel.turn(there).to(x, 0.12, -0.06, speed=0.4).to(0.05, 0.24, 0.14, speed=0.5)

    x = 0.077 if not reckless else 0.092  # through the tumour
    scalpel.wait(0.9)
    cut_off(x, 0.12)
    if hurried:  # once, and away
        scalpel.keys = scalpel.keys[:4]
        scalpel.time = scalpel.keys[-1][0]
        return [("scalpel", quicker(scalpel.to(0.05, 0.24, 0.16, speed=0.6), 0.7)), ("hook", None)]
    hook = cut_under_traction(scalpel, lambda: cut_off(x + 0.004, 0.15), (0.188, 0.13, 0.04), (0.098, 0.012, 0.035),
                              (0.118, 0.026, 0.04), (0.158, 0.075, 0.055))
    if clumsy:
        shaken(scalpel, 0.016, 0.6, 17)
    return [("scalpel", scalpel), ("hook", hook)]


def wedge_scenario(operator):
    x, y, z = TUMOUR
    label = (f"[[organ.label]]\nlabel = 1\nname = \"tumour\"\ncentre = [{x + ASIDE:g}, {y:g}, {z:g}]\n"
             f"radius = {TUMOUR_RADIUS:g}\n\n")
    goal = {"kind": '"resect"', "structure": '"tumour"', "margin": '"10mm"'}
    text = task("Wedge resection: a tumour is taken out in one piece with a margin on all sides.", goal,
                {"specimen_ml": 70, "removed_ml": 5, "force_peak_n": 6, "total_time_s": 25},
                {"easy": {"specimen_ml": 100, "total_time_s": 60}, "hard": {"specimen_ml": 50}},
                ["scalpel", "hook"],
                ["Mark a margin of a centimetre round the tumour.", "Cut one side of the wedge, then the other.",
                 "Take the specimen off and look at its margin."], background=WHY_WEDGE, bands=("lefor-2022",),
                force_limit=6,
                source="setting of the task: no limit is published for the liver")
    text = elastic("Wedge resection of a tumour", "A marked tumour is taken out of the left lobe with a margin", 6.0,
                   wedge(operator), ligaments(ASIDE), "cut_energy = 17  # a new blade\n", x=ASIDE,
                   bleeds=False) + "\n" + text
    return text.replace("[tissue]\n", label + "[tissue]\n", 1)


TASKS = {"touch-and-hold": touch_and_hold_scenario, "two-hands": two_hands_scenario,
         "control-bleeding": control_bleeding_scenario, "clip-and-divide": clip_and_divide_scenario,
         "wedge-resection": wedge_scenario, "left-lateral": left_lateral_scenario}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--check", action="store_true", help="write nothing; fail if a file is not as written here")
    parser.add_argument("--operator", choices=OPERATORS, default="good")
    options = parser.parse_args()
    stale = []
    for name, make in TASKS.items():
        file, text = options.folder / f"{name}.toml", make(options.operator)
        if not options.check:
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)
        elif not file.exists() or file.read_text() != text:
            stale.append(str(file))
    if stale:
        sys.exit("not what tools/make_scenarios/make_tasks.py writes: " + ", ".join(stale))


if __name__ == "__main__":
    main()
