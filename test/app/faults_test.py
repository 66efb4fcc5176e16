#!/usr/bin/env python3
"""Faults that people have found at the window, each tried again with real mouse and keys on a virtual screen.

    faults_test.py PROGRAM FOLDER     pictures are left in FOLDER
"""
import subprocess
import sys
import time
import unittest
from pathlib import Path

from screen import Screen, ScreenTest, Window, difference

PROGRAM, FOLDER = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()


def red_middle(rows, box):
    """Middle of the pixels in a box (x0, y0, x1, y1) that show the liver, and their share."""
    x0, y0, x1, y1 = box
    found = [(x, y) for y in range(y0, y1, 4) for x in range(x0, x1, 4)
             if rows[y][3 * x] > 30 and rows[y][3 * x] > 1.6 * rows[y][3 * x + 1]]
    n = max(1, len(found))
    return sum(x for x, _ in found) // n, sum(y for _, y in found) // n, 16 * n / ((x1 - x0) * (y1 - y0))


def equal_neighbours(rows, box):
    """Share of pixels that equal the one beside them: many in a picture of low resolution that was stretched."""
    x0, y0, x1, y1 = box
    equal = sum(rows[y][3 * x:3 * x + 3] == rows[y][3 * x + 3:3 * x + 6] for y in range(y0, y1, 3) for x in range(x0, x1, 5))
    return equal / (len(range(y0, y1, 3)) * len(range(x0, x1, 5)))


