"""run.sh, test.sh and tools/build.sh in a tree of their own, where cmake is a script that only notes its calls."""

import os
import shutil
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
CMAKE = """#!/usr/bin/env bash
echo begin >>"$CALLS"; sleep 0.3; echo end >>"$CALLS"
"""


class Scripts(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.top = Path(folder.name)
        self.tree, self.calls = self.top / "a" / "tree", self.top / "calls"
        for name in ("run.sh", "test.sh", "tools/build.sh"):
            (self.tree / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / name, self.tree / name)
        self.program("tree/tools/install_packages.sh", "#!/bin/sh\n")
        self.program("bin/cmake", CMAKE)
        self.program("bin/ctest", "#!/bin/sh\necho '100% tests passed'\n")

    def program(self, name, text):
        path = self.top / "a" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        path.chmod(0o755)

    def start(self, *args):
        path = f"{self.top / 'a' / 'bin'}:{os.environ['PATH']}"
        return subprocess.Popen([str(self.tree / args[0]), *args[1:]], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                text=True, env={**os.environ, "PATH": path, "CALLS": str(self.calls)})

    def end(self, process):
        out, err = process.communicate(timeout=60)
        return process.returncode, out, err

    def test_names_that_are_no_builds_are_refused_and_make_no_folder(self):
        for args in (["../../x"], [""], ["-x"], ["release", "../../x"], ["a\nb"]):
            status, _, err = self.end(self.start("test.sh", *args))
            self.assertEqual(status, 2, args)
            self.assertEqual(len(err.splitlines()), 1, err)
            self.assertIn("release, asan, tsan and dev", err)
        self.assertEqual(self.end(self.start("tools/build.sh", "../../x"))[0], 2)
        self.assertEqual(self.end(self.start("tools/build.sh"))[0], 2)
        self.assertEqual(sorted(p.name for p in self.top.iterdir()), ["a"])
        self.assertFalse((self.tree / "build").exists())

    def test_two_builds_of_one_preset_run_one_after_the_other(self):
        first = self.start("tools/build.sh", "release")
        while not self.calls.exists():
            time.sleep(0.01)
        second = self.end(self.start("tools/build.sh", "release"))
        self.assertEqual((self.end(first)[0], second[0]), (0, 0), second[2])
        self.assertEqual(self.calls.read_text().split(), ["begin", "end"] * 4)
        self.assertIn("Waiting for another build", second[2])

    def test_the_builds_of_two_presets_do_not_wait_for_each_other(self):
        first = self.start("tools/build.sh", "release")
        while not self.calls.exists():
            time.sleep(0.01)
        self.assertNotIn("Waiting", self.end(self.start("tools/build.sh", "dev"))[2])
        self.assertEqual(self.end(first)[0], 0)

    def test_the_tests_of_a_known_build_are_run(self):
        status, out, err = self.end(self.start("test.sh", "dev"))
        self.assertEqual(status, 0, err)
        self.assertIn("tests passed", out)

    def test_a_tree_that_cannot_be_written_is_told_in_one_sentence(self):
        (self.tree / "build").write_text("a file stands where the folder would be, as root can write anywhere\n")
        status, _, err = self.end(self.start("run.sh"))
        self.assertEqual(status, 1)
        self.assertEqual(len(err.splitlines()), 1, err)
        self.assertIn("build/release cannot be written; copy Resect", err)


if __name__ == "__main__":
    unittest.main()
