"""Sweeps: rows from a file, tables that do not depend on who runs them, what is left after a kill."""
import csv
import importlib.util
import os
import pathlib
import signal
import subprocess
import sys
import time
import tomllib
import unittest

import resect
from resect.sweep import read_plan, read_table, toml_text
from resect.sweep.settings import changed

BASE = """
scenario = "press"
[fixed]
"organ.spacing" = "25mm"
frame_rate = 10
duration = {duration}
"""


def sweep(*arguments, **options):
    return subprocess.run([sys.executable, "-m", "resect.sweep", *map(str, arguments)], capture_output=True, text=True,
                          timeout=300, **options)


def write(name, text, duration=1.5):
    pathlib.Path(name).write_text(BASE.format(duration=duration) + text)
    return name


def rows(path):
    return [{k: v for k, v in row.items() if k != "seconds"} for row in read_table(path)]


SIX = """
[vary]
"tissue.young" = [2000, 5000, 10000]
"tool.baton.shift_y" = [0.0, -0.02]
"""


class Plans(unittest.TestCase):
    def test_what_toml_reads_is_written_so_that_it_reads_the_same(self):
        document = {"a": 1, "b": 0.1, "c": 1e-30, "d": "x\"\\\n\u00e9\x7f", "e": [True, [1.5, -2]],
                    "f": {"g.h": {"i": []}, "j": [{"k": 1e300}, {}]}, "": 3.0}
        self.assertEqual(tomllib.loads(toml_text.toml_text(document)), document)
        for folder in ("scenarios", "tasks"):
            for path in pathlib.Path(resect.data_folder(), folder).glob("*.toml"):
                scenario = tomllib.loads(path.read_text())
                self.assertEqual(tomllib.loads(toml_text.toml_text(scenario)), scenario)

    def test_settings_reach_tables_lists_and_paths_of_instruments(self):
        scenario = tomllib.loads((pathlib.Path(resect.data_folder()) / "scenarios" / "press.toml").read_text())
        new = changed(scenario, {"tissue.young": 7000, "organ.spacing": "9mm", "tissue.attachment.0.stiffness": 50,
                                 "tool.baton.shift_x": 0.01, "tool.2.speed": 2.0, "tool.scalpel.response": "remove"}, "t")
        self.assertEqual(new["tissue"]["young"], 7000)
        self.assertEqual(new["tissue"]["attachment"][0]["stiffness"], 50)
        self.assertEqual(new["tool"][0]["response"], "remove")
        keys, before = new["tool"][2]["keys"], scenario["tool"][2]["keys"]
        self.assertEqual(keys[1]["offset"], [0.01, 0, 0])
        self.assertEqual(keys[1]["over"], before[1]["over"])
        self.assertEqual(keys[0]["time"], before[0]["time"])
        self.assertAlmostEqual(keys[1]["speed"], 2 * before[1]["speed"])
        self.assertAlmostEqual(keys[2]["wait"], before[2]["wait"] / 2)
        lift = tomllib.loads((pathlib.Path(resect.data_folder()) / "scenarios" / "lift.toml").read_text())
        keys, before = changed(lift, {"tool.hook.shift_x": 0.01, "tool.1.speed": 2.0}, "t")["tool"][1]["keys"], \
            lift["tool"][1]["keys"]
        self.assertAlmostEqual(keys[3]["position"][0], before[3]["position"][0] + 0.01)
        self.assertAlmostEqual(keys[-1]["time"] - keys[0]["time"], (before[-1]["time"] - before[0]["time"]) / 2)
        self.assertNotIn("young", scenario["tissue"])  # the first is not changed

    def test_rows_come_from_lists_a_table_and_chance(self):
        pathlib.Path("given.csv").write_text("tissue.young,tissue.plain\n3000,true\n4000,false\n")
        plan = read_plan(write("mixed.toml", """
            [random]
            count = 3
            seed = 1
            "tool.baton.shift_x" = [-0.01, 0.01]
            """.replace("            ", "")))
        self.assertEqual(len(plan.rows), 3)
        text = pathlib.Path("mixed.toml").read_text()
        pathlib.Path("mixed.toml").write_text('rows = "given.csv"\n' + text + '[vary]\n"tissue.density" = [1000, 1060]\n')
        plan = read_plan("mixed.toml")
        self.assertEqual(len(plan.rows), 12)
        self.assertEqual(plan.keys, ("tissue.young", "tissue.plain", "tissue.density", "tool.baton.shift_x"))
        self.assertEqual(plan.rows[0]["tissue.plain"], True)
        self.assertEqual(plan.rows, read_plan("mixed.toml").rows)
        self.assertEqual(len({plan.setup(n) for n in range(12)}), 12)

    def test_each_mistake_in_the_file_is_one_sentence(self):
        for text, words in [('scenario = "no-such"', "no scenario"), ("x = 1", "unknown key x"), ("a = [", "Invalid value"),
                            ('scenario = "press"\n[vary]\n"tissue.young" = 5', "list"),
                            ('scenario = "press"\n[vary]\n"tissue.young" = [-5]', "young"),
                            ('scenario = "press"\n[vary]\n"tool.laser.speed" = [1]', "laser"),
                            ('scenario = "press"\n[vary]\n"title.x" = [1]', "holds a value"),
                            ('scenario = "press"\n[random]\n"tissue.young" = [1, 2]', "count"),
                            ('scenario = "press"\nrows = "nothing.csv"', "nothing.csv")]:
            pathlib.Path("wrong.toml").write_text(text)
            done = sweep("wrong.toml")
            self.assertEqual(done.returncode, 1, text)
            self.assertRegex(done.stderr, rf"^resect: error: .*{words}[^\n]*\n$")
        done = sweep(write("six.toml", SIX), "-o", "x.txt")
        self.assertIn(".csv or .parquet", done.stderr)
        self.assertIn("no Dask scheduler answers", sweep("six.toml", "-o", "x.csv", "--dask", "tcp://127.0.0.1:9").stderr)


