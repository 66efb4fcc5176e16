"""The committed models of the instruments and the room are closed solids, life size, and as their
descriptions say.

    python3 test/models/models_test.py [-v]
"""

import math
import os
import random
import re
import subprocess
import sys
import tomllib
import unittest

import inventor_text
import solid

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
FOLDER = os.path.join(SOURCE, "data")
INSTRUMENTS = ("scalpel", "hook", "baton", "scissors", "suction", "clip_applier", "bipolar", "gauze",
               "inflow_clamp", "pencil", "aspirator", "forceps")
SHELLS = {
    "scalpel": 1,
    "hook": 1,
    "baton": 1,
    "scissors": 5,
    "suction": 1,
    "clip_applier": 7,
    "gauze": 10,
    "inflow_clamp": 9,
    "pencil": 7,
    "aspirator": 4,
    "bipolar": 5,
    "forceps": 3,
    "table": 1,
    "toolbox": 2,
    "tray": 2,
}
ROOM = ("table", "toolbox", "tray")
MILLIMETRE = 0.001


def model_file(name):
    return os.path.join(FOLDER, "room" if name in ROOM else "tools", name + ".iv")


class Model:
    """The triangles of one .iv file: positions, corner normals and welded faces."""

    def __init__(self, name):
        with open(model_file(name), encoding="utf-8") as file:
            corners = inventor_text.triangles(inventor_text.read_strips(file.read()))
        self.triangles = [tuple(position for position, _ in triangle) for triangle in corners]
        self.normals = [tuple(normal for _, normal in triangle) for triangle in corners]
        self.points = [point for triangle in self.triangles for point in triangle]
        welded = solid.weld(self.points)
        self.faces = [tuple(welded[i : i + 3]) for i in range(0, len(welded), 3)]

    def extent(self, axis):
        values = [point[axis] for point in self.points]
        return min(values), max(values)


MODELS = {name: Model(name) for name in SHELLS}


def inventor_parts(name):
    """{part: its points} of a model with named parts."""
    with open(model_file(name), encoding="utf-8") as file:
        text = file.read()
    head, *parts = re.split(r"(?=^  DEF )", text, flags=re.MULTILINE)
    header = head.splitlines()[0] + "\n"
    result = {}
    for part in parts:
        strips = inventor_text.read_strips(header + part.rstrip().removesuffix("\n}") + "\n")
        result[part.split()[1]] = [position for strip in strips for position, _ in strip]
    return result


def description(name):
    with open(os.path.join(FOLDER, "tools", name + ".toml"), "rb") as file:
        return tomllib.load(file)


class EveryModel(unittest.TestCase):
    def check(self, test):
        for name, model in MODELS.items():
            with self.subTest(model=name):
                test(name, model)

    def test_is_closed_and_consistently_oriented(self):
        self.check(lambda name, model: self.assertEqual(solid.unmatched_edges(model.faces), []))

    def test_consists_of_the_expected_shells_each_with_positive_volume(self):
        def test(name, model):
            shells = solid.shells(model.faces)
            self.assertEqual(len(shells), SHELLS[name])
            for shell in shells:
                # The least is half of the clip applier's clip.
                self.assertGreater(solid.volume([model.triangles[k] for k in shell]), 5e-9)

        self.check(test)

    def test_has_no_degenerate_triangle(self):
        self.check(
            lambda name, model: self.assertGreater(min(map(solid.area, model.triangles)), 1e-9)
        )

    def test_has_unit_normals_on_the_outer_side_of_their_triangle(self):
        def test(name, model):
            for (a, b, c), normals in zip(model.triangles, model.normals):
                face = solid.cross(solid.subtract(b, a), solid.subtract(c, a))
                for normal in normals:
                    self.assertAlmostEqual(solid.length(normal), 1.0, delta=2e-4)
                    self.assertGreater(solid.dot(face, normal), 0.5 * solid.length(face))

        self.check(test)

    def test_has_winding_number_0_or_1_near_its_surface(self):
        """A fold of the surface through itself would give 2 or -1."""

        def test(name, model):
            chance = random.Random(7)
            seen = set()
            for _ in range(24):
                triangle = chance.choice(model.triangles)
                point = tuple(
                    sum(axis) / 3.0 + chance.gauss(0.0, 0.3 * MILLIMETRE) for axis in zip(*triangle)
                )
                winding = solid.winding_number(point, model.triangles)
                self.assertAlmostEqual(winding, round(winding), delta=1e-6)
                seen.add(round(winding))
            # Shells that overlap, as where a finger ring meets its shank, count twice there.
            most = 1 if SHELLS[name] <= 2 else 2
            self.assertTrue({0, 1} <= seen <= set(range(most + 1)), seen)

        self.check(test)


