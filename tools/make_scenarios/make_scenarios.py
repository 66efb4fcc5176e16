#!/usr/bin/env python3
"""Writes the scenarios that come with Resect: python3 make_scenarios.py FOLDER [--check].

The organ is the built-in liver at rest on the table: x -0.11 to 0.11, y 0 to 0.125, z -0.10 to 0.10 m. An instrument's
position is its tip.
"""
import sys
from pathlib import Path

import bleeding
import soft
import thesis
from scenario_text import ASIDE, ORGAN_LIGAMENTS, elastic, ligaments, scenario

SIZES = {  # name: (spacing in mm, what people are told)
    "120": (24.6, " (120 particles, as in the thesis)"),
    "950": (11.96, " (950 particles, as in the thesis)"),
    "": (5.0, ""),
}
PROMISES = {  # what the titles say (docs/scenarios.md)
    **{kind + size: ["removal"] for kind in ("cut", "perforate", "deform") for size in ("", "-120", "-950")},
    "resect-segment": ["removal", "parts"], "resect-segment-elastic": ["cut", "parts"],
    "incise": ["cut"], "incise-under-traction": ["cut"], "snip": ["cut"], "press": ["push"], "lift": ["push"],
    "grasp": ["push"], "bleed": ["blood"], "stop-bleeding": ["blood"], "pringle": ["blood"], "cautery": ["blood"],
    "transect": ["dry"]}
PINNED_TOP = """[[tissue.attachment]]
kind = "pin"
box = [[-0.08, 0.19, -0.08], [0.06, 0.25, 0.05]]
"""


# What pictures of work on the left lobe show, m.
LEFT_LOBE = "[[-0.10, 0, -0.03], [0.06, 0.10, 0.12]]"


def no_tools():
    return [("scalpel", None), ("hook", None), ("baton", None)]