class Tables(unittest.TestCase):
    def test_the_table_does_not_depend_on_who_runs_it(self):
        write("six.toml", SIX)
        done = sweep("six.toml", "-o", "one.csv", "--workers", "1")
        self.assertEqual(done.returncode, 0, done.stderr)
        one = rows("one.csv")
        self.assertEqual([int(r["row"]) for r in one], list(range(6)))
        self.assertEqual(len({r["state_hash"] for r in one}), 6)
        sweep("six.toml", "-o", "two.csv", "--workers", "2")
        self.assertEqual(one, rows("two.csv"))
        for part in range(2):
            self.assertEqual(sweep("six.toml", "-o", "parts.csv", "--part", f"{part}/2").returncode, 0)
            if part == 0:
                self.assertIn("3 of 6 operations are in none", sweep("six.toml", "-o", "parts.csv", "--collect").stderr)
        self.assertEqual(sweep("six.toml", "-o", "parts.csv", "--collect").returncode, 0)
        self.assertEqual(one, rows("parts.csv"))
        self.assertFalse([p for p in os.listdir() if "partial" in p or "part-" in p or p.endswith(".tmp")])
        first = pathlib.Path("one.csv").read_text()
        again = sweep("six.toml", "-o", "one.csv")
        self.assertIn("6 of 6 operations are in", again.stderr)
        self.assertEqual(first, pathlib.Path("one.csv").read_text())  # the time each took is there too: none ran again

        done = sweep("six.toml", "-o", "one.csv", "--verify", "2")
        self.assertEqual((done.returncode, done.stdout), (0, "verified 2 of 6 operations, bit for bit\n"))
        text = pathlib.Path("one.csv").read_text()
        for row in one:
            text = text.replace(row["state_hash"], row["state_hash"][::-1])
        pathlib.Path("one.csv").write_text(text)
        self.assertEqual(sweep("six.toml", "-o", "one.csv", "--verify", "1").returncode, 1)

    def test_the_program_hands_over_to_the_package(self):
        write("two.toml", '[vary]\n"tissue.young" = [2000, 5000]\n')
        done = subprocess.run([os.environ["RESECT_PROGRAM"], "sweep", "two.toml", "-o", "program.csv"], timeout=200,
                              capture_output=True, text=True, env={**os.environ, "RESECT_PYTHON": sys.executable})
        self.assertEqual((done.returncode, len(rows("program.csv"))), (0, 2), done.stderr)
        done = subprocess.run([os.environ["RESECT_PROGRAM"], "sweep", "two.toml"], capture_output=True, text=True,
                              env={**os.environ, "RESECT_PYTHON": "/no/python"})
        self.assertEqual(done.returncode, 1)
        self.assertIn("tools/python_env.sh", done.stderr)
        done = subprocess.run([os.environ["RESECT_PROGRAM"], "sweep", "two.toml"], capture_output=True, text=True,
                              env={**os.environ, "RESECT_PYTHON": sys.executable, "PYTHONPATH": ""})
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, r"^resect: error: .* has no package resect;[^\n]*\n$")

    def test_a_table_that_is_read_is_not_written(self):
        pathlib.Path("own.csv").write_text("tissue.young\n3000\n")
        pathlib.Path("own.toml").write_text('rows = "own.csv"\nscenario = "press"\n')
        done = sweep("own.toml")
        self.assertEqual(done.returncode, 1)
        self.assertIn("is read by the sweep", done.stderr)
        self.assertEqual(pathlib.Path("own.csv").read_text(), "tissue.young\n3000\n")

    def test_a_row_that_cannot_be_run_says_why_and_is_tried_again(self):
        write("bad.toml", '[vary]\n"tissue.young" = [2000, -1, 5000]\n')
        done = sweep("bad.toml", "-o", "bad.csv", "--workers", "1")
        self.assertEqual(done.returncode, 1)
        found = rows("bad.csv")
        self.assertEqual([bool(r["error"]) for r in found], [False, True, False])
        self.assertIn("young", found[1]["error"])

    def test_what_was_done_before_a_kill_is_kept_and_the_rest_follows(self):
        for how, status in ((signal.SIGKILL, -9), (signal.SIGINT, 130)):
            with self.subTest(how.name):
                name = write(f"long-{how.name}.toml", "[random]\ncount = 14\n\"tissue.young\" = [2000, 9000]\n", 2.0)
                table = name.replace("toml", "csv")
                partial = pathlib.Path(table.replace(".csv", ".partial.csv"))
                process = subprocess.Popen([sys.executable, "-m", "resect.sweep", name, "--workers", "1"],
                                           stderr=subprocess.DEVNULL)
                end = time.monotonic() + 120
                while not (partial.exists() and partial.read_text().count("\n") > 3) and time.monotonic() < end:
                    time.sleep(0.02)
                process.send_signal(how)
                self.assertEqual(process.wait(60), status)
                before = {r["row"]: r for r in read_table(partial)}  # a valid table
                self.assertGreaterEqual(len(before), 3)
                with open(partial, "a") as file:
                    file.write("13,50")  # as if the kill had torn a line
                done = sweep(name, "--workers", "1")
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertIn("are in", done.stderr)
                after = {r["row"]: r for r in read_table(table)}
                self.assertEqual(len(after), 14)
                for row, result in before.items():
                    self.assertEqual(result, after[row])  # its time too: it was not run again
                self.assertFalse(partial.exists())

    def with_a_kill(self, table, count, after, *how):
        """Runs a sweep of `count` operations in which one process or worker is killed after `after` results."""
        name = write("lost.toml", f"[random]\ncount = {count}\n\"tissue.young\" = [2000, 9000]\n", 2.0)
        process = subprocess.Popen([sys.executable, "-m", "resect.sweep", name, "-o", table, "--workers", "2", *how],
                                   stderr=subprocess.DEVNULL)
        killed, journal = False, pathlib.Path(table.replace(".csv", ".partial.csv"))
        end = time.monotonic() + 120 + count
        while process.poll() is None and time.monotonic() < end:
            if not killed and journal.exists() and journal.read_text().count("\n") > after:
                tasks = pathlib.Path(f"/proc/{process.pid}/task").iterdir()  # any thread may have started it
                for child in [c for task in tasks for c in (task / "children").read_text().split()]:
                    if "spawn_main" in pathlib.Path(f"/proc/{child}/cmdline").read_text():
                        os.kill(int(child), signal.SIGKILL)
                        killed = True
                        break
            time.sleep(0.02)
        self.assertTrue(killed)
        self.assertEqual(process.wait(60), 0)
        return name

    def test_a_process_that_is_lost_loses_nothing(self):
        name = self.with_a_kill("lost.csv", 14, 2)
        sweep(name, "-o", "kept.csv", "--workers", "1")
        self.assertEqual(rows("lost.csv"), rows("kept.csv"))

    def test_a_dask_worker_that_is_lost_loses_nothing(self):
        if importlib.util.find_spec("distributed") is None:
            self.skipTest("Dask is not installed")
        long = os.environ.get("RESECT_LONG_TESTS")
        count, after, verified = (1000, 300, 20) if long else (14, 4, 3)
        name = self.with_a_kill("dask.csv", count, after, "--dask", "local")
        table = rows("dask.csv")
        self.assertEqual([int(r["row"]) for r in table], list(range(count)))
        self.assertFalse([r for r in table if r["error"]])
        done = sweep(name, "-o", "dask.csv", "--verify", verified)
        self.assertEqual(done.stdout, f"verified {verified} of {count} operations, bit for bit\n")
        subprocess.run([sys.executable, "-m", "resect.sweep", name, "-o", "kept.csv", "--workers", "2", "--quiet"],
                       check=True)
        self.assertEqual(table, rows("kept.csv"))

    def test_a_slurm_script_runs_each_part(self):
        write("six.toml", SIX)
        done = sweep("six.toml", "-o", "array.csv", "--slurm", "2", env={**os.environ, "PATH": ""})  # no sbatch there
        script = pathlib.Path("array.csv.slurm.sh")
        self.assertEqual(done.returncode, 1)
        self.assertIn("sbatch is not installed", done.stderr)
        self.assertIn("#SBATCH --array=0-1\n", script.read_text())
        for number in range(2):
            subprocess.run(["bash", script], check=True, timeout=200,
                           env={**os.environ, "SLURM_ARRAY_TASK_ID": str(number)})
        self.assertEqual(sweep("six.toml", "-o", "array.csv", "--collect").returncode, 0)
        self.assertEqual(len(list(csv.DictReader(open("array.csv")))), 6)


if __name__ == "__main__":
    unittest.main()
