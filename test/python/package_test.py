"""The package: scenarios, organs, steps, states, arrays, recordings, errors."""
import ast
import gc
import os
import pathlib
import sys
import threading
import time
import unittest

import numpy as np
import resect

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import expected_states  # noqa: E402


def soft_box(nx=10, ny=4, nz=8, labels=""):
    """An elastic block on the table, pinned at its bottom, with a baton and a scalpel."""
    scenario = resect.Scenario.parse(f"""
        title = "A block"
        mode = "operation"
        duration = 2
        [organ]
        source = "liver"
        spacing = "10mm"
        {labels}
        [room]
        tool_box = false
        [tissue]
        model = "elastic"
        plain = true
        [[tissue.attachment]]
        frame = "organ"
        box = [[0, 0, 0], [1, 0.2, 1]]
        [[tool]]
        model = "baton"
        [[tool]]
        model = "scalpel"
        """, "block")
    cells = np.ones((nz, ny, nx), np.float32)
    return resect.Simulation(scenario, resect.Organ.from_cells(cells, 0.01, [-0.045, 0.005, -0.035]))


def pressing(simulation, depth):
    """Rows with the baton in hand over the middle, its tip at a height."""
    rows = simulation.tool_rests()
    rows[0] = [0.005, depth, 0.005, -np.sqrt(0.5), 0, 0, np.sqrt(0.5), 0, 0, 1]
    return rows


