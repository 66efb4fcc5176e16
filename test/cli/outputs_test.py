#!/usr/bin/env python3
"""Where outputs go, and what they spare: devices, pipes, links, what is read, what was there; full disks; signals.

    outputs_test.py PROGRAM FOLDER
"""
import json
import os
import resource
import shutil
import signal
import stat
import subprocess
import sys
import threading
import time
import unittest
from pathlib import Path

PROGRAM, FOLDER = sys.argv[1], Path(sys.argv[2]).resolve()
LIMIT = 300 * float(os.environ.get("RESECT_PATIENCE", 1))  # s for one run; a sanitized program is slower
DATA = Path(__file__).resolve().parent.parent.parent / "data"
FFMPEG = shutil.which("ffmpeg")


def resect(*args, **options):
    options = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True, "timeout": LIMIT, **options}
    return subprocess.run([PROGRAM, *map(str, args)], **options)


def small(output, **options):
    """A few particles into a file."""
    return resect("discretize", "liver", "--dims", "12", "-o", output, **options)


class Case(unittest.TestCase):
    def setUp(self):
        self.folder = FOLDER / self._testMethodName[5:40]
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)

    def file(self, name, text="old"):
        file = self.folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
        return file

    def names(self):
        return sorted(str(file.relative_to(self.folder)) for file in self.folder.rglob("*") if not file.is_dir())

    def refused(self, done, status, *words):
        self.assertEqual(done.returncode, status, done.stderr)
        self.assertTrue(done.stderr.startswith("resect: error: "), done.stderr)
        self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)

    def program(self, name, script):
        """An environment in which the program `name` is this script."""
        file = self.file(f"bin/{name}", f"#!/bin/sh\n{script}\n")
        file.chmod(0o755)
        return {**os.environ, "PATH": f"{file.parent}:{os.environ['PATH']}"}


class Streams(Case):
    def test_standard_output_has_a_name_and_is_not_mixed(self):
        for name in ("-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"):
            done = resect("run", "cut-120", "--json", name)
            self.assertEqual(json.loads(done.stdout)["scenario"], "cut-120", name)
        there = self.folder / "there"
        for place in (subprocess.PIPE, os.open(there, os.O_WRONLY | os.O_CREAT)):
            done = small("/dev/stdout", stdout=place)
            text = done.stdout or there.read_text()
            self.assertEqual(text.splitlines()[0], "Discretization:")
            self.assertNotIn("spacing", text)
            self.assertIn("spacing", done.stderr)
        mesh = resect("liver", "--edge", "5mm", "-o", "/dev/stdout").stdout.splitlines()
        self.assertEqual({line[0] for line in mesh}, {"#", "v", "f"})
        self.refused(resect("liver", "-o", "/dev/stdout", "--json"), 2, "--output", "standard output")

    def test_devices_and_pipes_stay_what_they_are(self):
        device, pipe = self.folder / "null", self.folder / "pipe"
        try:
            os.mknod(device, stat.S_IFCHR | 0o666, os.makedev(1, 3))
            device.open("w").close()
        except OSError as refused:
            self.skipTest(f"no device of our own: {refused}")
        for args in (["discretize", "liver", "--dims", "12", "-o", device], ["liver", "--edge", "5mm", "-o", device],
                     ["run", "cut-120", "--json", device, "--surface", device]):
            done = resect(*args)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertTrue(stat.S_ISCHR(device.stat().st_mode))
        full = self.folder / "full"
        os.mknod(full, stat.S_IFCHR | 0o666, os.makedev(1, 7))
        self.refused(small(full), 1, "No space left")
        self.assertTrue(stat.S_ISCHR(full.stat().st_mode))
        disk = self.folder / "disk"
        os.mknod(disk, stat.S_IFBLK | 0o666, os.makedev(240, 77))  # for experiments: no driver, nothing to lose
        self.refused(small(disk), 1, "it is a disk")
        self.assertTrue(stat.S_ISBLK(disk.stat().st_mode))

    def test_a_named_pipe_gives_its_reader_what_a_file_would_hold(self):
        pipe, file = self.folder / "pipe", self.folder / "file"
        os.mkfifo(pipe)
        got = []
        reader = threading.Thread(target=lambda: got.append(pipe.read_bytes()), daemon=True)
        reader.start()
        self.assertEqual(small(pipe).returncode, 0)
        self.assertEqual(small(file).returncode, 0)
        reader.join(LIMIT)
        self.assertEqual(got, [file.read_bytes()])
        self.assertTrue(stat.S_ISFIFO(pipe.stat().st_mode))

    def test_a_link_stays_and_its_file_is_replaced_with_its_permissions(self):
        real, link, chain = self.file("deep/real"), self.folder / "link", self.folder / "chain"
        real.chmod(0o640)
        link.symlink_to("deep/real")
        chain.symlink_to(link)
        self.assertEqual(small(chain).returncode, 0)
        self.assertTrue(chain.is_symlink() and link.is_symlink() and not real.is_symlink())
        self.assertTrue(real.read_text().startswith("Discretization:"))
        self.assertEqual(stat.S_IMODE(real.stat().st_mode), 0o640)
        self.assertEqual(self.names(), ["chain", "deep/real", "link"])
        nowhere, circle = self.folder / "nowhere", self.folder / "circle"
        nowhere.symlink_to("gone")
        circle.symlink_to("circle")
        self.refused(small(nowhere), 1, "gone", "does not exist")
        self.refused(small(circle), 1, "circle")
        self.assertTrue(nowhere.is_symlink() and not (self.folder / "gone").exists())

    def test_a_link_planted_under_a_temporary_name_is_not_followed(self):
        victim = self.file("victim")
        # What the process will be called is known to whoever starts it.
        plant = lambda: os.symlink(victim, self.folder / f"out.{os.getpid()}.tmp")
        self.assertEqual(small(self.folder / "out", preexec_fn=plant).returncode, 0)
        self.assertEqual(victim.read_text(), "old")

    def test_a_closed_standard_output_does_not_get_into_a_file(self):
        whole, file = self.folder / "whole", self.folder / "file"
        self.assertEqual(small(whole).returncode, 0)
        self.refused(small(file, stdout=None, preexec_fn=lambda: os.close(1)), 1, "standard output")
        self.assertEqual(file.read_bytes(), whole.read_bytes())


