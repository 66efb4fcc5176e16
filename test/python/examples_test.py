"""The scripts of python/examples, as a person runs them, and data sets."""
import importlib.util
import json
import os
import pathlib
import re
import subprocess
import sys
import unittest

import numpy as np
import resect
from resect import dataset

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "python" / "examples"


def needs(*modules):
    missing = [m for m in modules if importlib.util.find_spec(m) is None]
    return unittest.skipIf(missing, f"{', '.join(missing)} missing (tools/packages_python.txt)")


def draws():
    try:
        resect.Camera(resect.Simulation(resect.Scenario("cut-120")), 16, 16).renderer
        return True
    except resect.Error:
        return False


class Examples(unittest.TestCase):
    def run_example(self, name, *arguments):
        done = subprocess.run([sys.executable, EXAMPLES / name, *arguments], capture_output=True, text=True, timeout=300)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout

    def test_all_are_run_here_and_fit_a_page(self):
        names = {p.name for p in EXAMPLES.glob("*.py")}
        here = pathlib.Path(__file__).read_text()
        self.assertEqual(names, set(re.findall(r"run_example\(\"(.*?)\"", here)))
        for path in EXAMPLES.glob("*.py"):
            self.assertLessEqual(len(path.read_text().splitlines()), 90, path)

    @needs("matplotlib")
    def test_01_a_force_is_plotted(self):
        self.run_example("01_step_and_plot_a_force.py", "force.svg")
        self.assertIn("<svg", pathlib.Path("force.svg").read_text())

    def test_02_a_policy_learns_to_reach(self):
        told = self.run_example("02_learn_to_reach.py")
        before, after = re.search(r"before training: (\d+)%", told), re.search(r"(\d+)% of 20 goals that", told)
        self.assertLess(int(before[1]), 50)
        self.assertGreaterEqual(int(after[1]), 90)

    @needs("distributed")
    def test_03_a_sweep_runs_on_two_workers(self):
        self.assertIn("verified 2 of 8 operations", self.run_example("03_stiffness_sweep.py", "stiffness"))

    def test_04_a_recording_is_verified(self):
        told = self.run_example("04_verify_a_recording.py")
        self.assertIn("the same bits", told)
        self.assertIn("one bit changed", told)

    @needs("h5py")
    @unittest.skipUnless(draws(), "nothing can be drawn here")
    def test_05_a_data_set_of_cuts_is_made(self):
        # 100 of them with RESECT_ALL_CUTS=1: two minutes.
        number = 100 if os.environ.get("RESECT_ALL_CUTS") else 3
        self.assertIn(f"{number} cuts, {number} along", self.run_example("05_data_set_of_cuts.py", "cuts", str(number)))


@needs("h5py")
class DataSets(unittest.TestCase):
    def test_what_is_not_there_is_not_replayed(self):
        with self.assertRaisesRegex(resect.Error, "is not there; give a folder"):
            dataset.replay("nowhere", 0)

    def test_the_layout_is_that_of_robomimic_and_the_actions_prove_the_end(self):
        import h5py
        reached = dataset.write_demos("reach", "Reach", 3, seed=5, options={"particles": 300})
        self.assertEqual(reached, 3)
        with h5py.File("reach/demos.hdf5") as file:
            args = json.loads(file["data"].attrs["env_args"])
            self.assertEqual((args["env_name"], args["type"]), ("Reach", 2))
            self.assertEqual(list(file["mask/train"]), [b"demo_0", b"demo_1", b"demo_2"])
            total = 0
            for demo in file["data"].values():
                n = int(demo.attrs["num_samples"])
                total += n
                for name in ("actions", "rewards", "dones", "states", "obs/state", "next_obs/state", "obs/forces"):
                    self.assertEqual(len(demo[name]), n)
                np.testing.assert_array_equal(demo["obs/state"][1:], demo["next_obs/state"][:-1])
                self.assertEqual(demo["dones"][:].tolist(), [0] * (n - 1) + [1])
            self.assertEqual(file["data"].attrs["total"], total)
        self.assertTrue(dataset.replay("reach", 1))
        with h5py.File("reach/demos.hdf5", "r+") as file:
            file["data/demo_1/actions"][0, 0] = 0.123
        self.assertFalse(dataset.replay("reach", 1))
        card = pathlib.Path("reach/README.md").read_text()
        self.assertIn("3 of 3 demonstrations reach the goal", card)

    @unittest.skipUnless(draws(), "nothing can be drawn here")
    def test_recordings_are_exported_with_pictures(self):
        import h5py
        scenario = resect.Scenario("snip")
        simulation = resect.Simulation(scenario)
        simulation.record("snip.resect")
        for frame in range(90):
            simulation.step(scenario.inputs(frame))
        simulation.end_recording()
        dataset.export_recordings("runs", ["snip.resect", "snip.resect"], rate=10, picture=(32, 24))
        with h5py.File("runs/demos.hdf5") as file:
            demo = file["data/demo_1"]
            self.assertEqual(file["data"].attrs["total"], 2 * len(demo["actions"]))
            self.assertEqual(len(demo["actions"]), round(10 * simulation.time))
            self.assertEqual(demo.attrs["end_state_hash"], f"{simulation.state_hash:016x}")
            self.assertEqual(demo["obs/rgb"].shape[1:], (24, 32, 3))
            np.testing.assert_allclose(demo["next_obs/poses"][-1], simulation.tools(), atol=1e-6)
            np.testing.assert_array_equal(demo["actions"][0], demo["next_obs/poses"][0].ravel())
        self.assertIn("snip.resect", pathlib.Path("runs/README.md").read_text())

    def test_the_command_makes_a_folder(self):
        command = [sys.executable, "-m", "resect.dataset", "made", "--env", "Retract", "--demos", "1", "--particles", "300"]
        done = subprocess.run([*command, "--pictures"], capture_output=True, text=True, timeout=100)
        self.assertEqual(done.returncode, 0, done.stderr)
        made = {str(p.relative_to("made")) for p in pathlib.Path("made").rglob("*") if p.is_file()}
        self.assertEqual(made, {"README.md", "demos.hdf5", "pictures/demo_0/poses.csv", "pictures/demo_0/forces.csv"})
        done = subprocess.run(command, capture_output=True, text=True, timeout=100)
        self.assertEqual((done.returncode, done.stderr),
                         (1, "resect: error: made: is there and not empty; name another folder\n"))

    def test_mistakes_are_one_sentence(self):
        pathlib.Path("full").mkdir()
        pathlib.Path("full/x").touch()
        for wrong, words in ((("full", "Reach", 1), "not empty"), (("a", "Fly", 1), "Fly"), (("b", "Reach", 0), "0 ")):
            with self.assertRaisesRegex(resect.Error, words):
                dataset.write_demos(*wrong)


if __name__ == "__main__":
    unittest.main()
