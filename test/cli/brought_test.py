#!/usr/bin/env python3
"""Models as people bring them: several parts, other units, shells in shells; what each command says about them.

    brought_test.py PROGRAM FOLDER
"""
import json
import os
import subprocess
import sys
import unittest
from pathlib import Path

PROGRAM, FOLDER = sys.argv[1], Path(sys.argv[2])
LIMIT = 300 * float(os.environ.get("RESECT_PATIENCE", 1))  # s for one run; a sanitized program is slower
FACES = ((1, 3, 4), (1, 4, 2), (5, 6, 8), (5, 8, 7), (1, 2, 6), (1, 6, 5),
         (3, 7, 8), (3, 8, 4), (1, 5, 7), (1, 7, 3), (2, 4, 8), (2, 8, 6))


def resect(*args):
    return subprocess.run([PROGRAM, *map(str, args)], capture_output=True, text=True, timeout=LIMIT)


def points(sides, low=(0, 0, 0)):
    """The eight corners of a box as lines of an .obj file."""
    corners = [[low[a] + (sides[a] if i >> a & 1 else 0) for a in range(3)] for i in range(8)]
    return "".join(f"v {x} {y} {z}\n" for x, y, z in corners)


def faces(which=FACES, before=0):
    return "".join("f {} {} {}\n".format(*(i + before for i in face)) for face in which)


def write(name, text):
    FOLDER.mkdir(parents=True, exist_ok=True)
    (FOLDER / name).write_text(text)
    return FOLDER / name


def info(*args):
    return json.loads(resect("info", "--json", *args).stdout)


