"""Motions in tissue that gives way: pressing, lifting, cutting, taking off."""
from organ_path import OrganPath
from paths import Path3
from scenario_text import all_instruments, scenario


def press():
    """The baton presses on the dome, stays, lets go, and presses again beside it."""
    here, beside = (0.3888, 0.6264), (0.6462, 0.4709)
    path = OrganPath((0, 0.95, 0.3), (0, 0.3, -0.95), 0.9, here, "-63.6mm")
    path.to(here, "36.57%", 0.06).wait(0.5167).to(here, "-63.6mm", 0.15)
    path.to(beside, "-56.6mm", 0.08).to(beside, "38.63%", 0.06).wait(0.3167).to((0.6462, 0.8468), "-169.4mm", 0.2)
    return [("scalpel", None), ("hook", None), ("baton", path)]


def lift():
    """The hook enters the front margin, pulls it up and out, holds it, and pulls until it slips."""
    path = Path3(handle=(0, 0.75, 0.66), edge=(0, -0.66, 0.75), speed=0.1)
    path.wait(0.9)
    path.to(0.055, 0.12, 0.14).to(0.055, 0.022, 0.04)
    path.wait(0.1)
    path.to(0.055, 0.022, 0.04).to(0.055, 0.046, 0.056, speed=0.05)
    path.wait(0.6)
    path.to(0.055, 0.046, 0.056).to(0.055, 0.2, 0.14, speed=0.08)
    path.to(0.1, 0.24, 0.2, speed=0.3)
    return all_instruments(hook=path)


def grasp():
    """The forceps seize the left lobe near its margin, lift it, hold it, lay it down and let go."""
    path = Path3(handle=(0.2, 0.85, 0.5), edge=(0, -0.5, 0.85), speed=0.15)
    seized, lifted = (0.078, 0.028, 0.02), (0.084, 0.044, 0.022)
    path.wait(0.9)
    path.to(0.07, 0.14, 0.1).to(*seized).jaws(1.0)
    path.to(*lifted, speed=0.04)
    path.wait(0.8)
    path.to(*lifted).to(*seized, speed=0.04).jaws(0.0)
    path.to(0.07, 0.14, 0.1).to(0.1, 0.2, 0.16, speed=0.3)
    return all_instruments(forceps=path)


def incise():
    """One long cut over the dome, towards the surgeon, some two centimetres deep, and deeper where the tissue gives."""
    x = 0.4317
    path = OrganPath((0, 0.8, 0.6), (0, -0.6, 0.8), 0.9, (x, 0.2066), "-111.3mm").to((x, 0.1787), "-34.6mm", 0.12)
    for front, depth in ((0.2624, 17.6), (0.3739, 20.8), (0.4854, 24.5), (0.5969, 28.6), (0.6527, 31.8), (0.7084, 36.5),
                         (0.7642, 40.4), (0.8199, 41.8), (0.8646, 40.9)):
        path.to((x, front), f"{depth}mm", 0.05)
    path.to((x, 1.2103), "-125.7mm", 0.3).to((0.7319, 1.2806), "-235.9mm", 0.3)
    return all_instruments(scalpel=path)


def incise_under_traction():
    """The hook pulls the left lobe aside, the scalpel is drawn over it across the pull, and the wound opens."""
    caught, pulled, opened = (0.051, 0.022, 0.03), (0.061, 0.029, 0.03), (0.067, 0.033, 0.03)
    hook = Path3(handle=(0.8, 0.6, 0), edge=(0.6, -0.8, 0), speed=0.12)
    hook.wait(0.6)
    hook.to(0.125, 0.12, 0.03).to(*caught)
    hook.wait(0.1)
    hook.to(*caught).to(*pulled, speed=0.03)
    # The lobe's top along the cut, after it has sagged: the blade's edge must reach out of the tissue, or it tunnels.
    top = ((-0.005, 0.047), (0.005, 0.048), (0.015, 0.048), (0.025, 0.047), (0.035, 0.045), (0.045, 0.043),
           (0.055, 0.041), (0.065, 0.038), (0.075, 0.033))
    x, depth = 0.03, 0.018
    scalpel = Path3(handle=(0, 0.8, 0.6), edge=(0, -0.6, 0.8), speed=0.15)
    scalpel.wait(2.2)
    scalpel.to(x, 0.2, -0.03).to(x, top[0][1] + 0.03, top[0][0] - 0.01)
    for z, y in top:
        scalpel.to(x, y - depth, z, speed=0.05)
    scalpel.to(x, 0.093, 0.135, speed=0.3).to(0.05, 0.24, 0.16, speed=0.4)
    hook.wait(scalpel.time - 0.6 - hook.time)
    hook.to(*pulled).to(*opened, speed=0.03)
    hook.wait(1.2)
    hook.to(*opened)
    return all_instruments(scalpel=scalpel, hook=hook)


