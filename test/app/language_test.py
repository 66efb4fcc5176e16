#!/usr/bin/env python3
"""The window in German, on a virtual screen of the size of a small laptop: how the language is chosen, that texts of
data files and sentences of the operation are German too, and that no text is cut.

    language_test.py PROGRAM FOLDER     pictures are left in FOLDER
"""
import re
import shutil
import subprocess
import sys
import time
import unittest
from pathlib import Path

from screen import Screen, Window

PROGRAM, FOLDER = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
SETTINGS = FOLDER / "config/Resect/Resect.conf"


class German(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(FOLDER, ignore_errors=True)
        FOLDER.mkdir(parents=True, mode=0o700)
        cls.screen = Screen(FOLDER, 1366, 768)

    @classmethod
    def tearDownClass(cls):
        cls.screen.close()

    def setUp(self):
        SETTINGS.unlink(missing_ok=True)
        SETTINGS.parent.mkdir(parents=True, exist_ok=True)

    def opened(self, *args, environment=None):
        window = Window(PROGRAM, self.screen, "--size", "1366x768", *args, environment=environment)
        self.addCleanup(window.quit)
        return window

    def ready(self, *args, **more):
        window = self.opened(*args, **more)
        window.wait("ready")
        self.screen.focus("^Resect")
        return window

    def nothing_cut(self, window, picture):
        """The window names texts that do not fit."""
        time.sleep(1)
        window.drain()
        window.tell("places")
        window.wait("places")
        self.screen.picture(picture)
        self.assertEqual([line for line in window.said if line.startswith("cut text")], [])

    def buttons(self, window):
        """Names of buttons and fields of the page of exercises."""
        window.wait("exercises shown")
        return set(window.places)

    def test_the_option_chooses_the_language(self):
        german = self.buttons(self.opened("--language", "de", "--exercises"))
        self.assertLessEqual({"Schließen", "Hinzufügen ...", "Als Prüfung", "Clippen und durchtrennen beginnen"}, german)
        english = self.buttons(self.opened("--language", "en", "--exercises"))
        self.assertLessEqual({"Close", "Add ...", "As a test", "Start Clip and divide"}, english)

    def test_else_the_menu_s_choice_and_the_system_s_language_choose_it(self):
        environment = {"LC_ALL": "de_DE.UTF-8"}
        self.assertIn("Schließen", self.buttons(self.opened("--exercises", environment=environment)))
        SETTINGS.write_text("[General]\nlanguage=en\n")
        self.assertIn("Close", self.buttons(self.opened("--exercises", environment=environment)))
        SETTINGS.write_text("[General]\nlanguage=de\n")
        self.assertIn("Schließen", self.buttons(self.opened("--exercises")))

    def test_a_language_that_the_window_lacks_is_refused(self):
        done = subprocess.run([PROGRAM, "window", "--language", "xx"], env=self.screen.environment, capture_output=True,
                              text=True, timeout=60)
        self.assertEqual(done.returncode, 2)
        self.assertRegex(done.stderr, r"^resect: error: .*--language.*\n$")
        self.assertRegex(done.stderr, "en.*de")

    def test_no_text_is_cut_in_the_operation(self):
        window = self.ready("--language", "de")
        self.nothing_cut(window, "operation")
        self.screen.key("1")
        window.wait("held Scalpel guided")
        self.nothing_cut(window, "instrument")
        self.screen.key("F2")
        window.wait("laboratory shown")
        self.nothing_cut(window, "laboratory")
        self.assertIn("Zellgröße", window.places)

    def test_no_text_is_cut_where_an_exercise_is_made(self):
        window = self.ready("--language", "de", "--exercises")
        self.screen.click(*window.places["Selbst machen"])
        window.wait("maker shown")
        for picture in ("points", "line", "structure", "bleeding", "vessel", "plane"):
            self.nothing_cut(window, f"making_{picture}")
            self.screen.choose(*window.places["Ziel"], "Down", "Return")

    def test_an_exercise_is_in_german_to_its_result(self):
        window = self.ready("touch-and-hold", "--language", "de")
        self.nothing_cut(window, "exercise")
        self.screen.key("1")
        window.wait("held")
        time.sleep(2)
        self.screen.picture("exercise_begun")
        window.tell("places")
        window.wait("places")
        self.screen.click(*window.places["Beenden"])
        # Reports of what happens stay English. On a slow machine the time may be up.
        self.assertRegex(window.wait("exercise ended"), r": (Finished\.|The time is up\.)")
        window.wait("result failed", 120)
        window.wait("report written", 120)
        self.nothing_cut(window, "result")
        facts = [name for name in window.places if re.match(r"\d\.", name)]
        self.assertTrue(any("0 von 4 Zielpunkten wurden" in fact for fact in facts), window.places)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