class Full(Case):
    def test_printing_on_a_full_disk_fails(self):
        cells = self.folder / "cells.dis"
        self.assertEqual(small(cells).returncode, 0)
        for args in (["info", cells], ["info", cells, "--json"], ["run", "--list"], ["--help"], ["run", "--help"],
                     ["--version"], ["liver", "--edge", "5mm", "-o", self.folder / "a.obj"],
                     ["surface", cells, "-o", self.folder / "b.obj", "--json"],
                     ["convert", self.folder / "a.obj", self.folder / "c.obj"],
                     ["run", "cut-120"], ["run", "cut-120", "--json", "-"], ["run", "cut-120", "--json", "/dev/stdout"],
                     ["bench", "cut-120", "--once"]):
            with open("/dev/full", "w") as full:
                self.refused(resect(*args, stdout=full), 1, "cannot write")

    def test_a_full_disk_leaves_what_was_there(self):
        disk = self.folder / "disk"
        disk.mkdir()
        if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=8k", "tmpfs", disk], capture_output=True).returncode != 0:
            self.skipTest("no disk of our own can be mounted here")
        self.addCleanup(subprocess.run, ["umount", "-l", disk])
        for name, args in (("out.dis", ["discretize", "liver", "--spacing", "6mm", "-o"]),
                           ("out.obj", ["liver", "-o"]), ("out.json", ["run", "press", "--spacing", "12mm", "--json"])):
            old = disk / name
            old.write_text("old")
            self.refused(resect(*args, old), 1, name, "No space left")
            self.assertEqual((old.read_text(), [file.name for file in disk.iterdir()]), ("old", [name]))
            old.unlink()
        if FFMPEG:
            (disk / "film.mp4").write_text("old")
            done = resect("run", "cut-120", "--video", disk / "film.mp4")
            self.refused(done, 1, "film.mp4", "disk full")
            self.assertEqual([(file.name, file.read_text()) for file in disk.iterdir()], [("film.mp4", "old")])

    def test_a_limit_on_the_size_of_files_ends_the_program_and_leaves_nothing(self):
        old = self.file("out")

        def limit(ignored):
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
            resource.setrlimit(resource.RLIMIT_FSIZE, (5000, 5000))
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN if ignored else signal.SIG_DFL)

        self.assertEqual(small(old, preexec_fn=lambda: limit(False)).returncode, -signal.SIGXFSZ)
        self.assertEqual((self.names(), old.read_text()), (["out"], "old"))
        self.refused(small(old, preexec_fn=lambda: limit(True), restore_signals=False), 1, "File too large")
        self.assertEqual((self.names(), old.read_text()), (["out"], "old"))


