#!/usr/bin/env python3
"""Twelve organs as people bring them: read, checked, taken, cut, incised and pressed.

    organs_test.py PROGRAM MAKER FOLDER
"""
import json
import os
import subprocess
import sys
import unittest
from pathlib import Path

PROGRAM, MAKER, FOLDER = sys.argv[1], sys.argv[2], Path(sys.argv[3])
LIMIT = 300 * float(os.environ.get("RESECT_PATIENCE", 1))  # s for one run; a sanitized program is slower
ORGANS = {  # side of the cells that an elastic run of a few seconds takes
    "liver": "10mm", "spleen": "6mm", "kidney": "6mm", "pancreas": "5mm", "gallbladder": "3mm", "stomach": "6.5mm",
    "lung": "11mm", "heart": "6mm", "aorta": "3mm", "uterus": "5mm", "bladder": "5mm", "brain": "9mm"}


def resect(*args):
    return subprocess.run([PROGRAM, *map(str, args)], capture_output=True, text=True, timeout=LIMIT)


class Organs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        FOLDER.mkdir(parents=True, exist_ok=True)
        subprocess.run([MAKER, FOLDER], check=True, timeout=LIMIT)

    def run_on(self, scenario, organ, *args):
        summary = FOLDER / f"{organ}_{scenario}.json"
        done = resect("run", scenario, "--organ", FOLDER / f"{organ}.stl", "--unit", "mm", "--json", summary, *args)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(summary.read_text())

    def test_each_organ_is_read_and_found_closed(self):
        for organ in ORGANS:
            with self.subTest(organ):
                told = json.loads(resect("info", "--json", "--unit", "mm", FOLDER / f"{organ}.stl").stdout)
                self.assertTrue(told["closed"])
                self.assertTrue(5 < told["organ_ml"] < 3000, told["organ_ml"])

    def test_incise_leaves_a_cut_and_takes_nothing_away(self):
        for organ, spacing in ORGANS.items():
            with self.subTest(organ):
                told = self.run_on("incise", organ, "--spacing", spacing)
                self.assertTrue(told["touched"])
                self.assertEqual(told["removed"], 0)
                # The aorta lies free, and its wall, one cell thick, gives way to the blade.
                self.assertGreater(told["ledger"][0]["cut_cm2"], 0.05 if organ == "aorta" else 0.3)
                self.assertEqual(told["tissue"]["torn_bonds"], 0)
                self.assertEqual(told["findings"], [])
                self.assertTrue(told["surface"]["closed"])

    def test_press_pushes_and_takes_nothing_away(self):
        for organ, spacing in ORGANS.items():
            with self.subTest(organ):
                told = self.run_on("press", organ, "--spacing", spacing)
                self.assertEqual(told["removed"], 0)
                force = max(tool["peak"] for tool in told["tool_forces_n"])
                self.assertTrue(0.1 < force < 50, force)
                self.assertEqual(told["tissue"]["severed_bonds"], 0)
                self.assertEqual(told["findings"], [])

    def test_auto_keeps_the_tissue_and_says_what_it_chose(self):
        for organ in ("spleen", "bladder", "gallbladder"):
            with self.subTest(organ):
                mesh = FOLDER / f"{organ}.stl"
                whole = json.loads(resect("info", "--json", "--unit", "mm", mesh).stdout)["organ_ml"]
                done = resect("run", "cut", "--organ", mesh, "--unit", "mm", "--spacing", "auto", "--strict")
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertIn("the largest that keep 98 % of the tissue", done.stdout)
                told = self.run_on("cut", organ, "--spacing", "auto")
                self.assertGreater(told["organ_ml"], 0.97 * whole)
                self.assertGreater(told["removed"], 0)
                self.assertEqual(told["findings"], [])
        done = resect("run", "press", "--organ", FOLDER / "spleen.stl", "--unit", "mm", "--spacing", "auto")
        self.assertRegex(done.stdout, "a frame of 16.7 ms will take about .* ms: real time")
        scenario = FOLDER / "auto.toml"
        scenario.write_text('title = "Auto"\nduration = 0.02\n[organ]\nsource = "spleen.stl"\nunit = "mm"\n'
                            'spacing = "auto"\n')
        self.assertIn("the largest that keep 98 %", resect("run", scenario).stdout)

    def test_strict_tells_what_did_not_happen(self):
        miss = FOLDER / "miss.toml"
        miss.write_text('title = "A cut"\npromises = ["removal"]\nduration = 0.6\n[organ]\nspacing = "20mm"\n'
                        '[[tool]]\nmodel = "scalpel"\nkeys = [{ time = 0.1, position = [1, 1, 1] }, '
                        '{ time = 0.5, position = [1, 1, 0.9] }]\n')
        done = resect("run", miss)
        self.assertEqual(done.returncode, 0)
        self.assertIn("scalpel was in hand and met no organ", done.stdout)
        self.assertIn("not as the scenario is meant: no tissue was removed", done.stdout)
        done = resect("run", miss, "--strict")
        self.assertEqual(done.returncode, 1)
        self.assertIn("leave out --strict", done.stderr)
        self.assertEqual(resect("run", "cut-120", "--strict").returncode, 0)
        # What the scalpel alone does not promise, it does not do: --without leaves it on the tray.
        done = resect("run", "bleed", "--spacing", "20mm", "--without", "scalpel", "--strict")
        self.assertEqual((done.returncode, "0.0 ml bled" in done.stdout), (1, True))
        self.assertIn("no blood was lost", done.stderr)
        done = resect("run", "bleed", "--without", "saw")
        self.assertEqual(done.returncode, 2)
        self.assertIn('names "saw", which this scenario does not have; it has scalpel, hook', done.stderr)
        miss.write_text('title = "A cut"\npromises = ["glory"]\nduration = 0.6\n')
        self.assertIn("use some of these: removal, cut, push, parts, blood, dry", resect("run", miss).stderr)

    def box_of_cells(self, *args):
        """The box, mm, of a body from 10 to 110, 0 to 60 and 0 to 30 mm along the model's axes."""
        model = FOLDER / "box.obj"
        corners = [[(10, 110)[i & 1], (0, 60)[i >> 1 & 1], (0, 30)[i >> 2 & 1]] for i in range(8)]
        faces = ((1, 3, 4), (1, 4, 2), (5, 6, 8), (5, 8, 7), (1, 2, 6), (1, 6, 5),
                 (3, 7, 8), (3, 8, 4), (1, 5, 7), (1, 7, 3), (2, 4, 8), (2, 8, 6))
        model.write_text("".join("v {} {} {}\n".format(*c) for c in corners) +
                         "".join("f {} {} {}\n".format(*f) for f in faces))
        cells, surface = FOLDER / "box.resect-cells", FOLDER / "box_out.obj"
        done = resect("discretize", model, "--unit", "mm", "--spacing", "5mm", "-o", cells, *args)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(resect("surface", cells, "-o", surface).returncode, 0)
        points = [list(map(float, line.split()[1:4])) for line in surface.read_text().splitlines()
                  if line.startswith("v ")]
        return [(round(1000 * min(p[a] for p in points)), round(1000 * max(p[a] for p in points))) for a in range(3)]

    def test_orientation_turns_the_models_axes_to_those_of_the_room(self):
        long, middle, short = (10, 110), (0, 60), (0, 30)
        back = lambda ends: (-ends[1], -ends[0])
        for letters, box in (("LAI", (long, middle, short)), ("LPS", (long, back(middle), back(short))),
                             ("RAS", (back(long), middle, back(short))), ("pir", (back(short), back(long), middle)),
                             ("SLP", (middle, back(short), back(long)))):
            with self.subTest(letters):
                for (low, high), (l, h) in zip(self.box_of_cells("--orientation", letters), box):
                    self.assertAlmostEqual(low, l, delta=1)
                    self.assertAlmostEqual(high, h, delta=1)
        for (low, high), (l, h) in zip(self.box_of_cells("--rotate", "0,90,0"), (short, middle, back(long))):
            self.assertAlmostEqual(low, l, delta=1)
            self.assertAlmostEqual(high, h, delta=1)
        for option, value, sentence in (("--orientation", "LRS", "give where the model's x, y and z axis point to"),
                                        ("--orientation", "LAS", "is left-handed"),
                                        ("--orientation", "LP", "give where the model's"),
                                        ("--rotate", "90", "as 0,90,0"), ("--rotate", "a,b,c", "as 0,90,0")):
            done = resect("run", "cut-120", option, value)
            self.assertEqual(done.returncode, 2, value)
            self.assertIn(sentence, done.stderr)
        done = resect("run", "cut-120", "--organ", FOLDER / "box.resect-cells", "--rotate", "0,90,0")
        self.assertEqual(done.returncode, 2)
        self.assertIn("are not turned", done.stderr)

    def test_a_turned_organ_is_cut_too(self):
        for args in (("--orientation", "LPS"), ("--rotate", "20,65,-30"), ("--orientation", "RAS", "--rotate", "0,90,0")):
            for organ in ("pancreas", "stomach"):
                told = self.run_on("cut", organ, "--spacing", "4mm", "--strict", *args)
                self.assertGreater(told["removed"], 4)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
