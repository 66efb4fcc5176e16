"""recording_test.py RESECT FOLDER: recordings from the command line: written, proved, replayed, and what interrupts them.

RESECT_KILLS says how many runs are killed (6); docs/recording.md has the command for 200.
"""
import json
import os
import pathlib
import random
import re
import shutil
import signal
import sqlite3
import subprocess
import sys
import time
import unittest

PROGRAM, FOLDER = None, None


def resect(*arguments, **options):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=300, **options)


class Recordings(unittest.TestCase):
    def setUp(self):
        self.folder = FOLDER / self.id().split(".")[-1]
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)

    def recorded(self, scenario, *arguments):
        file = self.folder / f"{scenario}.resect"
        run = resect("run", scenario, "--record", file, "--json", "-", *arguments)
        self.assertEqual(run.returncode, 0, run.stderr)
        return file, json.loads(run.stdout)

    def test_a_run_is_recorded_proved_and_replayed(self):
        for scenario, arguments in (("press", ["--spacing", "9mm"]), ("cut-120", [])):
            file, summary = self.recorded(scenario, *arguments)
            for threads in (1, 2, 3):
                proof = resect("verify", file, "--threads", threads)
                self.assertEqual((proof.returncode, proof.stderr), (0, ""))
                self.assertTrue(proof.stdout.startswith(f"verified {summary['frames']} frames"), proof.stdout)
            replay = resect("replay", file, "--json", "-")
            self.assertEqual(replay.returncode, 0, replay.stderr)
            played = json.loads(replay.stdout)
            self.assertEqual(played["state_hash"], summary["state_hash"])
            self.assertIn("touch", [event["kind"] for event in played["events"]])
            # A tool has one name everywhere.
            names = {tool["tool"] for tool in summary.get("tool_forces_n", [])} or {"Scalpel", "Hook", "Baton"}
            self.assertLessEqual({event["tool"] for event in played["events"] if "tool" in event}, names)
            self.assertLessEqual({tool["tool"] for tool in played["tool_forces_n"]}, names)
            for time_s in [summary["simulated_s"], played["time_s"], *(event["time_s"] for event in played["events"])]:
                self.assertLessEqual(len(str(time_s)), len("12.123456789"))

    def test_the_first_picture_of_a_part_shows_the_instruments_at_work(self):
        file, _ = self.recorded("lift", "--spacing", "12mm")
        pictures = []
        for begin in ("3.9", "4"):
            shown = self.folder / begin
            replay = resect("replay", file, "--from", begin, "--to", "4", "--frames", shown, "--picture-rate", "10",
                            "--size", "320x200")
            self.assertEqual(replay.returncode, 0, replay.stderr)
            pictures.append(sorted(shown.iterdir())[-1].read_bytes())
        self.assertEqual(*pictures)

    def test_a_wound_that_the_organ_has_at_the_start_is_in_the_recording(self):
        text = (pathlib.Path(__file__).resolve().parents[2] / "data/tasks/control-bleeding.toml").read_text()
        scenario, file = self.folder / "wound.toml", self.folder / "wound.resect"
        scenario.write_text(re.sub(r"\nduration = [\d.]+", "\nduration = 0.5", text))
        run = resect("run", scenario, "--record", file, "--json", "-")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertGreater(json.loads(run.stdout)["blood"]["bled_ml"], 0.3)
        proof = resect("verify", file)
        self.assertEqual((proof.returncode, proof.stderr), (0, ""))

    def test_a_piece_that_comes_off_is_an_event(self):
        file, summary = self.recorded("resect-segment-elastic")
        replay = resect("replay", file, "--json", "-")
        events = [event for event in json.loads(replay.stdout)["events"] if event["kind"] == "piece"]
        self.assertGreater(len(events), 0)
        self.assertEqual(sum(event["amount"] for event in events), len(summary["ledger"][0]["parts"]) - 1)
        self.assertEqual(resect("verify", file).returncode, 0)

    def test_any_sqlite_tool_reads_it(self):
        file, summary = self.recorded("press", "--spacing", "12mm")
        db = sqlite3.connect(file)
        self.assertEqual(db.execute("PRAGMA application_id").fetchone()[0], 0x52534354)
        self.assertEqual(db.execute("SELECT count(*) FROM frames").fetchone()[0], summary["frames"])
        self.assertEqual(db.execute("SELECT value FROM meta WHERE key = 'complete'").fetchone()[0], "yes")
        force = db.execute("SELECT max(force_x * force_x + force_y * force_y + force_z * force_z) FROM samples").fetchone()
        self.assertAlmostEqual(force[0] ** 0.5, max(tool["peak"] for tool in summary["tool_forces_n"]), places=3)
        db.close()
        self.assertFalse(list(self.folder.glob("*-wal")) + list(self.folder.glob("*-shm")))

    def test_what_is_recorded_survives_a_kill_at_any_moment(self):
        kills = int(os.environ.get("RESECT_KILLS", 6))
        frames = 0
        for i in range(kills):
            file = self.folder / f"{i}.resect"
            run = subprocess.Popen([PROGRAM, "run", "press", "--record", file], stdout=subprocess.DEVNULL)
            while not file.exists() and run.poll() is None:
                time.sleep(0.002)
            time.sleep(random.uniform(0, 0.1 if i % 3 == 0 else 1.5))
            run.send_signal(signal.SIGKILL)
            ended = run.wait() == 0  # before the kill came
            proof = resect("verify", file)
            self.assertEqual((proof.returncode, proof.stderr), (0, ""))
            frames += int(proof.stdout.split()[1])
            if ended:
                self.assertNotIn("the program ended before", proof.stdout)
            for made in self.folder.glob(f"{i}.resect*"):
                made.unlink()
        print(f"{kills} kills: all recordings proved, with {frames} frames")
        self.assertGreater(frames, 0)

    def test_a_changed_recording_is_told(self):
        file, _ = self.recorded("press", "--spacing", "12mm")
        db = sqlite3.connect(file)
        blob = bytearray(db.execute("SELECT input FROM frames WHERE frame = 50").fetchone()[0])
        blob[0] ^= 1
        db.execute("UPDATE frames SET input = ? WHERE frame = 50", (bytes(blob),))
        db.commit()
        db.close()
        proof = resect("verify", file)
        self.assertEqual(proof.returncode, 1)
        self.assertIn("frame 50 of branch 0 differs", proof.stderr)

    def test_a_full_disk_and_a_read_only_place_are_sentences(self):
        if os.geteuid() != 0:
            self.skipTest("mounting a small disk takes root")
        place = self.folder / "disk"
        place.mkdir()
        for size, begun in ("400k", False), ("1000k", True):  # is there room for the organ and some frames?
            if subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={size}", "tmpfs", place], capture_output=True).returncode:
                self.skipTest("no small disk can be mounted")
            try:
                run = resect("run", "press", "--spacing", "9mm", "--record", place / "a.resect",
                             "--json", self.folder / f"{size}.json")
                self.assertEqual(run.returncode, 1)
                self.assertIn("disk", run.stderr)
                self.assertEqual(run.stderr.count("\n"), 1)
                # What was begun is done and summed up.
                self.assertEqual((self.folder / f"{size}.json").exists(), begun)
                self.assertEqual([p.name for p in place.iterdir() if "tmp" in p.name or "begun" in p.name], [])
                proof = resect("verify", place / "a.resect")
                self.assertEqual(proof.returncode, 0 if begun else 1, proof.stderr)
                if begun:
                    self.assertIn("the program ended before", proof.stdout)
                    self.assertGreater(int(proof.stdout.split()[1]), 0)
            finally:
                subprocess.run(["umount", place])

    def test_a_part_that_is_not_there_is_a_sentence(self):
        file, summary = self.recorded("press", "--spacing", "15mm")
        for arguments in (["--from", "9"], ["--branch", "1"], ["--branch", "-3"], ["--from", "2", "--to", "1"]):
            for command in (["replay", file], ["export", file, "-o", self.folder / "a.csv"]):
                run = resect(*command, *arguments)
                self.assertIn(run.returncode, (1, 2), run.stdout)
                self.assertEqual(run.stderr.count("\n"), 1, run.stderr)
        self.assertFalse((self.folder / "a.csv").exists())
        log = pathlib.Path(str(file) + "-wal")
        log.touch()
        over = resect("replay", file, "--json", log)
        self.assertEqual(over.returncode, 2, over.stdout + over.stderr)
        again = resect("run", "press", "--record", file, "--json", self.folder / "b.json")
        self.assertEqual(again.returncode, 1)
        self.assertIn("is there already", again.stderr)
        self.assertFalse((self.folder / "b.json").exists())

    def test_what_is_no_recording_is_a_sentence(self):
        text = self.folder / "text.resect"
        text.write_text("words " * 100)
        for file in (text, self.folder, self.folder / "none.resect", "/dev/null"):
            for command in ("verify", "replay"):
                run = resect(command, file)
                self.assertEqual(run.returncode, 1)
                self.assertEqual(run.stderr.count("\n"), 1, run.stderr)


if __name__ == "__main__":
    PROGRAM, FOLDER = pathlib.Path(sys.argv.pop(1)).resolve(), pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