class EveryInstrument(unittest.TestCase):
    def check(self, test):
        for name in INSTRUMENTS:
            with self.subTest(instrument=name):
                test(MODELS[name], description(name))

    def test_is_as_long_as_a_real_one(self):
        def test(model, text):
            low, high = model.extent(2)
            self.assertTrue(0.15 <= high - low <= 0.20)

        self.check(test)

    def test_has_its_tip_on_the_surface_and_the_handle_along_its_axis(self):
        def test(model, text):
            # The tip of a tube that sucks is the middle of its mouth, away from the rim.
            most = 1.8 if text["kind"] in ("suction", "aspirator") else 0.01
            self.assertLess(solid.distance(text["tip"], model.triangles), most * MILLIMETRE)
            self.assertAlmostEqual(solid.length(text["axis"]), 1.0, delta=1e-9)
            along = [
                solid.dot(solid.subtract(point, text["tip"]), text["axis"])
                for point in model.points
            ]
            self.assertGreaterEqual(min(along), -0.01 * MILLIMETRE)
            self.assertGreater(max(along), 0.15)

        self.check(test)

    def test_names_its_kind_and_its_model_file(self):
        for name in INSTRUMENTS:
            text = description(name)
            self.assertEqual((text["kind"], text["model"]), (name, name + ".iv"))
            self.assertTrue(text["name"] and text["description"])


class TheScalpel(unittest.TestCase):
    def test_has_its_cutting_edge_on_the_surface(self):
        edge = description("scalpel")["edge"]
        self.assertEqual(edge[0], description("scalpel")["tip"])
        for start, end in zip(edge, edge[1:]):
            for share in (0.5, 1.0):
                point = [a + share * (b - a) for a, b in zip(start, end)]
                self.assertLess(
                    solid.distance(point, MODELS["scalpel"].triangles), 0.02 * MILLIMETRE
                )

    def test_cuts_towards_minus_y_with_nothing_of_the_blade_below_the_edge(self):
        edge = description("scalpel")["edge"]
        heel = edge[-1][2]
        self.assertTrue(0.030 < heel < 0.045)
        for x, y, z in MODELS["scalpel"].points:
            if z <= heel:
                below = next((a, b) for a, b in zip(edge, edge[1:]) if a[2] <= z <= b[2])
                share = (z - below[0][2]) / (below[1][2] - below[0][2])
                self.assertGreaterEqual(y, below[0][1] + share * (below[1][1] - below[0][1]) - 1e-7)

    def test_has_a_blade_of_0_4_mm_that_is_sharp_at_the_edge(self):
        edge = {tuple(point) for point in description("scalpel")["edge"]}
        self.assertTrue(all(x == 0.0 for x, _, _ in edge))
        before_the_tongue = [x for x, _, z in MODELS["scalpel"].points if 0.006 <= z <= 0.0186]
        self.assertAlmostEqual(
            max(before_the_tongue) - min(before_the_tongue), 0.4 * MILLIMETRE, delta=1e-9
        )


