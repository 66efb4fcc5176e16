#!/usr/bin/env python3
"""The force for a hand, from the program: a short bench, the example of the how-to, and plug-ins that are wrong.

    haptics_test.py PROGRAM FOLDER COMPILER
"""
import json
import os
import re
import subprocess
import sys
import unittest
from pathlib import Path

PROGRAM, FOLDER, COMPILER = sys.argv[1], Path(sys.argv[2]), sys.argv[3]
ROOT = Path(__file__).resolve().parents[2]
HEADER = ROOT / "src" / "haptics" / "device"
LIMIT = 300 * float(os.environ.get("RESECT_PATIENCE", 1))  # s for one run

# A plug-in in which one thing can be wrong.
PLUGIN = """
#include "resect_haptic_device.h"
#include <stddef.h>
static ResectHapticDevice* open_it(const char* o, ResectHapticLimits* l) {
  (void)o; l->most_force = MOST; l->most_torque = 0; return OPENED;
}
static void close_it(ResectHapticDevice* d) { (void)d; }
static int read_it(ResectHapticDevice* d, ResectHapticPose* p) { (void)d; (void)p; return READ; }
static int write_it(ResectHapticDevice* d, const ResectHapticForce* f) { (void)d; (void)f; return 0; }
static const char* why(ResectHapticDevice* d) { (void)d; return "the plug is out"; }
static const ResectHapticDeviceFunctions table = {VERSION, "test", open_it, close_it, READER, write_it, why, NULL};
const ResectHapticDeviceFunctions* ENTRY(void) { return &table; }
"""
RIGHT = {"MOST": "5.0", "OPENED": "(ResectHapticDevice*)1", "READ": "0", "VERSION": "RESECT_HAPTIC_DEVICE_VERSION",
         "READER": "read_it", "ENTRY": "resect_haptic_device"}


def resect(*args):
    return subprocess.run([PROGRAM, *map(str, args)], capture_output=True, text=True, timeout=LIMIT)


def compiled(name, text, definitions=()):
    source, library = FOLDER / f"{name}.c", FOLDER / f"{name}.so"
    source.write_text(text)
    subprocess.run([COMPILER, "-x", "c", "-Wall", "-Wextra", "-Werror", "-Wno-unused-function", "-shared", "-fPIC",
                    f"-I{HEADER}", *(f"-D{key}={value}" for key, value in definitions), source, "-o", library], check=True)
    return library


def bench(*args):
    done = resect("bench", "--haptics", "--json", "-", *args)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


class Haptics(unittest.TestCase):
    def test_a_short_bench_presses_with_a_simulated_hand_that_gets_no_energy(self):
        # The first four seconds of `press`: down, still, up. Cells are large, so that it keeps up on a busy machine.
        figures = bench("press", "--seconds", 4, "--spacing", "12mm", "--threads", 1)
        self.assertEqual(figures["device"], "simulated hand")
        (run,) = figures["runs"]
        self.assertGreaterEqual(run["cycles"], 3900)
        self.assertGreater(run["met_percent"], 50)  # others use the machine too
        self.assertLessEqual(run["jitter_us"]["p50"], run["jitter_us"]["p99"])
        (hand,) = run["hands"]
        self.assertEqual(hand["tool"], "Baton")
        self.assertGreater(hand["peak_force_N"], 0.1)
        self.assertGreater(hand["peak_stiffness_N_per_m"], 10)
        self.assertLess(hand["energy_to_hand_J"], 0)
        self.assertLess(hand["most_energy_to_hand_J"], 1e-5)

    def test_the_example_of_the_how_to_compiles_and_runs(self):
        page = (ROOT / "docs" / "how-to" / "haptic_device.md").read_text()
        example = re.search(r"```c\n(.*?)```", page, re.S)[1]
        figures = bench("press", "--seconds", 1, "--spacing", "15mm", "--device", compiled("my_device", example))
        self.assertEqual(figures["device"], "my device")

    def test_what_is_wrong_with_a_plug_in_is_said_in_one_sentence(self):
        (FOLDER / "text.so").write_text("no library")
        wrong = {"no_symbol": ({"ENTRY": "another_function"}, "has no function resect_haptic_device()"),
                 "old": ({"VERSION": "99"}, "is for version 99 of the interface"),
                 "no_read": ({"READER": "NULL"}, "has no function read() in its table"),
                 "closed": ({"OPENED": "NULL"}, "failed in open(): the plug is out"),
                 "weak": ({"MOST": "0.0"}, "it must say more than 0"),
                 "breaks": ({"READ": "1"}, "failed in read(): the plug is out")}
        cases = [(compiled(name, PLUGIN, (RIGHT | change).items()), says) for name, (change, says) in wrong.items()]
        cases += [(FOLDER / "none.so", "there is no haptic plug-in"), (FOLDER / "text.so", "is not a shared library"),
                  ("no_such_device", "there is no haptic device"),
                  ("no_such_device.so", "there is no haptic plug-in")]
        for plugin, says in cases:
            done = resect("bench", "press", "--haptics", "--seconds", 1, "--spacing", "15mm", "--device", plugin)
            self.assertEqual(done.returncode, 1, (plugin, done.stderr))
            lines = [line for line in done.stderr.splitlines() if "error" in line]
            self.assertEqual(len(lines), 1, done.stderr)
            self.assertIn(says, lines[0])

    def test_wrong_arguments_give_status_2(self):
        for args in (["--seconds", "5"], ["--haptics", "--seconds", "0"], ["--haptics", "--thesis"], ["--haptics", "--once"], ["--haptics", "--most", "1000"],
                     ["press", "--haptics", "--tool", "spoon", "--spacing", "15mm"]):
            self.assertEqual(resect("bench", *args).returncode, 2, args)


if __name__ == "__main__":
    FOLDER.mkdir(parents=True, exist_ok=True)
    unittest.main(argv=sys.argv[:1])