class Simulations(unittest.TestCase):
    def test_a_scenario_gives_the_bits_that_the_program_gives(self):
        for name, states in (("perforate-120", expected_states.STILL), ("snip", expected_states.ELASTIC)):
            scenario = resect.Scenario(name)
            simulation = resect.Simulation(scenario)
            for frame in range(scenario.frame_count):
                simulation.step(scenario.inputs(frame))
            self.assertEqual(f"{simulation.state_hash:016x}", states[name], name)

    def test_a_pressed_block_pushes_back(self):
        simulation = soft_box()
        for frame in range(30):
            report = simulation.step(pressing(simulation, 0.06 - 0.001 * frame))
        self.assertEqual(report.tool_force.shape, (2, 3))
        self.assertGreater(report.tool_force[0, 1], 0.1)  # upwards
        self.assertEqual(report.tool_force[1].tolist(), [0, 0, 0])
        _, uy, _ = simulation.organ().displacement
        self.assertLess(uy[:, -1, :].min(), -0.0015)  # the top is pressed in

    def test_what_follows_a_restored_state_has_the_same_bits(self):
        simulation = soft_box()
        simulation.step(pressing(simulation, 0.04))
        state = simulation.save()
        hashes = []
        for _ in range(2):
            for frame in range(5):
                simulation.step(pressing(simulation, 0.04 - 0.001 * frame))
            hashes.append(simulation.state_hash)
            simulation.restore(state)
        self.assertEqual(hashes[0], hashes[1])
        self.assertEqual(simulation.save(), state)

    def test_the_lock_of_python_is_free_during_a_step(self):
        simulation = resect.Simulation(resect.Scenario("press"))
        counted = []

        def count():
            while not done.is_set():
                counted.append(time.perf_counter())
                time.sleep(0.001)

        done = threading.Event()
        thread = threading.Thread(target=count)
        thread.start()
        begin = time.perf_counter()
        simulation.step(duration=1.0)  # some 100 ms
        end = time.perf_counter()
        done.set()
        thread.join()
        self.assertGreater(sum(begin < t < end for t in counted), 3)

    def test_one_simulation_in_two_threads_is_an_error(self):
        simulation = resect.Simulation(resect.Scenario("press"))
        caught = threading.Event()

        def steps():
            while not caught.is_set():
                try:
                    simulation.step(duration=0.2)
                except resect.Error:  # the other one was first
                    pass

        thread = threading.Thread(target=steps)
        thread.start()
        try:
            with self.assertRaisesRegex(resect.Error, "another thread"):
                end = time.monotonic() + 60
                while time.monotonic() < end:
                    simulation.save()
        finally:
            caught.set()
            thread.join()

    def test_segments_of_the_liver_are_a_field_of_cells(self):
        text = 'title = "Liver"\nduration = 1\n[organ]\nsource = "liver"\nspacing = "10mm"\nvessels = "built-in"\n'
        organ = resect.Simulation(resect.Scenario.parse(text, "liver")).organ()
        segments = organ.segments
        self.assertEqual((segments.shape, segments.dtype), (organ.alive.shape, np.uint8))
        inside = organ.alive == 1
        self.assertEqual(sorted(np.unique(segments[inside])), list(range(1, 9)))
        self.assertEqual(segments[~inside].max(), 0)
        # Segment II is on the patient's left, VI on the right; the liver lies as a surgeon sees it.
        x = np.arange(organ.alive.shape[2])
        middle = lambda segment: (x * (segments == segment)).sum() / (segments == segment).sum()
        self.assertGreater(middle(2), middle(6) + 5)
        self.assertEqual(soft_box().organ().segments.max(), 0)

    def test_a_step_refuses_what_is_no_number_and_cells_that_are_not_there(self):
        simulation = resect.Simulation(resect.Scenario.parse(
            'title = "Box"\nduration = 1\n[organ]\nsource = "liver"\nspacing = "20mm"\n[[tool]]\nmodel = "baton"\n', "box"))
        before = simulation.state_hash
        for column in range(10):
            rows = simulation.tool_rests()
            rows[0, column] = np.nan
            with self.assertRaisesRegex(resect.Error, f"column {column} of instrument 0 is nan"):
                simulation.step(rows)
        for cell in (-1, 10**9):
            with self.assertRaisesRegex(resect.Error, f"an edit is of cell {cell}"):
                simulation.step(edits=[resect.Edit.remove(cell)])
        with self.assertRaisesRegex(resect.Error, "an edit is for organ 3"):
            simulation.step(edits=[resect.Edit.remove(0, organ=3)])
        self.assertEqual(simulation.state_hash, before)

    def test_edits_remove_cut_and_label(self):
        simulation = soft_box()
        organ = simulation.organ()
        before = organ.particles
        edits = [resect.Edit.remove(int(organ.cells()[-1])), resect.Edit.label(5, 3),
                 resect.Edit.incise([[0.0, 0.0, -0.1], [0.0, 0.1, -0.1]], [[0.0, 0.0, 0.1], [0.0, 0.1, 0.1]])]
        report = simulation.step(edits=edits)
        self.assertEqual((report.removed, organ.particles), (1, before - 1))
        self.assertGreater(report.severed, 8 * 4)
        self.assertEqual(organ.labels.reshape(-1)[5], 3)
        self.assertEqual([e.kind for e in report.edits], ["remove", "label", "incise"])
        ledger = simulation.ledger()
        self.assertEqual(ledger["before"]["particles"], before)
        self.assertEqual(ledger["piece_count"], 1)
        self.assertAlmostEqual(ledger["cut_cm2"], 32, delta=1)  # 8 cm x 4 cm

    def test_a_carved_tunnel_is_finer_than_the_cells(self):
        simulation, whole = soft_box(), soft_box()
        organ = simulation.organ()

        def volume(organ):
            a, b, c = (organ.points()[organ.triangles()[:, corner]].astype(float) for corner in range(3))
            return np.einsum("ij,ij->", a, np.cross(b, c)) / 6

        line = ([-0.02, 0.022, 0.001], [0.02, 0.022, 0.001])
        report = simulation.step(edits=[resect.Edit.carve(*line, 0.012)])
        self.assertEqual([e.kind for e in report.edits], ["carve"])
        # A cylinder with two round ends, in cells of 1 ml.
        tunnel = np.pi * 0.012 ** 2 * (0.04 + 4 / 3 * 0.012)
        whole.step()
        self.assertAlmostEqual(volume(whole.organ()) - volume(organ), tunnel, delta=0.1 * tunnel)
        with self.assertRaisesRegex(resect.Error, "radius of .* m"):
            simulation.step(edits=[resect.Edit.carve(*line, float("nan"))])