class Video(Case):
    def film(self, environment, name="film.mp4"):
        return resect("run", "cut-120", "--video", self.folder / name, "--size", "64x48", "--picture-rate", "1", env=environment)

    def test_a_video_is_there_when_it_is_whole(self):
        self.file("film.mp4")
        for script, words in (("cat >/dev/null; exit 0", "no reason"), ("cat >/dev/null; echo Out of luck >&2; exit 1", "Out of luck"),
                              ("echo Gone >&2; exit 0", "Gone"),
                              ("for last; do :; done; cat | head -c 999 >${last#file:}", "film.mp4")):
            self.refused(self.film(self.program("ffmpeg", script)), 1, words, "film.mp4")
            self.assertEqual((self.folder / "film.mp4").read_text(), "old")
            self.assertEqual(self.names(), ["bin/ffmpeg", "film.mp4"])
        if FFMPEG:
            (self.folder / "link.mp4").symlink_to("film.mp4")
            done = self.film(dict(os.environ), "link.mp4")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn(b"moov", (self.folder / "film.mp4").read_bytes())
            self.assertEqual(self.names(), ["bin/ffmpeg", "film.mp4", "link.mp4"])

    def begun(self, environment, ignored=None):
        """A run that has a temporary file."""
        def prepare():
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
            if ignored:
                signal.signal(ignored, signal.SIG_IGN)

        running = subprocess.Popen([PROGRAM, "run", "cut-120", "--video", self.folder / "film.mp4", "--size", "64x48"],
                                   env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, preexec_fn=prepare)
        self.addCleanup(running.kill)
        end = time.monotonic() + LIMIT
        while not any(name.endswith(".tmp") for name in self.names()):
            self.assertLess(time.monotonic(), end)
            self.assertIsNone(running.poll())
            time.sleep(0.01)
        return running

    def test_every_signal_ends_the_program_as_ever_and_leaves_nothing(self):
        slow = self.program("ffmpeg", "sleep 60")
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT, signal.SIGPIPE, signal.SIGALRM,
                       signal.SIGUSR1, signal.SIGXFSZ, signal.SIGXCPU, signal.SIGPWR, signal.SIGRTMIN):
            running = self.begun(slow)
            running.send_signal(number)
            self.assertEqual(running.wait(LIMIT), -number)
            self.assertEqual(self.names(), ["bin/ffmpeg"], number)

    def test_a_signal_that_was_ignored_stays_ignored(self):
        running = self.begun(self.program("ffmpeg", "sleep 60"), signal.SIGHUP)
        running.send_signal(signal.SIGHUP)
        time.sleep(0.3)
        self.assertIsNone(running.poll())
        running.terminate()
        self.assertEqual(running.wait(LIMIT), -signal.SIGTERM)
        self.assertEqual(self.names(), ["bin/ffmpeg"])