def all_scenarios():
    kinds = {
        "cut": (thesis.cut, "Cut across the dome", "Draw a groove over the dome with the scalpel, from the far side towards you"),
        "perforate": (thesis.perforate, "Three holes through the liver", "Drive the baton from the dome to the table, three times"),
        "deform": (thesis.deform, "Hollow out the dome", "Rake the dome away with the hook, pass by pass"),
    }
    for kind, (make, title, description) in kinds.items():
        for size, (spacing_mm, told) in SIZES.items():
            name = kind + ("-" + size if size else "")
            yield name, scenario(title + told, description, spacing_mm, make(spacing_mm / 1000), "surgeon")
    yield "resect-segment", scenario(
        "Left lateral part of the liver taken off", "Divide the liver completely with the scalpel, in three strokes",
        3.0, thesis.resect_segment(0.003), "surgeon", tail=0.8)
    yield "press", elastic("The baton presses on a soft liver", "Press the liver with the baton, twice", 8.0,
                           soft.press(), ORGAN_LIGAMENTS, x=ASIDE, setting="table", bleeds=False)
    yield "lift", elastic("The hook lifts the margin of the liver", "Catch the lobe with the hook, pull and hold it; pulled too far, it slips", 8.0, soft.lift(),
                          ligaments(ASIDE), x=ASIDE,
                          close_up=LEFT_LOBE)
    yield "grasp", elastic("Forceps lift the left lobe", "Seize the liver near its margin, lift it, lay it down and let go",
                           8.0, soft.grasp(), ligaments(ASIDE), x=ASIDE, close_up=LEFT_LOBE, view="top")
    yield "incise", elastic("An incision over the dome", "Draw the scalpel over the dome, towards you; the wound bleeds",
                            8.0, soft.incise(), ORGAN_LIGAMENTS, x=ASIDE,
                            close_up="[[-0.13, 0.05, -0.05], [-0.05, 0.1, 0.06]]")
    yield "incise-under-traction", elastic(
        "An incision under traction", "Pull with the hook and cut across the pull with the scalpel; the wound opens", 6.0,
        soft.incise_under_traction(), ligaments(-0.035),
        organ="position = [-0.035, 0, 0]  # so that the lobe does not come to lie on the tray\n",
        close_up="[[-0.015, 0, -0.03], [0.095, 0.07, 0.08]]")
    bleeds = f"position = [{ASIDE:g}, 0, 0]  # clear of the tray\n"
    yield "bleed", elastic(
        "A branch of the portal vein bleeds", "Cut a branch of 3 mm with the scalpel; blood wells up, runs and pools", 8.0,
        bleeding.bleed(), ligaments(ASIDE), organ=bleeds, duration=12, close_up="[[-0.09, 0, -0.02], [0.05, 0.09, 0.12]]")
    yield "stop-bleeding", elastic(
        "Bleeding is brought down", "Cut a branch of the portal vein; clear the wound with suction, "
        "close the vessel with a clip, seal the rest with bipolar forceps", 8.0,
        bleeding.stop_bleeding(), ligaments(ASIDE), organ=bleeds, close_up="[[-0.09, 0, -0.02], [0.05, 0.09, 0.12]]")
    yield "transect", elastic(
        "Part of a left lateral sectionectomy", "Clamp the inflow, bare the vessels with the aspirator, clip and divide "
        "them, coagulate what bleeds", 8.0, bleeding.transect(), ligaments(ASIDE), organ=bleeds,
        close_up="[[-0.09, 0, -0.02], [0.05, 0.09, 0.12]]")
    yield "bare-clip-divide", elastic(
        "A vein is bared, clipped and divided", "Free a hepatic vein of 3 mm with the aspirator, close it with two clips, "
        "and cut it between them", 8.0, bleeding.bare_clip_divide(), ligaments(ASIDE), organ=bleeds,
        close_up="[[-0.03, 0, -0.02], [0.045, 0.06, 0.05]]", view="top")
    yield "pringle", elastic(
        "The inflow is clamped",
        "A cut bleeds; clamp the portal pedicle, which stops what flows in until the clamp is opened", 8.0,
        bleeding.pringle(), ligaments(ASIDE), organ=bleeds, close_up="[[-0.09, 0, -0.02], [0.05, 0.09, 0.12]]")
    yield "cautery", elastic(
        "A raw surface is coagulated", "Small arteries bleed where the aspirator took tissue away; seal them with the pencil", 8.0,
        bleeding.cautery(), ligaments(ASIDE), organ=bleeds, close_up="[[-0.09, 0, -0.02], [0.05, 0.09, 0.12]]", view="top")
    yield "snip", elastic("Scissors cut into the left lobe", "Cut with the scissors, snip by snip, from the front; no tissue is lost, but blood", 8.0,
                          soft.snip(), ligaments(ASIDE), x=ASIDE,
                          close_up=LEFT_LOBE)
    yield "resect-segment-elastic", elastic(
        "A piece of a soft liver taken off",
        "Draw the left lobe taut with the hook, cut it off with the scalpel, and lift the piece away", 8.0,
        soft.resect_segment_elastic(), ligaments(ASIDE), "cut_energy = 17  # a new blade\n", x=ASIDE,
        close_up=LEFT_LOBE, tail=-0.05)  # ends while the hook holds the piece
    yield "liver-and-gallbladder", soft.liver_and_gallbladder()
    yield "hang", elastic("The liver hangs from its dome", "Pinned at the top, it sags and swings under its weight", 8.0,
                          no_tools(), PINNED_TOP, 'drag = 1\n', duration=3, organ="position = [0, 0.12, 0]\n",
                          setting="table", bleeds=False)
    yield "drop", elastic("The liver is dropped on the table", "From 12 cm; it flattens, and comes to rest", 8.0,
                          no_tools(), "", 'drag = 1.5\n', duration=3, organ=f"position = [{ASIDE:g}, 0.12, 0]  # clear of the tray\n",
                          setting="table", bleeds=False)


def main():
    folder, check = Path(sys.argv[1]), "--check" in sys.argv
    stale = []
    for name, text in all_scenarios():
        if name in PROMISES:
            words = ", ".join(f'"{word}"' for word in PROMISES[name])
            text = text.replace("\nframe_rate", f"\npromises = [{words}]\nframe_rate", 1)
        file = folder / f"{name}.toml"
        if not check:
            file.write_text(text)
        elif not file.exists() or file.read_text() != text:
            stale.append(str(file))
    if stale:
        sys.exit("not what tools/make_scenarios writes: " + ", ".join(stale))


if __name__ == "__main__":
    main()