class Brought(unittest.TestCase):
    def test_small_vessels_grow_from_the_veins_that_a_liver_is_brought_with(self):
        """The built-in liver as model files, and its veins' shapes, of which thinning finds the wide ones alone."""
        FOLDER.mkdir(parents=True, exist_ok=True)
        liver, trees = FOLDER / "liver.ply", FOLDER / "trees"
        resect("liver", "-o", liver)
        resect("anatomy", "--meshes", trees)
        brought = ("anatomy", "--json", "--organ", liver, "--structure", f"portal-vein={trees / 'portal-vein.ply'}",
                   "--structure", f"hepatic-vein={trees / 'hepatic-vein.ply'}")
        found = json.loads(resect(*brought, "--only-found").stdout)["vessels"]
        self.assertLess(found["portal-vein"]["terminals"], 100)
        self.assertEqual(found["hepatic-artery"]["terminals"], 0)
        grown = json.loads(resect(*brought).stdout)
        for kind, least in (("portal-vein", 1000), ("hepatic-vein", 1000), ("hepatic-artery", 950), ("bile-duct", 950)):
            self.assertGreaterEqual(grown["vessels"][kind]["terminals"], least, kind)
            self.assertEqual(grown["vessels"][kind]["outside_mm"], 0, kind)
        self.assertEqual(set(grown["crossings"].values()), {0})
        whole = json.loads(resect("anatomy", "--json").stdout)
        self.assertEqual(json.loads(resect("anatomy", "--json", "-").stdout), whole)
        resect("anatomy", "--json", FOLDER / "anatomy.json")
        self.assertEqual(json.loads((FOLDER / "anatomy.json").read_text()), whole)
        self.assertLess(whole["to_portal_terminal_mm"]["mean"], 7)
        self.assertLess(whole["to_portal_terminal_mm"]["largest"], 25)
        for segment in ("I", "II", "III", "IV", "V", "VI", "VII", "VIII"):
            for kind in ("portal branch", "artery", "bile duct"):
                self.assertIn(f"{kind} of segment {segment}", [branch["name"] for branch in whole["couinaud"]["branches"]])
        own = whole["couinaud"]["segments_ml"]
        for segment, ml in grown["couinaud"]["segments_ml"].items():
            self.assertLess(abs(ml - own[segment]), 0.3 * own[segment], segment)

    def test_parts_that_are_named_several_times_are_joined_by_every_command(self):
        model = write("patches.obj", points((0.1, 0.1, 0.1)) + "o capsule\n" + faces(FACES[:10]) + "o bare area\n" +
                      faces(FACES[10:]) + "o sheet\nv 0.05 0.02 0.02\nv 0.05 0.08 0.02\nv 0.05 0.05 0.08\nf 9 10 11\n")
        parts = ["--part", "capsule", "--part", "bare area"]
        self.assertIsNone(info(model)["organ_ml"])
        self.assertIn("choose some with --part", info(model)["refusal"])
        self.assertAlmostEqual(info(model, *parts)["organ_ml"], 1000, places=6)
        self.assertEqual([part["closed"] for part in info(model, *parts)["part_health"]], [False, False])
        whole = FOLDER / "patches.ply"
        self.assertEqual(resect("convert", model, whole, *parts).returncode, 0)
        self.assertTrue(info(whole)["closed"])
        cells = FOLDER / "patches.dis"
        made = resect("discretize", *parts, model, "--spacing", "10mm", "-o", cells, "--json")
        self.assertAlmostEqual(json.loads(made.stdout)["volume_ml"], 1000, delta=1)
        done = resect("run", "cut-120", "--organ", model, *parts)
        self.assertEqual(done.returncode, 0, done.stderr)
        scenario = write("patches.toml", 'title = "Patches"\nduration = 0.02\n[organ]\nsource = "patches.obj"\n'
                         'part = ["capsule", "bare area"]\nspacing = "20mm"\n')
        done = resect("run", scenario)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("1000.00 ml", done.stdout)
        done = resect("info", model, "--part", "capsule", "--part", "liver")
        self.assertEqual(done.returncode, 1)
        self.assertIn("no part 'liver'; choose one of: capsule, bare area, sheet", done.stderr)

    def test_every_command_that_refuses_or_doubts_a_size_names_the_unit(self):
        model, out = write("in_mm.obj", points((200, 150, 100)) + faces()), FOLDER / "in_mm.dis"
        out.unlink(missing_ok=True)
        hint = "in mm it would be 0.2 m: add --unit mm"
        self.assertIn(hint, resect("info", model).stdout)
        self.assertEqual(info(model)["unit_hint"], "mm")
        self.assertIn(hint, resect("convert", model, FOLDER / "in_m.obj").stdout)
        for args in (["run", "cut", "--organ", model], ["discretize", model, "-o", out],
                     ["run", "snip", "--organ", model, "--dims", "10"]):
            done = resect(*args)
            self.assertEqual(done.returncode, 1, args)
            self.assertIn(hint, done.stderr, args)
            self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        self.assertFalse(out.exists())
        done = resect("discretize", model, "--unit", "mm", "--spacing", "10mm", "-o", out)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("no organ's", done.stdout)
        small = resect("discretize", write("in_m.obj", points((0.2, 0.1, 0.1)) + faces()), "--unit", "mm", "-o", out)
        self.assertEqual(small.returncode, 1)
        self.assertIn("in m it would be 0.2 m: add --unit m", small.stderr)

    def test_instruments_that_miss_an_organ_are_told_with_the_place_of_the_organ(self):
        done = resect("run", "resect-segment", "--organ", write("small.obj", points((0.06, 0.05, 0.05)) + faces()))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("no instrument met an organ", done.stdout)
        self.assertRegex(done.stdout, r"the organ fills -0.03\d to 0.03\d m from left to right, 0.00\d to 0.05\d m in height")
        done = resect("run", "snip", "--organ", FOLDER / "small.obj")
        self.assertEqual(done.returncode, 1)
        self.assertIn("holds no particle; move or enlarge its region (the organ at rest fills", done.stderr)

    def test_a_shell_in_a_shell_is_told_with_its_millilitres(self):
        outer, inner = points((0.1, 0.1, 0.1)), points((0.04, 0.04, 0.04), (0.03, 0.03, 0.03))
        outward = write("outward.obj", outer + inner + faces() + faces(before=8))
        inward = write("inward.obj", outer + inner + faces() + faces([face[::-1] for face in FACES], 8))
        cells = FOLDER / "shells.dis"
        for model, ml, what in ((outward, 1000, "1 inner shell of 64 ml facing outwards"),
                                (inward, 936, "1 inner shell of 64 ml facing inwards: a cavity")):
            self.assertAlmostEqual(info(model)["organ_ml"], ml, places=6)
            made = resect("discretize", model, "--spacing", "10mm", "-o", cells)
            self.assertIn(what, made.stdout)
            self.assertIn(f"{ml}.0 ml", made.stdout)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
