#!/usr/bin/env python3
"""A person who keeps an operation, with real mouse and keys on a virtual screen: cuts, takes back, looks at earlier
moments, works on from one, saves, quits, opens, goes on. What was recorded is proved afterwards.

    operation_test.py PROGRAM FOLDER [--random N] [--kills N]     pictures are left in FOLDER
"""
import argparse
import contextlib
import json
import random
import sqlite3
import subprocess
import sys
import time
import unittest
from pathlib import Path

from screen import ScreenTest, Window, difference

arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
arguments.add_argument("program", metavar="PROGRAM", type=lambda text: str(Path(text).resolve()))
arguments.add_argument("folder", metavar="FOLDER", type=lambda text: Path(text).resolve())
arguments.add_argument("--random", type=int, default=1, metavar="N", help="random operations (default 1)")
arguments.add_argument("--kills", type=int, default=2, metavar="N", help="windows that are killed (default 2)")
arguments.add_argument("--seed", type=int, default=1)
OPTIONS = arguments.parse_args()
PROGRAM, FOLDER = OPTIONS.program, OPTIONS.folder


class KeptOperation(ScreenTest):
    program, folder = PROGRAM, FOLDER

    def stroke(self, window, first, last, deep=20):
        """The instrument in hand to `first`, into the organ with the wheel, and on to `last`."""
        screen = self.screen
        screen.drag(first, last, steps=12)
        for button in [4] * deep + [5] * deep:
            screen.do("click", button)
            time.sleep(0.02)

    def removed(self, window):
        window.drain()
        counts = [int(line.split()[1]) for line in window.said if line.startswith("removed ")]
        return counts[-1] if counts else 0

    def shown(self, window):
        """Branch, frame and particles removed of the next moment that is shown."""
        words = window.wait("showing").split()
        return int(words[2]), int(words[4]), int(words[6])

    def close(self, window):
        self.screen.focus("^Resect")
        self.screen.key("ctrl+q")
        self.assertEqual(window.process.wait(timeout=60), 0)

    def recordings(self):
        return sorted((FOLDER / "state" / "resect" / "recordings").glob("*.resect"))

    def rows(self, file, query):
        with contextlib.closing(sqlite3.connect(f"file:{file}?mode=ro", uri=True)) as database:
            return database.execute(query).fetchall()

    def verify(self, file, threads=(1, 2, 3)):
        said = set()
        for n in threads:
            done = subprocess.run([PROGRAM, "verify", str(file), "--threads", str(n)], capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, f"{file} at {n} threads: {done.stdout}{done.stderr}")
            said.add(done.stdout)
        self.assertEqual(len(said), 1)
        return said.pop()

    def test_cut_undo_scrub_branch_save_quit_open_go_on(self):
        screen = self.screen
        window = self.opened("--spacing", "8mm", "--thesis")
        organ, scalpel = window.places["organ"], window.places["Scalpel"]
        screen.drag(scalpel, (organ[0], organ[1] + 40), steps=25)
        window.wait("held Scalpel direct")
        self.stroke(window, (organ[0], organ[1] + 250), (organ[0] - 40, organ[1] + 285))
        one = self.removed(window)
        self.assertGreater(one, 0, window.said[-20:])
        time.sleep(1.2)  # the stroke ends
        self.stroke(window, (organ[0] - 40, organ[1] + 290), (organ[0] + 50, organ[1] + 275))
        two = self.removed(window)
        self.assertGreater(two, one)
        cut = screen.picture("1_cut")

        # Undo until nothing is cut, and redo.
        removed = two
        while removed > 0:
            screen.key("ctrl+z")
            branch, _, removed = self.shown(window)
            self.assertEqual(branch, 0)
        screen.picture("2_undone")
        while removed < two:
            screen.key("ctrl+shift+z")
            branch, last, removed = self.shown(window)
        self.assertEqual(branch, 0)

        # Scrub: a press in the middle of the bar, a drag to its end.
        start, end = window.places["timeline-start"], window.places["timeline-end"]
        screen.click((start[0] + end[0]) // 2, start[1])
        _, middle, _ = self.shown(window)
        self.assertLess(abs(middle - last / 2), last / 10)
        time.sleep(0.6)
        scrubbed = screen.picture("3_scrubbed")
        around = (organ[0] - 150, organ[1] - 150, organ[0] + 150, organ[1] + 150)
        self.assertGreater(difference(cut, scrubbed, around), 0.001)
        screen.key("comma")
        self.assertEqual(self.shown(window)[1], middle - 1)
        screen.key("period")
        self.assertEqual(self.shown(window)[1], middle)
        # Plays again, and stops.
        screen.key("ctrl+space")
        for _ in range(5):
            frame = self.shown(window)[1]
        self.assertGreater(frame, middle)
        screen.key("ctrl+space")
        time.sleep(0.5)
        window.drain()

        # From before the first cut, another way: a branch.
        screen.click(*start)
        _, frame, removed = self.shown(window)
        self.assertEqual((frame, removed), (0, 0))
        screen.key("1")
        window.wait("operating")
        for down in (20, 40, 40, 40):  # until it is at the liver
            self.stroke(window, (organ[0], organ[1] + 60), (organ[0] + 10, organ[1] + 60 + down), deep=30)
            time.sleep(0.5)
            branched = self.removed(window)
            if branched > 0:
                break
        self.assertGreater(branched, 0)
        screen.picture("4_branch")
        screen.key("ctrl+b")
        screen.focus("^Branches$")
        screen.picture("5_branches")
        screen.key("Escape")
        screen.focus("^Resect")

        # Save, quit, open, go on.
        screen.key("ctrl+s")
        screen.focus("^Save operation$")
        kept = FOLDER / "kept.resect"
        screen.type(kept)
        screen.key("Return")
        window.wait("written", seconds=30)
        self.assertEqual(self.removed(window), branched)
        self.close(window)
        self.assertIn("2 branches", self.verify(kept))
        before = kept.read_bytes()

        again = self.opened(str(kept))
        words = [line for line in again.said if line.startswith("showing")][-1].split()
        self.assertEqual((words[2], words[6]), ("1", str(branched)))
        # It was saved while it went on: it stands at its end.
        self.assertEqual([(int(words[4]),)], self.rows(kept, "SELECT max(frame) FROM frames WHERE branch = 1"))
        time.sleep(1)
        screen.picture("6_opened")
        organ = again.places["organ"]
        screen.key("2")
        again.wait("operating")
        for down in (20, 40, 40, 40):
            self.stroke(again, (organ[0], organ[1] + 60), (organ[0] - 10, organ[1] + 60 + down), deep=30)
            time.sleep(0.5)
            more = self.removed(again)
            if more > branched:
                break
        self.assertGreater(more, branched)
        screen.focus("^Resect")
        screen.key("ctrl+s")  # it has its name
        again.wait("written", seconds=30)
        after = kept.read_bytes()

        # Begin again: another operation, from the start of the one that was opened.
        screen.key("ctrl+n")
        again.wait("organ ")
        screen.key("ctrl+z")
        again.wait("nothing to undo")
        screen.key("ctrl+s")  # it has no name: the one that was opened is not replaced
        screen.focus("^Save operation$")
        screen.key("Escape")
        screen.focus("^Resect")
        self.close(again)
        self.assertEqual(after, kept.read_bytes())
        self.assertNotEqual(before, after)
        notes = (FOLDER / "config").rglob("*.conf")
        self.assertRegex("".join(file.read_text() for file in notes), r'_operation="Built-in liver, 0:\d\d\.\d, [2-9] strokes"')
        anew = self.recordings()[-1]
        self.assertEqual(self.rows(anew, "SELECT max(number) FROM branch"), [(0,)])
        self.assertEqual(self.rows(anew, "SELECT count(*) FROM events WHERE kind = 'remove'"), [(0,)])
        self.verify(kept)
        for file in self.recordings():
            self.verify(file, threads=(2,))

    def test_the_window_shows_what_a_run_of_the_scenario_gives(self):
        for scenario, spacing in ("resect-segment", "7mm"), ("resect-segment-elastic", "9mm"):
            run = subprocess.run([PROGRAM, "run", scenario, "--spacing", spacing, "--json", "-"],
                                 capture_output=True, text=True, check=True)
            organ = json.loads(run.stdout)["ledger"][0]
            window = self.opened(scenario, "--spacing", spacing)
            for _ in range(2):  # the second time from the start of the operation, too
                window.drain()
                self.screen.key("p")
                window.wait("played", seconds=120)
                time.sleep(1.5)
                window.drain()
                words = [line for line in window.said if line.startswith("ledger")][-1].split()
                self.assertEqual(float(words[4]), round(organ["removed"]["tissue_ml"], 3))
                self.assertEqual(float(words[7]), round(organ["pieces"]["tissue_ml"], 3))
            self.screen.picture(f"8_{scenario}")
            self.close(window)

    def test_a_killed_window_leaves_a_recording_that_is_proved(self):
        screen, chance = self.screen, random.Random(OPTIONS.seed)
        for _ in range(OPTIONS.kills):
            window = self.opened("press", "--spacing", "10mm")
            organ = window.places["organ"]
            screen.key("1")
            screen.do("mousemove", organ[0], organ[1], "mousedown", 1)
            end = time.time() + chance.uniform(0, 2)
            while time.time() < end:
                screen.move(organ[0] + chance.randint(-60, 60), organ[1] + chance.randint(0, 120))
            window.process.kill()
            window.process.wait()
            screen.do("mouseup", 1)
            self.assertIn("frames", self.verify(self.recordings()[-1], threads=(2,)))

    def test_an_operation_goes_on_when_the_disk_is_full(self):
        place = FOLDER / "small"
        place.mkdir()
        if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=1500k", "tmpfs", place], capture_output=True).returncode:
            self.skipTest("no small disk can be mounted")
        self.addCleanup(subprocess.run, ["umount", "-l", place])
        window = Window(PROGRAM, self.screen, "press", "--spacing", "9mm", "--size", "1240x900",
                        environment={"XDG_STATE_HOME": str(place)})
        self.addCleanup(window.quit)
        window.wait("ready")
        self.screen.focus("^Resect")
        self.screen.key("p")
        line = window.wait("error", seconds=60)
        self.assertIn("disk is full", line)
        self.assertIn("goes on unrecorded", line)
        window.wait("played", seconds=120)
        # Leaving asks.
        self.screen.key("ctrl+q")
        time.sleep(1)
        self.assertIsNone(window.process.poll())
        self.screen.picture("7_leaving")

    def test_random_operations_are_proved_at_any_number_of_threads(self):
        screen, chance = self.screen, random.Random(OPTIONS.seed)
        for number in range(OPTIONS.random):
            kind = chance.choice(["--thesis", "press", "incise", "snip"])
            window = self.opened("--spacing", f"{chance.choice([8, 9, 11])}mm", kind)
            organ = window.places["organ"]
            near = lambda: (organ[0] + chance.randint(-120, 120), organ[1] + chance.randint(-40, 160))
            for _ in range(12):
                what = chance.random()
                if what < 0.3:
                    screen.key(chance.choice("123456"))
                elif what < 0.7:
                    self.stroke(window, near(), near(), deep=chance.randint(0, 25))
                elif what < 0.8:
                    screen.key(*chance.choice([["ctrl+z"], ["ctrl+z", "ctrl+z"], ["ctrl+z", "ctrl+shift+z"]]))
                elif what < 0.9:
                    start, end = window.places["timeline-start"], window.places["timeline-end"]
                    screen.click(chance.randint(start[0], end[0]), start[1])
                    screen.key(chance.choice(["ctrl+Return", "1", "ctrl+space"]))
                else:
                    screen.key(chance.choice(["p", "Escape", "g", "c"]))
            self.close(window)
            said = self.verify(self.recordings()[-1])
            print(f"random operation {number + 1}, {kind}: {said.strip()}", flush=True)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