class TheHook(unittest.TestCase):
    def test_ends_in_its_point(self):
        self.assertLess(
            solid.distance(description("hook")["point"], MODELS["hook"].triangles),
            0.01 * MILLIMETRE,
        )

    def test_has_its_centre_line_inside_and_about_a_wire_radius_from_the_surface(self):
        model = MODELS["hook"]
        for point in description("hook")["hook"]:
            self.assertAlmostEqual(solid.winding_number(point, model.triangles), 1.0, delta=1e-6)
            self.assertTrue(
                1.0 * MILLIMETRE < solid.distance(point, model.triangles) < 1.6 * MILLIMETRE
            )

    def test_bends_with_a_radius_of_10_mm_towards_minus_y(self):
        line = description("hook")["hook"]
        a, b, c = line[0], line[len(line) // 2], line[-1]
        sides = [solid.length(solid.subtract(p, q)) for p, q in ((a, b), (b, c), (c, a))]
        radius = sides[0] * sides[1] * sides[2] / (4.0 * solid.area((a, b, c)))
        self.assertAlmostEqual(radius, 10.0 * MILLIMETRE, delta=0.01 * MILLIMETRE)
        self.assertLess(line[0][1], line[-1][1])


class TheBaton(unittest.TestCase):
    def test_has_the_coordinates_of_the_thesis(self):
        """Section 4.1.1: a frustum from a square of side 0.5 to one of side 1.1, 15 long; here
        0.012 m for each unit."""
        tip = [(x, y, 0.0) for x in (0.0, 0.5) for y in (0.0, 0.5)]
        end = [(x, y, 15.0) for x in (-0.3, 0.8) for y in (-0.3, 0.8)]
        expected = sorted(
            tuple(round(0.012 * v, 9) for v in (x - 0.25, y - 0.25, z)) for x, y, z in tip + end
        )
        actual = sorted({tuple(round(v, 9) for v in point) for point in MODELS["baton"].points})
        self.assertEqual(actual, expected)
        self.assertEqual(len(MODELS["baton"].triangles), 12)

    def test_has_the_volume_of_that_frustum(self):
        small, large = 0.5**2, 1.1**2
        expected = 0.012**3 * 15.0 / 3.0 * (small + 0.5 * 1.1 + large)
        self.assertAlmostEqual(solid.volume(MODELS["baton"].triangles), expected, delta=1e-12)

    def test_touches_within_half_its_tip(self):
        self.assertAlmostEqual(description("baton")["contact_radius"], 0.003, delta=1e-9)


class TheSuctionTube(unittest.TestCase):
    def test_has_its_mouth_in_the_plane_of_its_tip_with_a_bore_behind_it(self):
        model = MODELS["suction"]
        rim = [solid.length(p) for p in model.points if p[2] == 0.0]
        self.assertTrue(1.6 * MILLIMETRE < min(rim) and max(rim) < 3.3 * MILLIMETRE)
        for z, inside in ((1.0, 0.0), (4.0, 0.0), (7.0, 1.0)):
            along = (0.0, math.tan(math.radians(15.0)) * z * MILLIMETRE, z * MILLIMETRE)
            self.assertAlmostEqual(solid.winding_number(along, model.triangles), inside, delta=1e-6)

    def test_touches_within_the_radius_of_its_head(self):
        radius = description("suction")["contact_radius"]
        head = [abs(x) for x, _, z in MODELS["suction"].points if z < 0.015]
        self.assertAlmostEqual(max(head), radius, delta=0.05 * MILLIMETRE)


class TheJaws(unittest.TestCase):
    """Of instruments that grip but do not cut; their models are read closed."""

    def test_meet_at_the_tip_and_nowhere_pass_each_other_in_front_of_the_pivot(self):
        for name, until in (("clip_applier", 0.024), ("bipolar", 0.14), ("forceps", 0.14), ("inflow_clamp", 0.034)):
            text = description(name)
            self.assertNotIn("edge", text)
            self.assertEqual((text["jaw_axis"], text["tip"]), ([1.0, 0.0, 0.0], [0.0, 0.0, 0.0]))
            jaws = inventor_parts(name)
            for part, side in (("JawUpper", 1.0), ("JawLower", -1.0)):
                front = [side * y for _, y, z in jaws[part] if z <= until]
                self.assertGreater(min(front), 0.0)

    def test_open_about_as_wide_at_their_ends_as_real_ones(self):
        for name, least, most in (("clip_applier", 0.007, 0.009), ("bipolar", 0.008, 0.012), ("forceps", 0.008, 0.012), ("inflow_clamp", 0.015, 0.020)):
            text = description(name)
            width = text["jaw_pivot"][2] * text["jaw_opening"]
            self.assertTrue(least < width < most, (name, width))


class TheRoom(unittest.TestCase):
    def test_has_a_table_whose_top_is_exactly_the_plane_y_0(self):
        self.assertEqual(MODELS["table"].extent(1)[1], 0.0)
        for x, z in ((0.0, 0.0), (0.2, 0.15), (-0.4, 0.25), (0.42, -0.2)):
            self.assertLess(solid.distance((x, 0.0, z), MODELS["table"].triangles), 1e-9)

    def test_has_a_tool_box_of_the_right_size_that_stands_on_its_bottom(self):
        for axis, (low, high) in enumerate(((-0.15, 0.15), (0.0, 0.025), (-0.11, 0.11))):
            actual = MODELS["toolbox"].extent(axis)
            self.assertAlmostEqual(actual[0], low, delta=1e-6)
            self.assertAlmostEqual(actual[1], high, delta=1e-6)

    def test_has_a_tool_box_in_which_every_instrument_fits_lengthwise(self):
        for name in INSTRUMENTS:
            low, high = MODELS[name].extent(2)
            self.assertLess(high - low, 0.19)


class TheGenerator(unittest.TestCase):
    def test_writes_exactly_the_committed_files(self):
        program = os.path.join(SOURCE, "tools", "make_models", "make_models.py")
        result = subprocess.run(
            [sys.executable, "-B", program, FOLDER, "--check"],
            capture_output=True,
            text=True,
            check=False,
        )
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)


if __name__ == "__main__":
    unittest.main()
