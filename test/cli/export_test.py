"""export_test.py RESECT FOLDER: recordings exported from the command line: what is written, refused and spared."""
import csv
import json
import os
import pathlib
import shutil
import signal
import struct
import subprocess
import sys
import time
import unittest
import xml.etree.ElementTree

PROGRAM, FOLDER = None, None
LIMIT = 300 * float(os.environ.get("RESECT_PATIENCE", 1))


def resect(*arguments, **options):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=LIMIT, **options)


class Export(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(FOLDER, ignore_errors=True)
        FOLDER.mkdir(parents=True)
        cls.recording = FOLDER / "press.resect"
        run = resect("run", "press", "--spacing", "12mm", "--record", cls.recording)
        assert run.returncode == 0, run.stderr

    def setUp(self):
        self.folder = FOLDER / self.id().split(".")[-1]
        self.folder.mkdir()

    def export(self, out, *arguments, **options):
        return resect("export", self.recording, "-o", out, *arguments, **options)

    def done(self, run):
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        self.assertEqual(run.stdout.count("\n"), 1, run.stdout)

    def refused(self, run, status, *words):
        self.assertEqual(run.returncode, status, run.stderr)
        self.assertTrue(run.stderr.startswith("resect: error: "), run.stderr)
        self.assertEqual(run.stderr.count("\n"), 1, run.stderr)
        for word in words:
            self.assertIn(word, run.stderr)

    def names(self):
        return sorted(file.name for file in self.folder.iterdir())

    def test_a_glb_is_read_by_the_reader_of_strangers_models(self):
        out = self.folder / "run.glb"
        self.done(self.export(out, "--rate", "2"))
        info = resect("info", out)
        self.assertEqual(info.returncode, 0, info.stderr)
        self.assertIn("glTF binary", info.stdout)
        self.assertIn("organ 0001", info.stdout)

    def test_jaws_of_an_exported_instrument_turn(self):
        recording, out = self.folder / "snip.resect", self.folder / "snip.glb"
        self.assertEqual(resect("run", "snip", "--spacing", "12mm", "--record", recording).returncode, 0)
        self.done(resect("export", recording, "-o", out))
        data = out.read_bytes()
        length = struct.unpack("<I", data[12:16])[0]
        scene, data = json.loads(data[20:20 + length]), data[28 + length:]

        def rotations(sampler):
            accessor = scene["accessors"][scene["animations"][0]["samplers"][sampler]["output"]]
            start = scene["bufferViews"][accessor["bufferView"]]["byteOffset"]
            return {data[start + 16 * i:start + 16 * i + 16] for i in range(accessor["count"])}

        scissors = next(node for node in scene["nodes"] if node["name"] == "Scissors")
        turning = [channel["target"]["node"] for channel in scene["animations"][0]["channels"]
                   if channel["target"]["path"] == "rotation" and channel["target"]["node"] in scissors["children"]
                   and len(rotations(channel["sampler"])) > 5]
        self.assertEqual(len(turning), 2)

    def test_the_same_recording_gives_the_same_file_at_any_number_of_threads(self):
        for threads in ("1", "2"):
            self.done(self.export(self.folder / f"{threads}.glb", "--rate", "3", "--threads", threads))
        self.assertEqual((self.folder / "1.glb").read_bytes(), (self.folder / "2.glb").read_bytes())

    def test_a_series_has_a_list_with_times(self):
        out = self.folder / "deep" / "a.vtp"
        self.done(self.export(out, "--rate", "2", "--from", "1", "--to", "3"))
        entries = xml.etree.ElementTree.parse(out.with_suffix(".pvd")).getroot().findall("Collection/DataSet")
        self.assertEqual([round(float(e.get("timestep")), 6) for e in entries], [1, 1.5, 2, 2.5, 3])
        self.assertEqual([e.get("file") for e in entries], [f"a_000{i}.vtp" for i in range(1, 6)])
        self.assertEqual(sorted(p.name for p in out.parent.iterdir()), ["a.pvd"] + [e.get("file") for e in entries])

    def test_files_of_an_earlier_run_stay_unless_told(self):
        out, other = self.folder / "a.vtp", self.folder / "a_x.vtp"
        other.write_text("mine")
        self.done(self.export(out, "--rate", "2"))
        many = len(self.names())
        self.refused(self.export(out, "--rate", "1"), 1, "a_0001.vtp", "--overwrite")
        self.assertEqual(len(self.names()), many)
        self.done(self.export(out, "--rate", "1", "--overwrite"))
        self.assertLess(len(self.names()), many)
        self.assertEqual(other.read_text(), "mine")

    def test_tables_are_read_with_their_columns(self):
        def rows(*arguments):
            out = self.folder / "a.csv"
            self.done(self.export(out, *arguments, env={**os.environ, "LC_ALL": "de_DE.UTF-8"}))
            with out.open(newline="") as file:
                return list(csv.DictReader(file))

        samples = rows()
        self.assertEqual({row["tool"] for row in samples}, {"Baton"})
        self.assertGreater(max(abs(float(row["force_y_N"])) for row in samples), 0.01)
        few = rows("--rate", "5")
        self.assertTrue(0 < len(few) < len(samples) / 5)
        self.assertIn("touch", [row["event"] for row in rows("--table", "events")])
        before = [row for row in rows("--table", "ledger") if row["part"] == "before"]
        self.assertEqual({row["organ"] for row in before}, {"organ"})
        self.assertGreater(len({row["time_s"] for row in before}), 7)
        self.assertEqual(len({row["ml"] for row in before}), 1)
        self.assertLessEqual({row["measure"] for row in rows("--table", "wounds")}, {"cut_cm2", "bared_cm2"})
        self.assertEqual([row["frame"] for row in rows("--table", "frames", "--from", "1", "--to", "1.1")],
                         ["61", "62", "63", "64", "65", "66"])

    def test_wrong_arguments_are_sentences(self):
        glb, table = self.folder / "a.glb", self.folder / "a.csv"
        self.refused(self.export(self.folder / "a.fbx"), 2, ".glb", ".vtp", ".csv")
        self.refused(self.export(self.folder / "none"), 2, ".glb")
        self.refused(self.export(glb, "--table", "samples"), 2, "--table")
        self.refused(self.export(table, "--table", "scores"), 2, "scores", "samples, events, frames, ledger")
        self.refused(self.export(table, "--table", "events", "--rate", "3"), 2, "--rate")
        self.refused(self.export(glb, "--rate", "0"), 2, "--rate")
        self.refused(self.export(glb, "--rate", "nan"), 2, "--rate")
        self.refused(self.export(glb, "--from", "3", "--to", "2"), 2, "--from")
        self.refused(self.export(glb, "--branch", "7"), 1, "branch 7")
        self.refused(resect("export", self.recording), 2, "--output")
        self.refused(resect("export", self.folder / "none.resect", "-o", glb), 1, "none.resect")
        text = self.folder / "text.resect"
        text.write_text("words " * 100)
        self.refused(resect("export", text, "-o", glb), 1, "text.resect")
        self.assertEqual(self.names(), ["text.resect"])

    def test_the_recording_is_never_written(self):
        before = self.recording.read_bytes()
        for name in ("a.glb", "a.csv", "a_0001.vtp", "b.pvd"):
            os.link(self.recording, self.folder / name)
        self.refused(self.export(self.folder / "a.glb"), 2, "is read")
        self.refused(self.export(self.folder / "a.csv"), 2, "is read")
        self.refused(self.export(self.folder / "a.vtp", "--overwrite"), 2, "is read")
        self.refused(self.export(self.folder / "b.vtp"), 2, "is read")
        self.assertEqual(self.recording.read_bytes(), before)

    def test_a_full_disk_leaves_what_was_there(self):
        place = self.folder / "disk"
        place.mkdir()
        if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=100k", "tmpfs", place], capture_output=True).returncode:
            self.skipTest("no small disk can be mounted")
        self.addCleanup(subprocess.run, ["umount", "-l", place])
        old = place / "a.glb"
        old.write_text("old")
        self.refused(self.export(old), 1, "a.glb", "No space left")
        self.assertEqual(([file.name for file in place.iterdir()], old.read_text()), (["a.glb"], "old"))
        self.refused(self.export(place / "b.vtp"), 1, "No space left")
        self.assertFalse([file.name for file in place.iterdir() if file.name.endswith((".tmp", ".pvd"))])

    def test_an_interrupted_export_leaves_nothing(self):
        running = subprocess.Popen([PROGRAM, "export", self.recording, "-o", self.folder / "a.glb", "--rate", "60"],
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(running.kill)
        end = time.monotonic() + LIMIT
        while not any(name.endswith(".tmp") for name in self.names()):
            self.assertLess(time.monotonic(), end)
            self.assertIsNone(running.poll())
            time.sleep(0.001)
        running.send_signal(signal.SIGINT)
        self.assertEqual(running.wait(LIMIT), -signal.SIGINT)
        self.assertEqual(self.names(), [])


if __name__ == "__main__":
    PROGRAM, FOLDER = pathlib.Path(sys.argv.pop(1)).resolve(), pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
