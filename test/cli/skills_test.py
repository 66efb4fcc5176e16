"""skills_test.py RESECT FOLDER: tasks, attempts of scripted operators, debriefs and classes from the command line.

RESECT_ALL_TASKS=1 lets all operators do all tasks (five minutes); without it, they do the cheapest one.
"""
import csv
import html.parser
import http.server
import json
import os
import pathlib
import re
import shutil
import sqlite3
import subprocess
import sys
import threading
import tomllib
import unittest

PROGRAM, FOLDER = None, None
ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools" / "make_scenarios"))
import make_tasks  # noqa: E402


def resect(*arguments, **options):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=300, **options)


class Page(html.parser.HTMLParser):
    """What a page asks for besides itself, and whether its elements are closed in order."""

    VOID = {"meta", "img", "link", "br", "hr"}

    def __init__(self, text):
        super().__init__()
        self.open, self.asked, self.tags = [], [], []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        self.tags.append(tag)
        self.asked += [value for key, value in attributes if key in ("src", "href") and tag != "a"]
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attributes):
        self.tags.append(tag)

    def handle_endtag(self, tag):
        if self.open.pop() != tag:
            raise AssertionError(f"</{tag}> closes another element")


class Skills(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(FOLDER, ignore_errors=True)
        FOLDER.mkdir(parents=True)
        cls.attempts = {}

    def record(self, task, operator):
        """A recording of an operator at a task; the name of the scenario is that of the task."""
        folder = FOLDER / operator
        folder.mkdir(exist_ok=True)
        scenario, recording = folder / f"{task}.toml", folder / f"{task}.resect"
        scenario.write_text(make_tasks.TASKS[task](operator))
        run = resect("run", scenario, "--record", recording)
        self.assertEqual(run.returncode, 0, run.stderr)
        return recording

    def attempt(self, task, operator):
        """A recording of an operator at a task, and its score."""
        if (task, operator) not in self.attempts:
            recording = self.record(task, operator)
            self.attempts[task, operator] = recording, self.score(recording)
        return self.attempts[task, operator]

    def score(self, recording, *arguments):
        report = resect("report", recording, "--graded", "--json", "-", *arguments)
        self.assertEqual(report.returncode, 0, report.stderr)
        return json.loads(report.stdout)[-1]

    def refused(self, status, *arguments):
        run = resect(*arguments)
        self.assertEqual(run.returncode, status, run.stdout + run.stderr)
        self.assertEqual(run.stderr.count("\n"), 1, run.stderr)
        return run.stderr

    def check_ranks(self, task, reasons):
        """The good operator passes; each of the others fails, and the debrief says why."""
        best = self.attempt(task, "good")[1]
        self.assertTrue(best["passed"], best["reason"])
        self.assertEqual(best["deductions"], [])
        for operator, reason in reasons.items():
            score = self.attempt(task, operator)[1]
            self.assertFalse(score["passed"], f"{task}, {operator}")
            self.assertLess(score["score"], best["score"])
            facts = " ".join(d["fact"] for d in score["deductions"])
            self.assertRegex(facts.lower(), reason.lower(), operator)
            self.check_evidence(*self.attempt(task, operator))

    def check_evidence(self, recording, score):
        """What deductions say is what the recording holds."""
        end = score["measures"]["whole"]["total_time_s"]
        database = sqlite3.connect(recording)
        samples = database.execute("SELECT frame, max(force_x * force_x + force_y * force_y + force_z * force_z) "
                                   "FROM samples").fetchone()
        rate = float(database.execute("SELECT value FROM meta WHERE key = 'frame_rate'").fetchone()[0])
        database.close()
        for d in score["deductions"]:
            self.assertTrue(d["question"].endswith("?") and d["next"], d)
            if d["time_s"] is not None:
                self.assertTrue(0 <= d["time_s"] <= end + 1e-6, d)
            if d["measure"] == "force_peak_n":
                self.assertAlmostEqual(d["time_s"], samples[0] / rate, places=6)
                self.assertIn(f"{samples[1] ** 0.5:.1f} N", d["fact"])
            if d["measure"] == "vessels_unsealed":
                vessels = [v for v in score["vessels"] if v["cut_s"] == d["time_s"] and not v["clipped_before"]]
                self.assertTrue(any(f"{v['vessel']} of {v['diameter_mm']:.1f} mm" in d["fact"].lower() for v in vessels), d)

    def test_operators_are_ranked_for_the_right_reasons(self):
        self.check_ranks("clip-and-divide", {"hurried": "cut without a clip on the far side",
                                             "clumsy": "without a clip", "reckless": "cut without a clip on either side"})
        self.check_ranks("touch-and-hold", {"hurried": "0 of 4 targets", "clumsy": "Largest force",
                                            "reckless": "Largest force"})
        if os.environ.get("RESECT_ALL_TASKS"):
            self.check_ranks("two-hands", {"hurried": "of the line was followed", "clumsy": "distance from the line",
                                           "reckless": "with the tissue held: 0 %"})
            self.check_ranks("control-bleeding", {"hurried": "still bled", "clumsy": "Blood lost",
                                                  "reckless": "Blood lost"})
            self.check_ranks("wedge-resection", {"hurried": "0.9 of 0.9 ml were left behind", "clumsy": "left behind",
                                                "reckless": "smallest margin is"})
            self.check_ranks("left-lateral", {"hurried": "No part came off", "clumsy": "No part came off",
                                              "reckless": "distance from the plane"})

    def test_a_tremor_changes_smoothness_and_not_the_verdict_on_the_path(self):
        calm = self.attempt("touch-and-hold", "good")[1]
        shaking = self.score(self.record("touch-and-hold", "tremor"))
        verdict = lambda score: next(c["kept"] for c in score["checks"] if c["measure"] == "path_length_m")
        self.assertTrue(verdict(calm) and verdict(shaking))
        smooth = lambda score: score["measures"]["whole"]["ldlj"]
        self.assertLess(smooth(shaking), smooth(calm) - 0.5)

    def test_scores_are_the_same_at_any_number_of_threads(self):
        recording, one = self.attempt("touch-and-hold", "good")
        again = self.score(recording, "--threads", "1")
        self.assertEqual(one, again)

    def test_figures_of_a_path_stay_what_they_are(self):
        """They depend on the keys of the task alone: a change here is a change of a definition."""
        golden = json.loads((ROOT / "test" / "skills" / "clip_and_divide_figures.json").read_text())
        whole = self.attempt("clip-and-divide", "good")[1]["measures"]["whole"]
        self.assertEqual({name: whole[name] for name in golden}, golden)

    def test_the_debrief_is_one_page_that_asks_for_nothing(self):
        page = FOLDER / "report.html"
        good, bad = self.attempt("clip-and-divide", "good")[0], self.attempt("clip-and-divide", "reckless")[0]
        report = resect("report", good, bad, "-o", page, "--reference", good)
        self.assertEqual(report.stderr, "")
        self.assertEqual(report.returncode, 0, report.stderr)
        text = page.read_text()
        parsed = Page(text)
        self.assertEqual(parsed.open, [])
        self.assertEqual([a for a in parsed.asked if not a.startswith("data:")], [])
        self.assertNotIn("script", parsed.tags)
        self.assertEqual(text.count('class="turn"'), 1)
        self.assertGreater(parsed.tags.count("img"), 0)  # of the moments to which it points
        self.assertEqual(parsed.tags.count("video"), 1 if shutil.which("ffmpeg") else 0)
        self.assertLess(len(text), 5_000_000)
        self.assertFalse("{{" in text)
        for words in ("Not passed", "What to change", "cut without a clip on either side", "All attempts", "reference"):
            self.assertTrue(words in text, words)

    def test_the_debrief_as_pdf(self):
        paper = FOLDER / "report.pdf"
        report = resect("report", self.attempt("clip-and-divide", "reckless")[0], "-o", paper)
        self.assertEqual((report.returncode, report.stderr), (0, ""))
        data = paper.read_bytes()
        self.assertTrue(data.startswith(b"%PDF-") and data.rstrip().endswith(b"%%EOF"))
        self.assertGreater(len(re.findall(rb"/Type /Page\b", data)), 2)
        self.assertGreater(data.count(b"/Subtype /Image"), 8)  # five charts, four views, pictures of moments
        self.assertLess(len(data), 5_000_000)

    def test_foreign_text_stays_text(self):
        text = make_tasks.clip_and_divide_scenario("good").replace(
            'title = "Clip and divide"', 'title = "<script>alert(1)</script> & \\u202e"')
        folder = FOLDER / "foreign"
        folder.mkdir()
        (folder / "foreign.toml").write_text(text)
        recording, page = folder / "foreign.resect", folder / "foreign.html"
        resect("run", folder / "foreign.toml", "--record", recording)
        report = resect("report", recording, "-o", page, "--no-pictures", "--learner", '"><img src=x>')
        self.assertEqual(report.returncode, 0, report.stderr)
        parsed = Page(page.read_text())
        self.assertFalse({"script", "img"} & set(parsed.tags))
        self.assertTrue("\\u202e" in page.read_text())

    def test_tables_and_statements(self):
        recording, score = self.attempt("clip-and-divide", "good")
        rows, samples, xapi = FOLDER / "rows.csv", FOLDER / "samples.csv", FOLDER / "statements.json"
        report = resect("report", recording, "--graded", "--csv", rows, "--samples", samples, "--xapi", xapi,
                        "--learner", "L-17")
        self.assertEqual(report.returncode, 0, report.stderr)
        row, = csv.DictReader(rows.read_text().splitlines())
        self.assertEqual((row["passed"], row["learner"]), ("yes", "L-17"))
        self.assertEqual(float(row["path_length_m"]), score["measures"]["whole"]["path_length_m"])
        self.assertEqual({r["instrument"] for r in csv.DictReader(samples.read_text().splitlines())}, {"Scalpel", "Clip applier"})
        statements = json.loads(xapi.read_text())
        self.assertEqual([s["verb"]["id"].split("/")[-1] for s in statements], ["attempted", "completed", "passed"])
        for s in statements:
            self.check_statement(s)
            self.assertRegex(s["id"], "^[0-9a-f]{8}-[0-9a-f]{4}-4[0-9a-f]{3}-[89ab][0-9a-f]{3}-[0-9a-f]{12}$")
            self.assertRegex(s["timestamp"], r"^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d\.\d{3}Z$")
            self.assertEqual(s["actor"]["account"]["name"], "L-17")
        self.assertIs(statements[-1]["result"]["success"], True)
        self.assertTrue(0 <= statements[-1]["result"]["score"]["scaled"] <= 1)
        again = FOLDER / "again.json"
        resect("report", recording, "--graded", "--xapi", again, "--learner", "L-17")
        self.assertEqual([s["id"] for s in json.loads(again.read_text())], [s["id"] for s in statements])

    def check_statement(self, s):
        """The properties that the specification of xAPI 1.0.3 knows (part two, section 2), and their forms."""
        def keys(table, required, allowed=()):
            self.assertTrue(set(required) <= set(table) <= {*required, *allowed}, table.keys())

        def iri(text):
            self.assertRegex(text, r"^[a-z][a-z0-9+.-]*:[^\s<>]+$")

        def words(table):
            self.assertTrue(table and all(re.fullmatch("[a-z]{2,3}(-[A-Za-z0-9]+)*", key) for key in table), table)

        keys(s, ("id", "actor", "verb", "object", "context", "timestamp", "version"), ("result",))
        keys(s["actor"], ("objectType", "account"))
        keys(s["actor"]["account"], ("homePage", "name"))
        keys(s["verb"], ("id", "display"))
        keys(s["object"], ("objectType", "id", "definition"))
        keys(s["object"]["definition"], ("type", "name", "description"))
        keys(s["context"], ("platform", "language", "extensions"))
        for one in (s["actor"]["account"]["homePage"], s["verb"]["id"], s["object"]["id"], s["object"]["definition"]["type"],
                    *s["context"]["extensions"], *s.get("result", {}).get("extensions", ())):
            iri(one)
        for one in (s["verb"]["display"], s["object"]["definition"]["name"], s["object"]["definition"]["description"]):
            words(one)
        self.assertEqual((s["actor"]["objectType"], s["object"]["objectType"], s["version"]), ("Agent", "Activity", "1.0.3"))
        if result := s.get("result"):
            keys(result, ("completion",), ("score", "success", "duration", "response", "extensions"))
            self.assertRegex(result["duration"], r"^PT\d+(\.\d\d?)?S$")
            score = result["score"]
            keys(score, ("scaled", "raw", "min", "max"))
            self.assertTrue(-1 <= score["scaled"] <= 1 and score["min"] <= score["raw"] <= score["max"])
            self.assertTrue(all(isinstance(result[key], bool) for key in ("completion", "success") if key in result))

    def test_statements_are_sent_to_a_store(self):
        class Store(http.server.BaseHTTPRequestHandler):
            asked, answer = [], 200

            def do_POST(self):
                body = self.rfile.read(int(self.headers["Content-Length"]))
                Store.asked.append((self.path, dict(self.headers), json.loads(body)))
                self.send_response(Store.answer)
                self.end_headers()
                self.wfile.write(b"a word from the store" if Store.answer >= 400 else b"[]")

            def log_message(self, *words):
                pass

        server = http.server.HTTPServer(("127.0.0.1", 0), Store)
        thread = threading.Thread(target=server.serve_forever)
        thread.start()
        try:
            recording = self.attempt("clip-and-divide", "good")[0]
            url = f"http://127.0.0.1:{server.server_port}/xapi/"
            command = ["report", recording, "--graded", "--learner", "L-17", "--lrs", url]
            key = {**os.environ, "RESECT_LRS_KEY": "key:secret"}
            sent = resect(*command, env=key)
            self.assertEqual(sent.returncode, 0, sent.stderr)
            path, headers, statements = Store.asked[0]
            self.assertEqual((path, headers["X-Experience-API-Version"]), ("/xapi/statements", "1.0.3"))
            self.assertEqual(headers["Authorization"], "Basic a2V5OnNlY3JldA==")
            self.assertEqual(len(statements), 3)
            Store.answer = 409
            self.assertIn("already", resect(*command).stderr)
            Store.answer = 401
            file = FOLDER / "kept.json"
            self.assertRegex(self.refused(1, *command, "--xapi", file), "401: a word from the store.*RESECT_LRS_KEY")
            self.assertEqual(len(json.loads(file.read_text())), 3)  # nothing is lost
        finally:
            server.shutdown()
            thread.join()
            server.server_close()
        self.assertIn("cannot be reached", self.refused(1, *command))
        self.assertIn("--lrs", self.refused(2, "report", recording, "--lrs", "file:///etc/passwd"))

    def test_a_class(self):
        folder = FOLDER / "class"
        for learner, operators in (("anna", ["reckless", "good", "good", "good"]), ("bela", ["hurried", "clumsy"])):
            (folder / learner).mkdir(parents=True)
            for i, operator in enumerate(operators, 1):
                shutil.copy(self.attempt("clip-and-divide", operator)[0], folder / learner / f"{i}.resect")
        (folder / "bela" / "3.resect").write_text("no recording")
        page, table = folder / "class.html", folder / "class.csv"
        for output in (page, table):
            run = resect("class", folder, "-o", output)
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertIn("is no recording", run.stderr)
        rows = list(csv.DictReader(table.read_text().splitlines()))
        self.assertEqual([r["passed"] for r in rows], ["no", "yes", "yes", "yes", "no", "no"])
        self.assertEqual([r["graded"] for r in rows], ["no", "yes", "yes", "yes", "no", "yes"])
        self.assertAlmostEqual(float(rows[3]["lc_cusum"]), 3 * 0.2513144, places=4)  # ln(0.9 / 0.7)
        for text in (page.read_text(), table.read_text()):
            self.assertFalse("anna" in text)
            self.assertTrue("learner 1" in text)
        self.assertEqual(Page(page.read_text()).open, [])
        history = folder / "scores.sqlite"
        first = resect("class", folder, "--history", history)
        for recording in folder.glob("anna/*.resect"):
            recording.touch()  # the same bytes are not played again
        again = resect("class", folder, "--history", history)
        self.assertEqual((first.returncode, again.returncode), (0, 0), again.stderr)
        self.assertEqual(first.stdout, again.stdout)
        named = resect("class", folder, "-o", table, "--names")
        self.assertIn("anna", table.read_text(), named.stderr)

    def test_a_history_is_kept_exported_and_deleted(self):
        history, table = FOLDER / "history.sqlite", FOLDER / "history.csv"
        for operator, learner in (("good", "L-17"), ("reckless", "L-17"), ("good", "L-18")):
            recording = self.attempt("clip-and-divide", operator)[0]
            for _ in range(2):  # twice the same
                kept = resect("report", recording, "--graded", "--learner", learner, "--history", history)
                self.assertEqual(kept.returncode, 0, kept.stderr)
        page, scored = FOLDER / "third.html", FOLDER / "third.json"
        third = self.attempt("clip-and-divide", "hurried")[0]
        known = resect("report", third, "--learner", "L-17", "--history", history, "-o", page, "--json", scored)
        self.assertEqual(known.returncode, 0, known.stderr)
        text = page.read_text()
        for words in ("attempt before", "class, median", "The others of the class: 1 attempts, 1 passed."):
            self.assertTrue(words in text, words)
        listed = re.findall("<td class=\"number\">([1-9])</td><td class=\"(quiet|kept|missed)\">", text)
        self.assertEqual([listed[0], listed[2]], [("1", "quiet"), ("3", "missed")])  # the first is to get familiar
        self.assertTrue(json.loads(scored.read_text())[0]["graded"])  # this one is not the first
        self.assertIn("1 attempts", resect("history", history, "--learner", "L-18", "--delete").stdout)
        resect("report", self.attempt("clip-and-divide", "good")[0], "--learner", "L-18", "--history", history)
        shown = resect("history", history, "--csv", table)
        self.assertEqual((shown.returncode, shown.stdout.count("\n")), (0, 4), shown.stderr)
        rows = list(csv.DictReader(table.read_text().splitlines()))
        self.assertEqual([r["learner"] for r in rows], ["L-17", "L-17", "L-17", "L-18"])
        self.assertEqual(sorted(r["passed"] for r in rows), ["no", "no", "yes", "yes"])
        self.assertIn("3 attempts", resect("history", history, "--learner", "L-17", "--delete").stdout)
        self.assertFalse(b"L-17" in history.read_bytes())
        self.assertEqual(resect("history", history).stdout.count("\n"), 1)
        self.refused(2, "history", history, "--delete")
        self.refused(1, "history", FOLDER / "none.sqlite")
        self.assertIn("another kind", self.refused(1, "history", self.attempt("clip-and-divide", "good")[0]))

    def test_tasks_are_listed_and_checked(self):
        listed = json.loads(resect("task", "list", "--json").stdout)
        self.assertEqual({t["scenario"] for t in listed}, set(make_tasks.TASKS))
        for task in listed:
            self.assertTrue(task["teaches"] and task["title"] and task["level"])
        check = resect("task", "check", "clip-and-divide")
        self.assertEqual(check.returncode, 0, check.stderr)

    def test_the_page_of_what_a_task_teaches(self):
        for name in make_tasks.TASKS:
            page = FOLDER / "about.html"
            shown = resect("task", "show", name, "-o", page)
            self.assertEqual((shown.returncode, shown.stderr), (0, ""), name)
            text = page.read_text()
            parsed = Page(text)
            self.assertEqual(parsed.open, [])
            self.assertEqual([a for a in parsed.asked if not a.startswith("data:")], [])
            task = tomllib.loads((ROOT / "data" / "tasks" / f"{name}.toml").read_text())["task"]
            for words in (task["teaches"], task["background"], *task["steps"], "Why", "easy"):
                self.assertIn(html.escape(words), text)
            self.assertIn("<img", text)
        self.assertIn("at most 30 s", text)  # of the last one, at the level medium

    def test_a_wrong_task_is_refused_with_file_line_and_key(self):
        good = make_tasks.clip_and_divide_scenario("good")
        wrong = {
            "kind": (good.replace('kind = "divide"', 'kind = "divid"'), "kind"),
            "vessel": (good.replace('"hepatic-vein"', '"vein"'), "vessel"),
            "measure": (good.replace("vessels_unsealed = 0", "clip = 2"), "clip"),
            "instrument": (good.replace('instruments = ["scalpel"', 'instruments = ["scalpels"'), "instruments"),
            "key": (good.replace("thinnest", "thinest"), "thinest"),
            "organ": (good.replace('vessels = "built-in"\n', ""), "kind"),
            "pass": (good.replace('level = "medium"', 'pass = "some"'), "pass"),
        }
        for name, (text, key) in wrong.items():
            file = FOLDER / f"wrong-{name}.toml"
            self.assertNotEqual(text, good, name)
            file.write_text(text)
            for command in (["task", "check", file], ["run", file]):
                sentence = self.refused(1, *command)
                self.assertRegex(sentence, rf"wrong-{name}\.toml:\d+: task\.\S*{key}")
        structure = make_tasks.wedge_scenario("good").replace('name = "tumour"', 'name = "cyst"')
        file = FOLDER / "structure.toml"
        file.write_text(structure)
        self.assertRegex(self.refused(1, "task", "check", file), r"structure\.toml:\d+: task\.goal\.structure")
        band = FOLDER / "band.toml"
        band.write_text(good.replace('level = "medium"', 'published = ["nobody-1900"]'))
        self.assertIn("lefor-2022", self.refused(1, "task", "check", band))

    def test_bad_input_is_a_sentence(self):
        recording = self.attempt("clip-and-divide", "good")[0]
        without = FOLDER / "without.resect"
        resect("run", "cut-120", "--record", without)
        self.assertIn("without a task", self.refused(1, "report", without))
        self.assertIn("no vessels", self.refused(1, "report", without, "--task", "clip-and-divide"))
        self.refused(1, "report", FOLDER / "nothing.resect")
        self.assertIn("--level", self.refused(2, "report", recording, "--level", "harder"))
        self.refused(2, "report", recording, "-o", recording)
        self.refused(1, "class", FOLDER / "nowhere")
        self.refused(2, "class", FOLDER, "-o", FOLDER / "class.txt")
        torn = FOLDER / "torn.resect"
        torn.write_bytes(recording.read_bytes()[:100_000])
        self.refused(1, "report", torn, "-o", FOLDER / "torn.html")
        self.assertFalse((FOLDER / "torn.html").exists())

    def test_a_full_disk_is_a_sentence_and_leaves_nothing(self):
        if os.geteuid() != 0:
            self.skipTest("mounting a small disk takes root")
        place = FOLDER / "disk"
        place.mkdir()
        if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=8k", "tmpfs", place], capture_output=True).returncode:
            self.skipTest("no small disk can be mounted")
        try:
            recording = self.attempt("clip-and-divide", "good")[0]
            self.assertIn("disk", self.refused(1, "report", recording, "-o", place / "report.html"))
            self.assertEqual(list(place.iterdir()), [])
        finally:
            subprocess.run(["umount", place])


if __name__ == "__main__":
    PROGRAM, FOLDER = pathlib.Path(sys.argv.pop(1)).resolve(), pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