class Spared(Case):
    def scenario(self):
        """A scenario whose organ, instrument and model are files of its folder."""
        organ, tool = self.folder / "organ.ply", self.folder / "blade.toml"
        self.assertEqual(resect("liver", "--edge", "5mm", "-o", organ).returncode, 0)
        text = (DATA / "tools" / "scalpel.toml").read_text()
        shutil.copy(DATA / "tools" / "scalpel.iv", self.folder / "blade.iv")
        tool.write_text(text.replace("scalpel.iv", "blade.iv"))
        return self.file("mine.toml", 'title = "t"\nduration = 0.05\n[organ]\nsource = "organ.ply"\nspacing = "12mm"\n'
                                      '[[tool]]\nmodel = "blade.toml"\n')

    def test_what_a_scenario_names_is_never_written(self):
        scenario = self.scenario()
        self.assertEqual(resect("run", scenario).returncode, 0)
        before = {file: file.read_bytes() for file in self.folder.iterdir()}
        self.assertEqual(len(before), 4)
        hard, soft = self.folder / "hard", self.folder / "soft"
        for file in before:
            hard.hardlink_to(file) if hasattr(hard, "hardlink_to") else os.link(file, hard)
            soft.symlink_to(file)
            for name in (file, hard, soft, self.folder / "." / ".." / self.folder.name / file.name):
                for option in ("--json", "--plot"):
                    args = [option, name] if option == "--json" else ["--thesis", "--json", name]
                    self.refused(resect("run", scenario, *args), 2, "is read")
                self.refused(resect("bench", scenario, "--json", name), 2, "is read")
                self.refused(resect("discretize", scenario, "-o", name), 2, "is read")
            hard.unlink()
            soft.unlink()
        self.refused(resect("run", scenario, "--surface", self.folder / "organ.ply"), 2, "organ.ply is read")
        self.refused(resect("run", scenario, "--surface", self.folder / "blade.iv"), 2, "blade.iv is read")
        os.link(self.folder / "organ.ply", self.folder / "piece_3.stl")
        self.refused(resect("run", scenario, "--pieces", self.folder, "--overwrite"), 2, "piece_3.stl is read")
        (self.folder / "piece_3.stl").unlink()
        self.assertEqual({file: file.read_bytes() for file in self.folder.iterdir()}, before)

    def test_what_comes_with_resect_is_not_written_by_who_reads_it(self):
        data = self.folder / "data"
        shutil.copytree(DATA, data)
        environment = {**os.environ, "RESECT_DATA": str(data)}
        for file in ("tools/scalpel.toml", "room/table.iv", "organs/liver.ply", "scenarios/cut-120.toml"):
            before = (data / file).read_bytes()
            self.refused(resect("run", "cut-120", "--json", data / file, env=environment), 2, "is read")
            self.assertEqual((data / file).read_bytes(), before)

    def test_the_buffers_of_a_gltf_model_are_never_written(self):
        for ending, name in (("gltf", "my buffer.bin"), ("GLTF", "my buffer.BIN")):
            buffer = self.file(name)
            uri = name.replace(" ", "%20")
            model = self.file(f"model.{ending}", json.dumps({"asset": {"version": "2.0"}, "buffers": [{"uri": uri}]}))
            for args in (["discretize", model, "-o", buffer], ["run", "cut-120", "--organ", model, "--json", buffer]):
                self.refused(resect(*args), 2, f"{name} is read")
            self.assertEqual(buffer.read_text(), "old")

    def test_two_outputs_of_one_file_are_refused_before_the_work(self):
        one, link, folder = self.file("one.json"), self.folder / "link", self.folder / "folder"
        link.symlink_to("one.json")
        new = self.folder / "new"
        for args in (["--json", one, "--surface", self.folder / "b" / ".." / "c.obj", "--plot", link],
                     ["--json", new, "--plot", self.folder / "x" / ".." / "new"],
                     ["--json", folder, "--frames", folder], ["--json", folder, "--frames", folder / "deeper"],
                     ["--surface", folder / "piece_2.stl", "--pieces", folder],
                     ["--plot", folder / "frame_0001.png", "--frames", folder]):
            self.refused(resect("run", "press", *args), 2)
        self.assertEqual((self.names(), one.read_text()), (["link", "one.json"], "old"))


class Numbered(Case):
    def test_files_of_an_earlier_run_are_refused_and_removed_only_when_asked(self):
        kept = [self.file(name) for name in ("frame_.png", "frame_1a.png", "frame_0002.jpg", "piece_9.obj", "notes.txt")]
        target = self.file("target.txt")
        stale = [self.file("frame_9999.png"), self.file("piece_9.stl"), self.folder / "frame_0123.png"]
        stale[2].symlink_to(target)
        args = ["run", "cut-120", "--frames", self.folder, "--pieces", self.folder, "--size", "64x48", "--picture-rate", "1"]
        before = self.names()
        self.refused(resect(*args), 1, "frame_0123.png", "--overwrite", "--frames")
        self.refused(resect(*args[:2], *args[4:]), 1, "piece_9.stl", "--overwrite", "--pieces")
        self.assertEqual(self.names(), before)
        for _ in range(2):
            done = resect(*args, "--overwrite")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertFalse(any(file.is_symlink() or file.exists() for file in stale))
            self.assertTrue(all(file.read_text() == "old" for file in [*kept, target]))
            self.assertTrue((self.folder / "frame_0001.png").exists() and (self.folder / "piece_1.stl").exists())
        self.refused(resect("run", "cut-120", "--frames", self.folder), 1, "frame_0001.png", "more such files")

    def test_nothing_is_removed_when_the_run_cannot_begin(self):
        self.file("frame_0007.png")
        self.assertEqual(resect("run", "cut-120", "--organ", self.folder / "none.stl", "--frames", self.folder,
                                "--overwrite").returncode, 1)
        self.assertEqual(self.names(), ["frame_0007.png"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
