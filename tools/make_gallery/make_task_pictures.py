#!/usr/bin/env python3
"""Makes the pictures of the exercises' cards, data/tasks/*.png: each task in the window, with its guidance, at a moment
of its reference run. Needs Xvfb, xdotool and ImageMagick's convert.

    make_task_pictures.py [PROGRAM]
"""
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "test" / "app"))
from screen import Screen, Window  # noqa: E402

PROGRAM = Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "build/release/resect").resolve()
MOMENTS = {"touch-and-hold": 6.2, "two-hands": 3.4, "clip-and-divide": 2.6, "control-bleeding": 3.2,
           "wedge-resection": 2.9, "left-lateral": 3.2}  # s

with tempfile.TemporaryDirectory() as made:
    folder = Path(made)
    screen = Screen(folder)
    for task, moment in MOMENTS.items():
        window = Window(PROGRAM, screen, task)
        window.wait("ready", 120)
        window.tell("picture-size 640 400")
        window.tell(f"play {moment}")
        window.wait("played", 300)
        picture = folder / f"{task}.png"
        window.tell(f"save-picture {picture}")
        window.wait("written", 120)
        window.quit()
        subprocess.run(["convert", picture, "-resize", "480x300", "-colors", "160", f"PNG8:{ROOT}/data/tasks/{task}.png"],
                       check=True)
    screen.close()