class Arrays(unittest.TestCase):
    def test_arrays_over_cells_are_not_copies_and_follow_the_state(self):
        simulation = soft_box()
        organ = simulation.organ()
        alive, (_, uy, _) = organ.alive, organ.displacement
        again = simulation.organ().displacement[1]
        self.assertEqual(uy.__array_interface__["data"], again.__array_interface__["data"])
        state = simulation.save()
        for frame in range(20):
            simulation.step(pressing(simulation, 0.05 - 0.001 * frame),
                            edits=[resect.Edit.remove(0)] if frame == 0 else [])
        self.assertLess(uy.min(), -0.0015)
        self.assertEqual(alive[0, 0, 0], 0)
        simulation.restore(state)
        self.assertEqual((uy.min(), alive[0, 0, 0]), (0, 1))
        with self.assertRaises(ValueError):
            uy[0, 0, 0] = 1

    def test_arrays_outlive_the_simulation(self):
        simulation = soft_box()
        report = simulation.step(pressing(simulation, 0.035))
        arrays = [simulation.organ().displacement[1], simulation.organ().alive, simulation.organ().points(),
                  report.tool_force, report.contact_cells(0)]
        copies = [a.copy() for a in arrays]
        del simulation, report
        gc.collect()
        filler = [np.full(100_000, 7.0) for _ in range(20)]
        for array, copy in zip(arrays, copies):
            np.testing.assert_array_equal(array, copy)
        del filler

    def test_kept_points_stay_as_they_were(self):
        simulation = soft_box()
        first = simulation.organ().points()
        self.assertEqual(first.__array_interface__["data"], simulation.organ().points().__array_interface__["data"])
        copy = first.copy()
        for frame in range(20):
            simulation.step(pressing(simulation, 0.05 - 0.001 * frame))
        np.testing.assert_array_equal(first, copy)
        self.assertGreater(np.abs(simulation.organ().points() - copy).max(), 0.0015)

    def test_positions_are_rest_places_and_displacements(self):
        simulation = soft_box()
        for frame in range(20):
            simulation.step(pressing(simulation, 0.05 - 0.001 * frame))
        organ = simulation.organ()
        cells = organ.cells()
        k, j, i = np.unravel_index(cells, organ.shape)
        rest = organ.origin + organ.spacing * np.stack([i, j, k], axis=1)
        moved = np.stack([u[k, j, i] for u in organ.displacement], axis=1)
        np.testing.assert_allclose(organ.positions(cells), rest + moved, atol=1e-6)


class Organs(unittest.TestCase):
    def test_an_organ_from_cells_has_their_volume_and_can_be_kept(self):
        cells = np.zeros((6, 5, 7))
        cells[1:5, 1:4, 1:6] = 1
        labels = np.zeros((6, 5, 7), np.uint8)
        labels[2, 2, 3] = 4
        organ = resect.Organ.from_cells(cells, 0.005, labels=labels, label_names=["", "", "", "", "tumour"])
        self.assertEqual((organ.particles, organ.shape), (60, (6, 5, 7)))
        self.assertAlmostEqual(organ.volume_ml, 60 * 0.125, 6)
        organ.save("block.resect-cells")
        again = resect.Organ.from_file("block.resect-cells", on_table=False)
        np.testing.assert_array_equal(again.inside, cells)
        np.testing.assert_array_equal(again.labels, labels)
        self.assertEqual(again.label_name(4), "tumour")

    def test_an_organ_from_a_mesh(self):
        mesh = pathlib.Path(resect.data_folder()) / "organs" / "gallbladder.ply"
        organ = resect.Organ.from_file(str(mesh), 0.004)
        again = resect.Organ.from_file("gallbladder", 0.004)
        self.assertGreater(organ.particles, 300)
        self.assertAlmostEqual(organ.volume_ml, again.volume_ml, delta=1)