def snip():
    """The scissors come from the front and cut into the left lobe, snip by snip."""
    path = Path3(handle=(0, 0.42, 0.91), edge=(0, -0.91, 0.42), speed=0.1)
    path.wait(0.9)
    path.to(0.058, 0.09, 0.2, speed=0.2)
    for i in range(5):
        z = 0.078 - 0.014 * i
        path.to(0.058, 0.012 + 0.0045 * i, z, speed=0.06).snip()
    path.to(0.058, 0.09, 0.16, speed=0.15).to(0.1, 0.2, 0.2, speed=0.3)
    return all_instruments(scissors=path)


def resect_segment_elastic():
    """The hook catches the left lobe and draws it taut; the scalpel, held upright, cuts it off in four strokes along one
    plane, each deeper, the last two down to what the liver lies on; the hook lifts the piece and holds it. Under tension
    the cut opens, so that a stroke finds the plane of the one before."""
    caught, taut, lifted = (0.076, 0.014, 0.035), (0.086, 0.017, 0.035), (0.11, 0.06, 0.045)
    x, back, front, above = 0.062, -0.035, 0.12, 0.12
    hook = Path3(handle=(0.8, 0.6, 0), edge=(0.6, -0.8, 0), speed=0.15)
    hook.wait(0.6)
    hook.to(caught[0] + 0.07, above, caught[2]).to(*caught)
    hook.wait(0.1)
    hook.to(*caught).to(*taut, speed=0.03)
    scalpel = Path3(handle=(0, 1, 0.05), edge=(0, -0.05, 1), speed=0.4)
    scalpel.wait(hook.time - 0.3)
    scalpel.to(x, 0.2, back)
    for y in (0.03, 0.016, -0.006, -0.006):
        scalpel.to(x, 0.07, back).to(x, y, back).to(x, y, front, speed=0.1)
        scalpel.to(x, above, front).to(x, above, back, speed=0.6)
    scalpel.to(0.05, 0.24, 0.14, speed=0.5)
    hook.wait(scalpel.time - 0.8 - hook.time)
    hook.to(*taut).to(*lifted, speed=0.05)
    hook.wait(1.5)
    hook.to(*lifted)
    return all_instruments(scalpel=scalpel, hook=hook)


def lift_gallbladder():
    """The hook catches the fundus from the front, lifts it, holds it, lays it down and lets go."""
    path = Path3(handle=(0, 0.8, 0.6), edge=(0, -0.6, 0.8), speed=0.12)
    caught, lifted = (-0.055, 0.079, 0.08), (-0.055, 0.09, 0.0825)
    path.wait(0.8)
    path.to(-0.055, 0.2, 0.19).to(*caught)
    path.wait(0.1)
    path.to(*caught).to(*lifted, speed=0.04)
    path.wait(0.8)
    path.to(*lifted).to(*caught, speed=0.04)
    path.wait(0.2)
    path.to(*caught)
    return [("scalpel", None), ("hook", path), ("baton", None)]


def liver_and_gallbladder():
    """Two organs: the liver lies on its dome, held below; the gallbladder is on its bed above."""
    turn = "{ axis = [0.1954, 0.1288, -0.9722], degrees = 180 }"
    text = scenario("The gallbladder is lifted, and the liver follows",
                    "Hold the gallbladder up by its fundus with the hook, lay it down and let go", 6.0, lift_gallbladder(),
                    "surgeon", thesis=False)
    organs = f"""[[organ]]
name = "liver"
source = "liver"
spacing = "6mm"
rotation = {turn}  # on its dome, the fundus towards the surgeon
position = [-0.07, 0, 0]  # clear of the tray
settle = false

[organ.tissue]
model = "elastic"

[[organ.tissue.attachment]]
kind = "pin"
box = [[-0.18, -0.01, -0.1], [0.04, 0.03, 0.1]]

[[organ]]
name = "gallbladder"
source = "gallbladder"
beside = "liver"
spacing = "4mm"

[organ.tissue]
model = "elastic"
young = 8000
tear_energy = 1000
density = 1020

[[joint]]
organs = ["gallbladder", "liver"]
reach = "8mm"
stiffness = 600
"""
    head, tools = text.split("[organ]\n", 1)
    return head + organs + "\n" + tools[tools.index("[[tool]]"):]