class Faults(ScreenTest):
    program, folder = PROGRAM, FOLDER
    view = (10, 110, 1010, 740)  # within the picture of a window of 1240 x 900

    def thesis(self, spacing="12mm"):
        return self.opened("--thesis", "--spacing", spacing)

    def say_places(self, window, key="space"):
        self.screen.key(key)
        window.wait("places", 20)

    def test_the_window_opens_on_the_operating_field_and_says_what_to_do(self):
        window = self.opened()
        time.sleep(1)
        abdomen = self.screen.picture("first")
        # On the table only the organ is red.
        self.screen.key("alt+v", "e")
        window.wait("setting table", 20)
        time.sleep(1)
        _, _, share = red_middle(self.screen.picture("first_on_table"), self.view)
        self.assertGreater(share, 0.35)
        self.assertLess(share, 0.75)
        self.screen.key("alt+v", "e")
        window.wait("setting field", 20)
        time.sleep(1)
        x0, y0, x1, y1 = self.view
        again = self.screen.picture("first_again")
        same = sum(abs(abdomen[y][3 * x] - again[y][3 * x]) < 12 for y in range(y0, y1, 4) for x in range(x0, x1, 4))
        self.assertGreater(same, 0.97 * len(range(y0, y1, 4)) * len(range(x0, x1, 4)))
        self.assertNotIn("Spacing", window.places)  # developers' panels are in the laboratory
        self.screen.key("F2")
        window.wait("laboratory shown", 20)
        self.say_places(window)
        self.assertIn("Spacing", window.places)
        self.screen.key("F2")
        window.wait("laboratory hidden", 20)

    def test_thesis_mode_is_in_the_view_menu(self):
        window = self.opened("press", "--spacing", "12mm")
        self.screen.key("1")
        window.wait("held Scalpel guided", 20)
        self.screen.key("Escape", "alt+v", "m")
        window.wait("laboratory shown", 30)
        window.wait("organ liver", 20)
        self.screen.key("1")
        window.wait("held Scalpel direct", 20)
        self.screen.key("Escape", "alt+v", "m")
        window.wait("laboratory hidden", 30)
        window.wait("organ liver", 20)
        self.screen.key("1")
        window.wait("held Scalpel guided", 20)

    def test_breathing_is_in_the_view_menu(self):
        window = self.opened("press", "--spacing", "12mm")
        self.screen.key("alt+v", "r")
        window.wait("breathing on", 20)
        time.sleep(1)  # so that the menu shows what the operation does
        self.screen.key("alt+v", "r")
        window.wait("breathing off", 20)

    def test_time_stands_still_while_a_menu_is_open(self):
        window = self.opened("press", "--spacing", "12mm")

        def now():
            window.tell("time")
            return float(window.wait("time", 20).split()[1])

        def passed():
            begin = now()
            time.sleep(1.5)
            return now() - begin

        self.assertGreater(passed(), 0.5)
        self.screen.key("alt+v")
        time.sleep(0.5)
        self.assertLess(passed(), 0.05)
        self.screen.key("Escape")
        time.sleep(0.5)
        self.assertGreater(passed(), 0.5)
        self.screen.key("1")  # the keys are the picture's again
        window.wait("held", 10)

    def test_a_click_too_short_for_jaws_is_told_and_a_clip_is_told_once(self):
        window = self.opened("bleed", "--spacing", "12mm")

        def hold(seconds):
            self.screen.do("mousedown", 1)
            time.sleep(seconds)
            self.screen.do("mouseup", 1)

        self.screen.key("6")
        window.wait("held Clip applier", 20)
        self.screen.move(500, 420)
        time.sleep(1)
        hold(2)
        self.assertRegex(window.wait("told", 10), "(A|No) clip was placed")
        time.sleep(2)
        window.drain()
        self.assertEqual([line for line in window.said if "jaws did not close" in line], [])
        hold(0.12)
        self.assertIn("The jaws did not close", window.wait("told", 10))

    def test_that_a_hook_left_at_work_has_slipped_off_is_told(self):
        window = self.opened("incise", "--spacing", "12mm")
        self.screen.key("2")
        window.wait("held Hook", 20)
        self.screen.move(500, 420)
        time.sleep(1)
        self.screen.do("mousedown", 1)
        time.sleep(0.5)
        for x in range(500, 20, -10):  # much farther than the tissue follows
            self.screen.move(x, 420)
            time.sleep(0.05)
        self.screen.key("f")
        self.screen.do("mouseup", 1)
        self.assertIn("holds nothing", window.wait("told", 20))
        time.sleep(3)
        window.drain()
        self.assertEqual([line for line in window.said if "holds nothing" in line][1:], [])

    def test_the_lamp_is_moved_in_the_view_menu(self):
        window = self.opened("press", "--spacing", "12mm")
        time.sleep(2)
        before = self.screen.picture("lamp_right")
        self.screen.key("alt+v", "u", "l")
        window.wait("lamp 1", 20)
        time.sleep(2)
        self.assertNotEqual(self.screen.picture("lamp_left"), before)
        window.quit()
        window = self.opened("press", "--spacing", "12mm")
        self.assertIn("lamp 1", window.said)  # it is where it was
        self.screen.key("alt+v", "u", "r")
        window.wait("lamp 0", 20)

    def test_the_size_is_what_it_says_and_no_text_is_cut(self):
        screen = Screen(FOLDER, 2732, 1536)
        self.addCleanup(screen.close)
        for size, scale in (("800x600", "1"), ("1366x768", "1"), ("1920x1080", "1"), ("1366x768", "1.5"), ("1366x768", "2")):
            for args in ((), ("--thesis", "--spacing", "12mm")):
                window = Window(PROGRAM, screen, "--size", size, *args, scale=scale)
                try:
                    window.wait("ready")
                    time.sleep(1)
                    screen.focus("^Resect")
                    screen.key("space")
                    window.wait("places", 20)
                    screen.picture(f"size_{size}_{scale}_{len(args)}")
                    found = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "^Resect", "getwindowgeometry",
                                            "--shell"], env=screen.environment, capture_output=True, text=True, timeout=30)
                    width, height = (round(int(part) * float(scale)) for part in size.split("x"))
                    self.assertIn(f"WIDTH={width}\nHEIGHT={height}\n", found.stdout, (size, scale))
                    self.assertEqual([line for line in window.said if line.startswith("cut text")], [], (size, scale, args))
                finally:
                    window.quit()

    def test_with_nothing_touched_the_picture_is_whole(self):
        window = self.opened()
        time.sleep(0.5)
        opened = []
        for i in range(6):
            opened.append(self.screen.picture(f"whole_{i}"))
            time.sleep(0.3)
        x, y = window.places["organ"]
        self.screen.key("1")
        window.wait("held Scalpel guided")
        for i in range(30):
            self.screen.move(x - 100 + 8 * i, y - 40 + 4 * i)
        ended, hovered = time.time(), []
        while time.time() - ended < 4:
            hovered.append((time.time() - ended, self.screen.dump("-root")[0]))
        self.screen.key("Escape")
        window.wait("held nothing")
        time.sleep(8)
        last = self.screen.picture("whole_last")
        most = 1.1 * equal_neighbours(last, self.view) + 0.01
        # The tissue still sinks when the window opens.
        for i, picture in enumerate(opened):
            self.assertLess(equal_neighbours(picture, self.view), most, i)
        most = 1.1 * equal_neighbours(hovered[-1][1], self.view) + 0.01  # with the instrument
        whole = next((after for after, picture in hovered if equal_neighbours(picture, self.view) < most), 100)
        print(f"whole {whole:.2f} s after the last motion of the mouse", file=sys.stderr)
        self.assertLess(whole, 2)  # half a second where nothing else runs

    def test_the_first_picture_comes_soon_and_something_is_said_before(self):
        best = 100
        for _ in range(3):  # other work on the machine is not to blame
            begun = time.time()
            window = Window(PROGRAM, self.screen, "--size", "1240x900")
            try:
                window.wait("waiting for", 60)
                window.wait("picture", 60)
                best = min(best, time.time() - begun)
            finally:
                window.quit()
        print(f"first picture after {best:.2f} s", file=sys.stderr)
        self.assertLess(best, 4)

    def test_slow_settings_offer_a_button_that_mends_them(self):
        window = self.opened("press", "--spacing", "3.5mm")
        # On a busy machine it is said before the first picture.
        before = [line for line in window.said if line.startswith("slow: cells of ")]
        offer = before[-1] if before else window.wait("slow: cells of ", 120)
        self.screen.picture("slow")
        self.assertGreater(int(offer.split()[3]), 3.5)
        self.screen.click(*window.places["smooth"])
        window.wait("organ liver", 120)
        self.say_places(window)

    def test_settings_that_wait_say_so_and_beginning_again_applies_them(self):
        window = self.thesis()
        self.screen.click(*window.places["Refinement"])
        self.screen.key("Up")
        window.wait("settings wait", 20)
        self.screen.picture("settings_wait")
        self.screen.key("Escape", "ctrl+n")
        window.wait("organ liver", 30)
        window.wait("settings are in force", 20)

    def test_a_scenario_has_the_instruments_that_it_lists(self):
        window = self.opened("cut-120")
        self.assertIn("Baton", window.places)
        self.assertNotIn("Scissors", window.places)
        self.screen.key("4")
        time.sleep(0.5)
        self.screen.key("3")
        self.assertEqual(window.wait("held"), "held Baton direct")

    def test_a_film_without_ffmpeg_names_the_package_and_asks_for_no_file(self):
        window = Window(PROGRAM, self.screen, "--size", "1240x900", environment={"PATH": str(FOLDER)})
        self.addCleanup(window.quit)
        window.wait("ready")
        self.screen.focus("^Resect")
        self.screen.key("ctrl+r")
        self.assertIn("package ffmpeg", window.wait("error ", 20))
        found = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "^Record film$"], env=self.screen.environment,
                               capture_output=True, text=True, timeout=30)
        self.assertEqual(found.stdout, "")

    def test_what_no_longer_holds_is_not_said_any_more(self):
        still = FOLDER / "still.toml"
        still.write_text('title = "A liver"\nduration = 1\n[organ]\nsource = "liver"\nspacing = "12mm"\n')
        window = self.opened(str(still))
        self.screen.key("p")
        window.wait("error There is no motion", 20)
        self.screen.move(*window.places["organ"])
        window.wait("error gone", 30)

    def test_the_wheel_zooms_to_the_pointer(self):
        window = self.thesis()
        x, y = window.places["Hook"]
        self.screen.move(x, y)
        for _ in range(8):
            self.screen.do("click", 4)
            time.sleep(0.1)
        time.sleep(1)
        self.screen.picture("zoomed")
        self.screen.click(x, y)
        window.wait("held Hook handle-box", 20)

    def test_beginning_again_keeps_the_view_and_space_brings_it_back(self):
        window = self.thesis("8mm")
        time.sleep(1)
        home = self.screen.picture("view_home")
        self.screen.drag((500, 650), (640, 600), button=3)
        time.sleep(1)
        turned = self.screen.picture("view_turned")
        self.assertGreater(difference(home, turned, self.view), 0.1)
        self.screen.key("ctrl+n")
        window.wait("organ liver", 30)
        time.sleep(1.5)
        self.assertLess(difference(turned, self.screen.picture("view_again"), self.view), 0.01)
        self.say_places(window)
        time.sleep(1)
        self.assertLess(difference(home, self.screen.picture("view_back"), self.view), 0.01)

    def test_an_instrument_finds_the_tissue_where_it_is_now(self):
        window = self.opened("drop")
        self.screen.key("a")  # all of it, before and after the fall
        window.wait("places", 20)
        time.sleep(6)
        fallen = self.screen.picture("fallen")
        x, y, share = red_middle(fallen, self.view)
        self.assertGreater(share, 0.01)
        self.assertGreater(y, window.places["organ"][1] + 15)  # lower than it was
        self.screen.key("1")
        window.wait("held Scalpel guided")
        self.screen.drag((x - 25, y), (x + 30, y + 5), steps=40)
        time.sleep(1.5)
        window.drain()
        cut = float([line for line in window.said if line.startswith("ledger")][-1].split()[-2])
        self.screen.picture("fallen_cut")
        self.assertGreater(cut, 0.5)

    def test_files_of_a_folder_whose_names_tell_nothing_get_roles_in_the_dialog(self):
        """Two label images: a block of 24 x 24 x 24 voxels of 4 mm, and a ball in it."""
        def image(name, inside):
            voxels = " ".join(str(int(inside(x, y, z))) for z in range(30) for y in range(30) for x in range(30))
            (folder / name).write_text("NRRD0004\ntype: uchar\ndimension: 3\nsizes: 30 30 30\n"
                                       "space: left-posterior-superior\nspace directions: (4,0,0) (0,4,0) (0,0,4)\n"
                                       "kinds: domain domain domain\nencoding: ascii\n\n" + voxels)

        folder = FOLDER / "folder"
        folder.mkdir()
        image("Leber.nrrd", lambda *at: all(3 <= c < 27 for c in at))
        image("Rundherd.nrrd", lambda x, y, z: (x - 12) ** 2 + (y - 15) ** 2 + (z - 15) ** 2 < 16)
        window = self.opened()
        window.tell(f"open {folder}")
        self.assertIn("Which one file is the organ?", window.wait("report "))
        for row, steps in enumerate((1, 2)):  # the organ, tumour
            window.drain()
            self.screen.choose(*window.places[f"role{row}"], *["Down"] * steps, "Return")
            report = window.wait("report ")
            if row == 0:
                window.wait("surface turns")  # the organ's
        self.assertIn("2 label images", report)
        time.sleep(1)
        self.screen.picture("folder_roles")
        self.screen.focus("^Open organ$")
        self.screen.key("Return")
        window.wait("organ Leber.nrrd")
        time.sleep(1)
        self.screen.picture("folder_opened")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:], verbosity=2)
