#!/usr/bin/env python3
"""A person at the window, played with real mouse events on a virtual screen: starts, takes instruments,
cuts, turns, draws the iso level, opens another organ, saves and reloads the scene, closes.

    window_test.py PROGRAM FOLDER                                  the tests; pictures of each stage are left in FOLDER
    window_test.py PROGRAM FOLDER --measure                        how smooth it is, as a table
    window_test.py PROGRAM FOLDER --random SECONDS [--seed N]      random input for so long
"""
import argparse
import shutil
import socket
import struct
import subprocess
import sys
import time
import unittest
from pathlib import Path

from pace import measure
from random_input import play
from screen import ScreenTest, Window, difference

arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
arguments.add_argument("program", metavar="PROGRAM", type=lambda text: str(Path(text).resolve()))
arguments.add_argument("folder", metavar="FOLDER", type=lambda text: Path(text).resolve())
arguments.add_argument("--drag-source", metavar="PROGRAM", help="a window that files are dragged from; else beside PROGRAM")
arguments.add_argument("--measure", action="store_true")
arguments.add_argument("--random", type=float, metavar="SECONDS")
arguments.add_argument("--seed", type=int, default=1)
OPTIONS = arguments.parse_args()
PROGRAM, FOLDER = OPTIONS.program, OPTIONS.folder
DRAG_SOURCE = OPTIONS.drag_source or str(Path(PROGRAM).parent / "drag_source")


