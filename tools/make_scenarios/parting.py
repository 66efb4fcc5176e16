"""How the exercises part a piece: the scalpel first, then the hook pulls and the scalpel cuts what is left."""
from paths import Path3
from scenario_text import all_instruments


def cut_under_traction(scalpel, cut, beside, caught, pulled, lifted):
    """After the scalpel's way so far: the hook comes from `beside`, catches the part and pulls it aside, the scalpel cuts
    the strands that are left, and the hook lifts the part away. The hook's way."""
    hook = Path3(handle=(0.45, 0.85, 0.27), edge=(0.85, -0.52, 0.1), speed=0.15)
    hook.wait(scalpel.time + 0.2)
    hook.to(*beside, speed=0.3).to(*caught)
    hook.wait(0.1)
    hook.to(*caught).to(*pulled, speed=0.06)
    scalpel.wait(hook.time - scalpel.time)
    scalpel.to(0.05, 0.24, 0.14)
    cut()
    hook.wait(scalpel.time - hook.time - 1)
    hook.to(*pulled).to(*lifted, speed=0.06)
    hook.wait(0.6)
    hook.to(*lifted)
    return hook


def cut_off_left_lateral():
    """The scalpel, held upright, cuts the left lateral part off from both sides; the hook pulls it aside, and the
    scalpel cuts the strands that are left; the hook lifts the part away."""
    x, there, back = 0.062, (0, -0.05, 1), (0, 0.05, -1)
    scalpel = Path3(handle=(0, 1, 0.05), edge=there, speed=0.15)

    def cut_off(x, speed, y=0.001):
        """There, and back with the edge turned: where a cut leaves the tissue, the last of it gives way uncut."""
        scalpel.to(x, 0.2, -0.12, speed=0.4).to(x, y, -0.12, speed=0.4).to(x, y, 0.13, speed=speed)
        scalpel.turn(back).to(x, y, 0.16, speed=0.1).to(x, y, -0.06, speed=speed)
        scalpel.turn(there).to(x, 0.14, -0.06, speed=0.4).to(0.05, 0.24, 0.14, speed=0.5)

    scalpel.wait(0.9)
    cut_off(x, 0.12)
    hook = cut_under_traction(scalpel, lambda: cut_off(0.07, 0.15, 0.006), (0.17, 0.13, 0.03), (0.075, 0.016, 0.02),
                              (0.108, 0.034, 0.025), (0.14, 0.075, 0.04))
    return all_instruments(scalpel=scalpel, hook=hook)