class Stubs(unittest.TestCase):
    def test_the_stubs_name_what_the_module_has(self):
        stub = ast.parse((pathlib.Path(resect.__file__).parent / "_core.pyi").read_text())

        def named(body):
            names = set()
            for node in body:
                if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
                    names.add(node.name)
                elif isinstance(node, ast.AnnAssign):
                    names.add(node.target.id)
            return {n for n in names if not n.startswith("__")}

        def public(thing):
            return {n for n in vars(thing) if not n.startswith("_")}

        self.assertEqual(named(stub.body), public(resect._core))
        for node in stub.body:
            if isinstance(node, ast.ClassDef) and node.name != "Error":
                kind = getattr(resect._core, node.name)
                self.assertEqual(named(node.body), public(kind), node.name)
        self.assertEqual(set(resect.__all__) - {"TOOL_COLUMNS", "__version__"}, public(resect._core))


class Errors(unittest.TestCase):
    def test_each_mistake_is_one_sentence(self):
        simulation = soft_box()
        state = simulation.save()
        other = resect.Simulation(resect.Scenario("press")).save()
        rows = simulation.tools()
        for wrong, words in [
                (lambda: resect.Scenario("no-such"), "no-such"),
                (lambda: resect.Scenario.parse("duration = -1\n", "mine"), "mine"),
                (lambda: simulation.step(np.zeros((1, 10))), r"\[2, 10\]"),
                (lambda: simulation.step(2 * rows), "quaternion"),
                (lambda: simulation.step(rows, duration=5), "5 s"),
                (lambda: simulation.step(rows, edits=[resect.Edit.remove(0, organ=3)]), "organ 3"),
                (lambda: simulation.restore(state[:-9]), "state"),
                (lambda: simulation.restore(other), "another organ"),
                (lambda: simulation.organ(1), "organ 1"),
                (lambda: simulation.organ().positions([10**9]), "no cell"),
                (lambda: resect.Simulation(resect.Scenario("cut-120")).organ().displacement, "stands still"),
                (lambda: resect.Organ.from_file("nowhere.stl", 0.01), "nowhere.stl"),
                (lambda: resect.Organ.from_file("liver"), "spacing"),
                (lambda: resect.Organ.from_cells(np.zeros((2, 2, 2)), 0.01), "no organ"),
                (lambda: resect.Organ.from_cells(np.full((2, 2, 2), 9), 0.01), "0 to 1"),
                (lambda: resect.Camera(simulation, 4, 4), "4 x 4"),
                (lambda: resect.Camera(simulation, view="moon"), "moon"),
                (lambda: resect.Camera(simulation, shadows=3), "64 to 4096"),
                (lambda: resect.verify("nothing.resect"), "nothing.resect"),
                (lambda: simulation.end_recording(), "record"),
        ]:
            with self.assertRaisesRegex(resect.Error, words) as caught:
                wrong()
            self.assertNotIn("\n", str(caught.exception))
        self.assertEqual(simulation.save(), state)  # and nothing changed


