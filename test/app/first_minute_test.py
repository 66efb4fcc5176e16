#!/usr/bin/env python3
"""The first minutes of somebody new, with a real mouse on a virtual screen: an incision by the settings that the window
starts with, in living and in still tissue, and a cut beside a hook that was left holding.

    first_minute_test.py PROGRAM FOLDER     pictures are left in FOLDER
"""
import sys
import time
import unittest
from pathlib import Path

from screen import ScreenTest, difference

PROGRAM, FOLDER = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()


class FirstMinute(ScreenTest):
    program, folder = PROGRAM, FOLDER

    def opened(self, *args):
        window = super().opened(*args)
        time.sleep(1.5)  # the liver sinks
        return window

    def draw(self, first, last, button_down=True, steps=40):
        """At the pace of a hand: a second or two."""
        do = self.screen.do
        do("mousemove", *first)
        time.sleep(0.2)
        if button_down:
            do("mousedown", 1)
            time.sleep(0.15)
        for i in range(1, steps + 1):
            do("mousemove", *(int(a + (b - a) * i / steps) for a, b in zip(first, last)))
            time.sleep(0.03)
        time.sleep(0.3)

    def cut(self, window):
        """Area of the cuts so far, cm^2."""
        time.sleep(1.5)
        window.drain()
        return float([line for line in window.said if line.startswith("ledger")][-1].split()[-2])

    def take(self, window, key, name):
        self.screen.key(key)
        window.wait(f"held {name} guided")

    def incision(self, window):
        x, y = window.places["organ"]
        self.take(window, "1", "Scalpel")
        self.draw((x - 80, y - 120), (x - 40, y - 40), button_down=False, steps=10)
        self.assertEqual(self.cut(window), 0)  # hovering cuts nothing
        self.draw((x - 40, y - 40), (x + 20, y + 180))
        self.screen.do("mouseup", 1)

    def test_an_incision_within_a_minute(self):
        for name, args in ("living", ()), ("still", ("still_incise.toml",)):
            text = (Path(__file__).parents[2] / "data/scenarios/incise.toml").read_text()
            before, rest = text.split("[[tissue.attachment]]")
            still = ('mode = "operation"\n' + before.replace('model = "elastic"', 'model = "still"') + "[[tool]]" +
                     rest.split("[[tool]]", 1)[1])
            (FOLDER / "still_incise.toml").write_text(still)
            begun = time.time()
            window = self.opened(*args)
            self.incision(window)
            cut = self.cut(window)
            self.assertLess(time.time() - begun, 60)
            self.screen.key("Escape")
            time.sleep(1)
            self.screen.picture(f"incision_{name}")
            # Some 5 cm long at 16 mm depth, and nothing is removed.
            self.assertGreater(cut, 4, name)
            self.assertLess(cut, 20, name)
            self.assertEqual([line for line in window.said if line.startswith("removed")], [])
            self.screen.key("ctrl+z")
            window.wait("showing")
            self.assertEqual(self.cut(window), 0)
            window.quit()

    def test_the_hook_holds_while_the_scalpel_cuts(self):
        window = self.opened()
        x, y = window.places["organ"]
        self.take(window, "2", "Hook")
        self.draw((x + 170, y + 110), (x + 230, y + 110))
        self.screen.key("f")
        self.screen.do("mouseup", 1)
        window.wait("left Hook")
        self.take(window, "1", "Scalpel")
        self.draw((x + 60, y + 10), (x + 90, y + 170))
        self.screen.do("mouseup", 1)
        self.assertGreater(self.cut(window), 4)
        self.screen.picture("hook_and_scalpel")
        self.take(window, "2", "Hook")
        window.wait("left nothing")
        self.screen.key("space")
        window.wait("held nothing")

    def test_the_pencil_with_its_pedal_pressed_coagulates_the_surface_and_cuts_nothing(self):
        window = self.opened()
        x, y = window.places["organ"]
        self.screen.move(x, y - 150)
        time.sleep(1)
        before = self.screen.picture("before_the_pencil")
        self.take(window, "0", "Electrosurgical pencil")
        self.screen.do("mousemove", x, y + 20, "keydown", "p", "mousedown", 1)
        for i in range(20):
            self.screen.do("mousemove", x + 2 * i, y + 20)
            time.sleep(0.25)
        self.screen.do("mouseup", 1, "keyup", "p")
        self.screen.key("Escape")
        window.wait("held nothing")
        self.assertEqual(self.cut(window), 0)
        self.assertEqual([line for line in window.said if line.startswith("showing")], [])  # P played nothing
        after = self.screen.picture("after_the_pencil")
        self.assertGreater(difference(before, after, (x - 10, y, x + 50, y + 40)), 0.02)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