class AtTheWindow(ScreenTest):
    folder = FOLDER

    def opened(self, spacing="12mm", size="1200x900"):
        """A window with the still liver of the thesis, ready and with the keys."""
        window = Window(PROGRAM, self.screen, "--thesis", "--spacing", spacing, "--size", size)
        self.addCleanup(window.quit)
        window.wait("ready")
        self.screen.focus("^Resect")
        return window

    def another_organ(self, name):
        file = FOLDER / name
        subprocess.run([PROGRAM, "liver", "-o", str(file), "--edge", "5mm"], check=True, capture_output=True)
        return file

    def test_a_first_operation(self):
        screen = self.screen
        window = self.opened("8mm", "1240x900")
        organ, scalpel = window.places["organ"], window.places["Scalpel"]
        begin = screen.picture("1_start")
        screen.key("ctrl+z")
        window.wait("nothing to undo")
        screen.key("ctrl+shift+z")
        window.wait("nothing to redo")

        # As in the thesis: click, handle box, trackball, and a click elsewhere.
        screen.click(*scalpel)
        window.wait("held Scalpel handle-box")
        time.sleep(0.6)
        box = screen.picture("2_handle_box")
        near = (scalpel[0] - 90, scalpel[1] - 120, scalpel[0] + 90, scalpel[1] + 120)
        self.assertGreater(difference(begin, box, near), 0.005)
        screen.click(*scalpel, button=2)
        window.wait("held Scalpel trackball")
        time.sleep(0.6)
        screen.picture("3_trackball")
        screen.click(organ[0] - 60, organ[1] + 260)
        window.wait("held nothing")

        # Directly: over the liver, then down into it.
        screen.drag(scalpel, (organ[0], organ[1] - 40), steps=30)
        window.wait("held Scalpel direct")
        screen.drag((organ[0], organ[1] + 250), (organ[0] - 10, organ[1] + 290), steps=20)
        window.drain()
        removed = [int(line.split()[1]) for line in window.said if line.startswith("removed ")]
        if not removed:  # the wheel brings it nearer and farther
            for button in (4, 5):
                for _ in range(25):
                    screen.do("click", button)
                    time.sleep(0.03)
            removed = [int(window.wait("removed ").split()[1])]
        self.assertGreater(removed[-1], 0)
        time.sleep(0.8)
        cut = screen.picture("4_cut")
        around = (organ[0] - 150, organ[1] - 150, organ[0] + 150, organ[1] + 150)
        self.assertGreater(difference(begin, cut, around), 0.005)

        # The stroke is taken back, and done again.
        window.drain()
        screen.focus("^Resect")
        screen.key("ctrl+z")
        window.wait("undo")
        self.assertLess(int(window.wait("removed ").split()[1]), removed[-1])
        time.sleep(0.8)
        taken_back = screen.picture("4_taken_back")
        self.assertGreater(difference(cut, taken_back, around), 0.001)
        screen.key("ctrl+shift+z")
        window.wait("redo")
        self.assertGreater(int(window.wait("removed ").split()[1]), 0)

        # Every other instrument in hand, by its key, and back.
        for key, name in (("2", "Hook"), ("3", "Baton"), ("1", "Scalpel")):
            screen.key(key)
            window.wait(f"held {name} direct")
            screen.key("Up", "Left", "shift+Right", "Prior")
        screen.key("Escape")
        window.wait("held nothing")

        # The iso level, on its scale in the scene.
        screen.key("space")
        window.wait("places")
        time.sleep(0.8)
        before = screen.picture("5_whole_view")
        x, y = window.places["iso"]
        screen.drag((x, y), (x, y - 45))
        time.sleep(0.8)
        after = screen.picture("6_iso")
        self.assertGreater(difference(before, after, around), 0.01)

        # The scene, seen from above with an instrument out of the tool box, into a file and back.
        screen.key("2", "ctrl+3")
        window.wait("held Hook direct")
        screen.key("g")
        window.wait("held nothing")
        time.sleep(1.5)
        saved = screen.picture("6_saved")
        scene = FOLDER / "scene.iv"
        window.tell(f"save-scene {scene}")
        window.wait(f"written {scene}")
        self.assertIn(b"DEF Organ", scene.read_bytes())
        window.tell(f"open {scene}")
        window.wait("report ")
        screen.picture("7_open_scene")
        screen.click(*window.places["open"])
        window.wait("organ scene.iv")
        time.sleep(1.5)
        again = screen.picture("8_scene_again")
        view = (100, 100, 800, 700)
        self.assertLess(difference(saved, again, view), 0.05)
        # What it has read it does not write; another name it does.
        before = scene.read_bytes()
        for what in ("save-scene", "save-surface"):
            window.tell(f"{what} {scene.parent / '.' / scene.name}")
            self.assertIn("is read", window.wait("error "))
        self.assertEqual(scene.read_bytes(), before)
        window.tell(f"save-surface {FOLDER / 'scene.stl'}")
        window.wait("written ")

        screen.focus("^Resect")
        screen.key("space")  # the window's own view, and all instruments in the tool box
        time.sleep(1.5)
        self.assertGreater(difference(saved, screen.picture("9_own_view"), view), 0.2)

        screen.key("ctrl+q")
        window.process.wait(timeout=30)
        self.assertEqual(window.process.returncode, 0)

        # The window has recorded both operations by itself, with the strokes taken back.
        recordings = sorted((FOLDER / "state" / "resect" / "recordings").glob("*.resect"))
        self.assertGreaterEqual(len(recordings), 2)
        proofs = [subprocess.run([PROGRAM, "verify", file], capture_output=True, text=True, timeout=120)
                  for file in recordings[-2:]]
        self.assertEqual([proof.stderr for proof in proofs], ["", ""])
        self.assertIn("1 branch", proofs[0].stdout)

    def test_keys_come_back_from_the_panels(self):
        screen = self.screen
        window = self.opened()

        def places_are_said(*keys):
            window.drain()
            screen.key(*keys)
            window.wait("places", 20)

        # A field of numbers has the keys: digits are its own, Space is not, and Escape leaves it.
        screen.click(*window.places["Spacing"])
        screen.key("1")
        places_are_said("space")
        screen.key("1")
        window.wait("held Scalpel direct", 20)
        screen.click(*window.places["Refinement"])
        screen.key("Escape", "2")
        window.wait("held Hook direct", 20)

        # A button that was clicked does not keep the keys; one that Tab led to is pressed by Space.
        x, y = window.places["Refinement"]
        screen.click(x, y + 54)  # Begin again
        window.wait("organ liver")
        places_are_said("space")
        screen.click(x, y)
        screen.key("Tab", "Tab", "space")
        window.wait("organ liver", 20)

    def test_f1_shows_the_controls_until_the_next_key(self):
        screen = self.screen
        window = self.opened()
        time.sleep(1.5)
        bare = screen.picture("controls_none")
        middle = (300, 250, 600, 500)
        screen.key("F1")
        time.sleep(1.0)
        self.assertGreater(difference(bare, screen.picture("controls_shown"), middle), 0.3)
        screen.key("F1")
        time.sleep(1.0)
        self.assertLess(difference(bare, screen.picture("controls_gone"), middle), 0.05)

    @unittest.skipUnless(shutil.which("ffmpeg") and shutil.which("ffprobe"), "skipped: ffmpeg is not installed")
    def test_a_film_is_as_long_as_what_was_seen_and_closing_finishes_it(self):
        screen, file = self.screen, FOLDER / "film.mp4"
        window = self.opened()
        screen.key("ctrl+r")
        screen.focus("^Record film$")
        screen.key("ctrl+a")
        screen.type(file)
        screen.key("Return")
        begun = time.time()
        time.sleep(0.5)
        screen.focus("^Resect")
        time.sleep(1.5)
        screen.drag(window.places["Scalpel"], (500, 300))
        time.sleep(2)
        screen.key("ctrl+q")
        window.process.wait(timeout=60)
        lasted = time.time() - begun
        self.assertIn("filmed", window.said + [window.lines.get() for _ in range(window.lines.qsize())])
        seconds = float(subprocess.run(["ffprobe", "-v", "error", "-show_entries", "format=duration", "-of", "csv=p=0", file],
                                       capture_output=True, text=True, timeout=60, check=True).stdout)
        self.assertLess(seconds, lasted + 1)
        self.assertGreater(seconds, 0.6 * lasted)

    def test_files_are_opened_and_saved_through_their_dialogs(self):
        screen = self.screen
        window = self.opened()
        scene = FOLDER / "by_dialog.iv"
        screen.click(*window.places["organ"])
        screen.focus("^Resect")
        screen.key("1")
        window.wait("held Scalpel direct")

        def name(dialog, key, file):
            screen.focus("^Resect")
            screen.key(key)
            screen.focus(f"^{dialog}$")
            screen.key("ctrl+a")
            screen.type(file)
            screen.picture("dialog_" + dialog.lower().replace(" ", "_"))
            screen.key("Return")

        name("Save scene", "ctrl+shift+e", scene)
        window.wait(f"written {scene}")
        other = self.another_organ("other.stl")
        name("Open", "ctrl+o", other)
        window.wait("report ")
        window.wait("surface turns")
        screen.focus("^Open organ$")
        screen.picture("dialog_report")
        screen.key("Return")
        window.wait("organ other.stl")
        screen.picture("dialog_other_organ")
        name("Open", "ctrl+o", scene)
        window.wait("report ")
        screen.focus("^Open organ$")
        screen.key("Return")
        window.wait("organ by_dialog.iv")
        time.sleep(1)
        screen.picture("dialog_scene_again")

    def test_labels_of_a_scan_are_opened_with_the_roles_that_a_person_gives_them(self):
        """An image of three labels without names: a block, a tumour in it, and a vessel."""
        def label(x, y, z):
            if (x - 12) ** 2 + (y - 15) ** 2 + (z - 15) ** 2 < 16:
                return 2
            if (y - 15) ** 2 + (z - 6) ** 2 < 4 and x > 1:
                return 3
            return 1 if all(3 <= c < 27 for c in (x, y, z)) else 0
        image = FOLDER / "labels.nrrd"
        size = 30
        image.write_text("NRRD0004\ntype: uchar\ndimension: 3\nsizes: 30 30 30\nspace: left-posterior-superior\n"
                         "space directions: (4,0,0) (0,4,0) (0,0,4)\nkinds: domain domain domain\nencoding: ascii\n\n" +
                         " ".join(str(label(x, y, z)) for z in range(size) for y in range(size) for x in range(size)))
        screen = self.screen
        window = self.opened(size="1100x800")
        window.tell(f"open {image}")
        self.assertIn("Which label is the organ?", window.wait("report "))
        for row, steps in enumerate((1, 2, 6)):  # the organ, tumour, portal vein
            window.drain()
            screen.choose(*window.places[f"role{row}"], *["Down"] * steps, "Return")
            report = window.wait("report ")
        window.wait("surface turns")
        screen.picture("labels_roles")
        self.assertIn("30 x 30 x 30 voxels of 4 x 4 x 4 mm", report)
        window.drain()
        screen.click(*window.places["open"])
        window.wait("organ labels.nrrd")
        time.sleep(1)
        screen.picture("labels_opened")
        window.tell("open " + str(FOLDER / "no labels.nrrd"))
        self.assertIn("there is no such file", window.wait("report "))
        screen.focus("^Open organ$")
        screen.key("Escape")

    def test_what_is_dropped_on_the_window_is_opened(self):
        """From a window of another program, as from a file manager."""
        dropped = self.another_organ("dropped.stl")
        window = self.opened(size="1100x800")

        def drop(what, answer):
            source = subprocess.Popen([DRAG_SOURCE, str(what), "1150", "850"], env=self.screen.environment,
                                      stdout=subprocess.PIPE, text=True)
            try:
                self.screen.focus("^drag source$")
                self.screen.drag((1200, 880), window.places["organ"])
                self.assertEqual(source.stdout.readline().strip(), answer)
            finally:
                source.terminate()
                source.wait(timeout=20)
                source.stdout.close()

        drop(dropped, "taken")
        window.wait("report ")
        self.screen.focus("^Open organ$")
        self.screen.key("Return")
        window.wait("organ dropped.stl")
        drop(FOLDER / "no such file.stl", "taken")
        self.assertIn("there is no such file", window.wait("report "))
        self.screen.focus("^Open organ$")
        self.screen.key("Escape")
        drop("https://resect.example/liver.stl", "refused")  # nothing of this machine: nothing can be opened

    def test_a_3d_mouse_moves_what_is_in_hand(self):
        """A daemon of our own that speaks its protocol: eight integers per report."""
        address = FOLDER / "space_mouse"
        with socket.socket(socket.AF_UNIX, socket.SOCK_STREAM) as daemon:
            daemon.bind(str(address))
            daemon.listen()
            window = Window(PROGRAM, self.screen, "--thesis", "--spacing", "12mm", "--size", "1200x900",
                            environment={"SPNAV_SOCKET": str(address)})
            self.addCleanup(window.quit)
            daemon.settimeout(60)
            mouse, _ = daemon.accept()
            window.wait("ready")
            organ = window.places["organ"]
            self.screen.click(organ[0], organ[1] + 260)
            self.screen.key("1")
            window.wait("held Scalpel direct")
            time.sleep(1)
            before = self.screen.picture("space_mouse_before")
            for _ in range(30):
                mouse.send(struct.pack("8i", 0, 300, 0, 0, 0, 0, 200, 16))
                time.sleep(0.016)
            time.sleep(1)
            after = self.screen.picture("space_mouse_after")
            around = (organ[0] - 200, organ[1] - 250, organ[0] + 200, organ[1] + 100)
            self.assertGreater(difference(before, after, around), 0.005)
            mouse.close()
            time.sleep(0.3)
        self.screen.key("Escape")
        window.wait("held nothing")  # it goes on without the daemon

    def test_a_pick_hits_what_is_under_the_pointer_at_any_scale(self):
        for scale in ("1", "1.5", "2"):
            size = f"{int(1200 / float(scale))}x{int(900 / float(scale))}"
            window = Window(PROGRAM, self.screen, "--thesis", "--spacing", "12mm", "--size", size, scale=scale)
            try:
                window.wait("ready")
                time.sleep(0.5)
                self.screen.picture(f"scale_{scale}_start")
                self.screen.click(*window.places["Hook"])
                window.wait("held Hook handle-box")
                self.screen.picture(f"scale_{scale}")
            finally:
                window.quit()

    def test_random_input_does_not_end_it_and_all_comes_back(self):
        self.assertEqual(play(PROGRAM, FOLDER / "random", seconds=12, seed=1), 0)
        self.assertEqual(play(PROGRAM, FOLDER / "random_thesis", seconds=12, seed=2, organ=("--thesis", "--spacing", "8mm")), 0)

    def test_a_broken_file_is_a_sentence_in_the_window(self):
        broken = FOLDER / "broken.stl"
        broken.write_text("solid nothing\nfacet normal 0 0\n")
        window = Window(PROGRAM, self.screen, "--spacing", "12mm", "--organ", str(broken))
        self.addCleanup(window.quit)
        self.assertIn("broken.stl", window.wait("error "))
        self.assertIsNone(window.process.poll())

    def test_what_cannot_become_an_organ_is_told_with_its_own_name_and_unit(self):
        flat = FOLDER / "sheet_in_mm.obj"
        flat.write_text("v 0 0 0\nv 200 0 0\nv 0 150 0\nf 1 2 3\n")
        window = Window(PROGRAM, self.screen, "--spacing", "12mm", "--organ", str(flat))
        self.addCleanup(window.quit)
        told = window.wait("error ")
        self.assertIn("sheet_in_mm.obj: the surface is open", told)
        self.assertIn("in mm it would be 0.2 m: add --unit mm", told)


if __name__ == "__main__":
    if OPTIONS.measure or OPTIONS.random:
        shutil.rmtree(FOLDER, ignore_errors=True)
        FOLDER.mkdir(parents=True, mode=0o700)
        sys.exit(measure(PROGRAM, FOLDER) if OPTIONS.measure else play(PROGRAM, FOLDER, OPTIONS.random, OPTIONS.seed))
    unittest.main(argv=sys.argv[:1], verbosity=2)