class Recordings(unittest.TestCase):
    def test_a_recording_is_verified_played_and_refused_when_a_bit_is_changed(self):
        simulation = soft_box()
        simulation.record("block.resect")
        with self.assertRaisesRegex(resect.Error, "one line of time"):
            simulation.restore(simulation.save())
        for frame in range(30):
            simulation.step(pressing(simulation, 0.05 - 0.001 * frame), duration=0.05)
        simulation.end_recording()
        found = resect.verify("block.resect")
        self.assertTrue(found and found.complete, found.difference)
        self.assertEqual(found.frames, 30)
        recording = resect.Recording("block.resect")
        frames = 0
        while (frame := recording.step()) is not None:
            tools, duration, report = frame
            self.assertEqual((duration, tools[0, 9]), (0.05, 1))
            frames += 1
        self.assertEqual((frames, recording.state_hash), (30, simulation.state_hash))
        samples = recording.samples()
        np.testing.assert_array_equal(samples["force"][-1], report.tool_force[0])
        data = bytearray(pathlib.Path("block.resect").read_bytes())
        data[len(data) // 2] ^= 1
        pathlib.Path("changed.resect").write_bytes(data)
        try:
            same = bool(resect.verify("changed.resect"))
        except resect.Error:
            same = False
        self.assertFalse(same)

    def test_an_attempt_at_a_task_is_scored(self):
        scenario = resect.Scenario("touch-and-hold")
        simulation = resect.Simulation(scenario)
        simulation.record("attempt.resect")
        for frame in range(0, 200):
            simulation.step(scenario.inputs(frame))
        simulation.end_recording()
        sheet = resect.score("attempt.resect", graded=False, learner="L1")
        self.assertFalse(sheet["graded"])
        self.assertEqual(sheet["learner"], "L1")
        self.assertIn("path_length_m", str(sheet["measures"]))
        with self.assertRaisesRegex(resect.Error, "easy, medium or hard"):
            resect.score("attempt.resect", level="nightmare")


class Pictures(unittest.TestCase):
    def setUp(self):
        self.simulation = soft_box(labels="""
            [[organ.label]]
            label = 2
            name = "spot"
            frame = "organ"
            box = [[0.6, 0, 0], [1, 1, 1]]""")
        self.simulation.step(pressing(self.simulation, 0.045))
        try:
            self.camera = resect.Camera(self.simulation, 192, 128)
            self.camera.renderer
        except resect.Error as e:
            self.skipTest(str(e))

    def test_depth_and_labels_show_what_stands_there(self):
        depth, labels = self.camera.depth_and_labels()
        self.assertEqual((depth.shape, labels.shape), ((128, 192), (128, 192)))
        self.assertEqual(set(np.unique(labels).tolist()) | {0}, {0, 1, 16, 256, 258})
        # Back from pixel and depth to the world: the organ's pixels lie on the block.
        view = self.camera.intrinsics
        v, u = np.nonzero(labels >= 256)
        z = depth[v, u]
        seen = np.stack([(u + 0.5 - view["centre"][0]) * z / view["focal"],
                         -(v + 0.5 - view["centre"][1]) * z / view["focal"], -z], axis=1)
        x, y, zz, w = view["rotation"]
        axis = np.array([x, y, zz])
        world = seen + 2 * np.cross(axis, np.cross(axis, seen) + w * seen) + view["position"]
        self.assertLess(np.abs(world[:, 0]).max(), 0.052)
        self.assertLess(np.abs(world[:, 2]).max(), 0.042)
        self.assertTrue((world[:, 1] > -0.001).all() and (world[:, 1] < 0.043).all())
        right = world[labels[v, u] == 258]
        self.assertGreater(right[:, 0].min(), 0.0)

    def test_another_thread_and_a_forked_process_are_told_that_they_cannot_draw(self):
        said = []

        def draw():
            try:
                resect.Camera(self.simulation)
            except resect.Error as e:
                said.append(str(e))

        thread = threading.Thread(target=draw)
        thread.start()
        thread.join()
        self.assertIn("one thread", said[0])
        here, there = os.pipe()
        child = os.fork()
        if not child:
            draw()
            os.write(there, said[-1].encode())
            os._exit(0)
        os.waitpid(child, 0)
        self.assertIn(b"forked", os.read(here, 1000))

    def test_colours_and_labels_come_from_one_camera(self):
        rgb = self.camera.rgb().astype(int)
        _, labels = self.camera.depth_and_labels()
        organ = labels >= 256
        # Tissue is red, the table green.
        self.assertGreater(np.median((rgb[..., 0] - rgb[..., 1])[organ]), 10)
        self.assertLess(np.median((rgb[..., 0] - rgb[..., 1])[labels == 1]), 0)
        resect.write_png("block.png", self.camera.rgb())
        self.assertEqual(pathlib.Path("block.png").read_bytes()[1:4], b"PNG")


if __name__ == "__main__":
    unittest.main()
