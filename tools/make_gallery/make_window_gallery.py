#!/usr/bin/env python3
"""Plays the figures of the original thesis in the window, on a virtual screen, and writes docs/gallery/window/*.png:
before, during and after, side by side; and into docs/images window.png and exercise.png, the whole window, and
window.gif, an operation in motion.

    make_window_gallery.py [--program PROGRAM] [NAME ...]      names as in FIGURES, "window", "exercise" or "gif"; all without

Needs Xvfb, xdotool and ImageMagick's convert.
"""
import argparse
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "test" / "app"))
from screen import Screen, Window  # noqa: E402

# Name, scenario, seconds of its motions at which the middle picture is taken.
FIGURES = [("5.1", "cut-120", 3.9), ("5.2", "deform-120", 13), ("5.3", "cut-950", 2.9), ("5.4", "perforate-950", 3.2),
           ("5.5", "deform-950", 8.4), ("5mm-cut", "cut", 2.9), ("5mm-perforate", "perforate", 3.2),
           ("5mm-deform", "deform", 11)]
ANIMATED, FIRST, LAST, STEP = "cut", 0.4, 5.8, 0.12  # scenario; s


def opened(program, screen, scenario):
    window = Window(program, screen, scenario, "--size", "1300x800")
    window.wait("ready", 300)
    window.tell("picture-size 960 770")
    window.wait("places")
    return window


def picture(window, file, play=None):
    if play is not None:
        window.tell(f"play {play}")
        window.wait("played", 120)
    window.tell(f"save-picture {file}")
    window.wait("written ", 60)


def make_figure(program, screen, folder, name, scenario, during):
    window = opened(program, screen, scenario)
    try:
        picture(window, folder / "before.png")
        picture(window, folder / "during.png", during)
        picture(window, folder / "after.png", 1000)
    finally:
        window.quit()
    target = ROOT / "docs" / "gallery" / "window" / f"{name}.png"
    subprocess.run(["convert", *(folder / f"{part}.png" for part in ("before", "during", "after")), "-crop", "832x468+0+125",
                    "+repage", "-resize", "426x240", "+append", "-colors", "200", f"PNG8:{target}"], check=True)
    print(target.relative_to(ROOT), target.stat().st_size // 1024, "KB", flush=True)


def make_window(program, folder, name, scenario, until, rest):
    """The whole window, `rest` seconds after the scenario's motions were played until then."""
    screen = Screen(folder, 1240, 800)  # no larger than the window
    try:
        window = Window(program, screen, *scenario, "--size", "1240x800")
        try:
            window.wait("ready", 300)
            window.tell(f"play {until}")
            window.wait("played", 120)
            time.sleep(rest)
            screen.picture(name)
        finally:
            window.quit()
    finally:
        screen.close()
    target = ROOT / "docs" / "images" / f"{name}.png"
    subprocess.run(["convert", folder / f"{name}.png", "-resize", "930x", "-colors", "200", f"PNG8:{target}"], check=True)
    print(target.relative_to(ROOT), target.stat().st_size // 1024, "KB", flush=True)


def make_gif(program, screen, folder):
    window = opened(program, screen, ANIMATED)
    frames = []
    try:
        at = FIRST
        while at < LAST:
            frames.append(folder / f"frame_{len(frames):03}.png")
            picture(window, frames[-1], at)
            at += STEP
    finally:
        window.quit()
    target = ROOT / "docs" / "images" / "window.gif"
    subprocess.run(["convert", "-delay", str(round(100 * STEP)), *frames, "-delay", "150", frames[-1], "-crop", "800x450+40+150",
                    "+repage", "-resize", "480x270", "+dither", "-colors", "128", "-fuzz", "1%", "-layers", "Optimize", "-loop", "0", str(target)], check=True)
    print(target.relative_to(ROOT), target.stat().st_size // 1024, "KB")


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--program", default=str(ROOT / "build" / "release" / "resect"))
    arguments.add_argument("names", nargs="*", metavar="NAME")
    options = arguments.parse_args()
    known = [name for name, _, _ in FIGURES] + ["window", "exercise", "gif"]
    for name in options.names:
        if name not in known:
            sys.exit(f"there is no {name}; choose from {', '.join(known)}")
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        screen = Screen(folder, 1400, 900)
        try:
            for figure in FIGURES:
                if not options.names or figure[0] in options.names:
                    make_figure(options.program, screen, folder, *figure)
            if not options.names or "window" in options.names:
                make_window(options.program, folder, "window", [], 5.6, 4)  # the wound bleeds meanwhile
            if not options.names or "exercise" in options.names:
                make_window(options.program, folder, "exercise", ["control-bleeding"], 2.2, 0.2)
            if not options.names or "gif" in options.names:
                make_gif(options.program, screen, folder)
        finally:
            screen.close()


if __name__ == "__main__":
    main()
