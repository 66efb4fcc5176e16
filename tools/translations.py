#!/usr/bin/env python3
"""Keeps the texts of the window that are to be translated (docs/window.md, "Languages").

    translations.py            collects them anew, and adds new ones to the .ts files as unfinished
    translations.py --check    changes nothing; says what is out of date, missing or wrong

Texts of src/app are found by Qt's lupdate. Other texts reach the window from data files and from the layers below it,
which know no language. This script writes them to two headers of src/app/language, where lupdate finds them:
data_texts.h, of data files; sentence_texts.h, the patterns of sentences, whose values stand in the text as %1, %2.
"""
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib
import xml.etree.ElementTree
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
FOLDER = ROOT / "src/app/language"

# Sources whose texts are shown in the window, with what precedes those texts there. None: all literals that read like
# words.
SENTENCES = {
    "src/skills/score/goal_result.cpp": None,
    "src/skills/score/line_goal.cpp": None,
    "src/skills/score/findings.cpp": None,
    "src/skills/score/verdict.cpp": None,
    "src/skills/live/next_step.cpp": None,
    "src/operation/task/measure.cpp": r'MeasureKind\{"\w+",\s*',
    "src/operation/task/task.cpp": r"(?<=TaskLevel::Easy) \? |(?<=TaskLevel::Medium) \? |(?<=\"medium\") : ",
    "src/anatomy/anatomy.cpp": None,
    "src/anatomy/liver_names.cpp": None,
    "src/simulation/simulation.cpp": r"fmt::format\(\s*",
    "src/operation/frame_estimate.cpp": r"SlowFrame\)\) return \"\";\s*return fmt::format\(\s*",
    "src/record/recorder.cpp": r"failure_ = ",
}
# In all of src/app, which gives these functions English sentences.
SPOKEN = r"(?<![\w:>.])(?:complain|error|endExercise|failed)\(\s*(?:\w+\.isEmpty\(\) \? )?"
# Sentences that are put together from parts, and words that are shown alone.
OTHERS = [
    "%1; the operation goes on unrecorded",
    "%1: no browser could be started; open this file in one",
    "the file's reader ended without a word; try another file",
    "%1: 1 hole was closed",
    "%1: %2 holes were closed",
    "open, %1 boundary edge",
    "open, %1 boundary edges",
    "label %1",
    "0, from the start",  # names of branches
    "%1, from %2",
    "at most %1",
    "at least %1",
    "%1 of %2 mm",
    "%1 to %2",
    "%1 to %2 mm and %3 to %4 mm",
    "%1 to %2 mm and %3 to %4 mm and %5 to %6 mm",
]
# Literals of these sources that the window never shows.
SILENT = {
    "%1: has no task to be scored by; give one", "there is no goal %1", "and", "sparc", "ldlj", "undos", "all", "any", "clips",
    "at most", "at least", "limit of the task, %1", "band of the task: %1 +- %2 in %3 runs, %4 deviations allowed",
    "the segments of the kind %1 do not stand together; sort them by kind",
    "picture-size takes a width from 320 and a height from 240 on",
    "there is no display to open a window on; use `resect run` to operate without one",
}
# Sources of src/app whose texts go into files or to scripts; texts of the others that nobody is to translate.
UNSEEN = ["main_window_reports.cpp", "report_pdf.cpp"]
PLAIN = ["An exercise", "An exercise.", "the window", "are in force", "open, %1 boundary edge%2", "%1: %2 hole%3 closed"]
# Names of structures and built-in organs; names of models, as files of tasks give them.
NAMES = ["liver", "gallbladder", "tumour", "cyst", "cavity"]


def literals(text):
    """Literals of C++, with their starts; neighbours are one."""
    token = re.compile(r"//[^\n]*|\"(?:[^\"\\\n]|\\.)*\"|'(?:[^'\\\n]|\\.)+'")
    found = []
    for match in token.finditer(text):
        if match.group()[0] != '"' or "#include" in text[text.rfind("\n", 0, match.start()) + 1:match.start()]:
            continue
        value = match.group()[1:-1]
        if found and not text[found[-1][1]:match.start()].strip():
            found[-1] = (found[-1][0], match.end(), found[-1][2] + value)
        else:
            found.append((match.start(), match.end(), value))
    return [(start, value.replace('\\"', '"')) for start, _, value in found]


def reads_like_words(text):
    plain = re.sub(r"\{[^}]*\}", "", text)
    is_name = re.fullmatch(r"[a-z0-9]+(_[a-z0-9]*)+|[a-z0-9/]*/[a-z0-9/]*|[IVX]+", text)
    return re.search("[A-Za-z]{3}", plain) and not is_name


def numbered(text):
    """A pattern of fmt with the placeholders of Qt."""
    number = 0

    def next_number(_):
        nonlocal number
        number += 1
        return f"%{number}"

    return re.sub(r"\{[^{}]*\}", next_number, text).strip()


def sentence_texts():
    texts = []
    for name, before in SENTENCES.items():
        text = (ROOT / name).read_text()
        for start, value in literals(text):
            if (re.search(f"(?:{before})$", text[:start]) if before else reads_like_words(value)):
                texts.append(numbered(value))
    for source in sorted((ROOT / "src/app").rglob("*.cpp")):
        text = source.read_text()
        texts += [numbered(value) for start, value in literals(text)
                  if reads_like_words(value) and re.search(SPOKEN + "$", text[:start])]
    return list(dict.fromkeys(text for text in texts + OTHERS
                              if text not in SILENT and not text.startswith("vessel segment")))


def data_texts():
    texts = []
    for file in sorted((ROOT / "data/scenarios").glob("*.toml")) + sorted((ROOT / "data/tasks").glob("*.toml")):
        scenario = tomllib.loads(file.read_text())
        texts += [scenario.get("title"), scenario.get("description"), scenario.get("task", {}).get("teaches")]
        texts += scenario.get("task", {}).get("steps", [])
    for file in sorted((ROOT / "data/tools").glob("*.toml")):
        tool = tomllib.loads(file.read_text())
        texts += [tool["name"], tool.get("description"), file.stem.replace("_", " ").capitalize()]
    return list(dict.fromkeys(text for text in texts + NAMES if text))


def header(comment, context, texts, table):
    """`table`: the name of an array of them; "" for a file that is only read by lupdate."""
    lines = [f"// {line}" for line in comment] + ["// Written by tools/translations.py.", "// clang-format off"]
    lines += ["#pragma once", ""]
    lines += ["#include <QtGlobal>", "", "namespace resect {", ""] if table else []
    lines += [f"inline constexpr const char* {table}[] = {{"] if table else []
    for text in texts:
        escaped = text.replace("\\", "\\\\").replace('"', '\\"')
        lines.append(f'    QT_TRANSLATE_NOOP("{context}", "{escaped}"),')
    return "\n".join(lines + (["};", "", "}  // namespace resect"] if table else [])) + "\n"


def headers():
    return {
        FOLDER / "data_texts.h": header(["Texts of data files, for lupdate; included nowhere."], "data", data_texts(), ""),
        FOLDER / "sentence_texts.h": header(
            ["Patterns of the sentences that the layers below the window make; %1 stands for a value."], "sentences",
            sentence_texts(), "kSentenceTexts"),
    }


def lupdate(file):
    program = shutil.which("lupdate") or "/usr/lib/qt6/bin/lupdate"
    done = subprocess.run([program, ROOT / "src/app", "-I", ROOT / "src", "-locations", "none", "-no-obsolete", "-silent",
                           "-ts", file], capture_output=True, text=True)
    return [line for line in (done.stdout + done.stderr).splitlines()
            if line.strip() and not line.startswith("Scanning directory")]


def messages(file):
    """Source and context of each text, with its translation and whether that is finished."""
    found = {}
    for context in xml.etree.ElementTree.parse(file).getroot().iter("context"):
        for message in context.iter("message"):
            translation = message.find("translation")
            found[context.findtext("name"), message.findtext("source")] = (
                translation.text or "", translation.get("type") is None)
    return found


def faults_of(context, source, translation, finished):
    if not finished or not translation.strip():
        return "has no finished translation"
    places = [sorted(re.findall(r"%L?\d|\{[^}]*\}", text)) for text in (source, translation)]
    if places[0] != places[1]:
        return f"has the placeholders {' '.join(places[0])}, its translation {' '.join(places[1])}"
    if context == "window":
        for mark, what in (("&", "a key after &"), ("...", "three points at its end")):
            ends = [re.search(r"&\w", t) if mark == "&" else t.rstrip().endswith(mark) for t in (source, translation)]
            if bool(ends[0]) != bool(ends[1]):
                return f"has {what} in one language only"
    return ""


def unmarked():
    """Texts in src/app that read like sentences and that nothing translates."""
    marked = re.compile(SPOKEN + r"$|Words::\s*tr\(\s*$|QT_TRANSLATE_NOOP\(\s*\"\w+\",\s*$|(?<![\w>.])say\(\s*$|[sS]tyle.*$")
    for file in sorted((ROOT / "src/app").rglob("*.cpp")):
        if file.name in UNSEEN:
            continue
        text = file.read_text()
        for start, value in literals(text):
            words = numbered(re.sub("<[^>]*>", "", value))
            if (re.search("[A-Za-z]{2} [a-z]{2}", words) and not {words, "%1" + words} & {*PLAIN, *OTHERS} and
                    not marked.search(text[:start])):
                yield f"{file.relative_to(ROOT)}:{text.count(chr(10), 0, start) + 1}: \"{value}\": wrap it in Words::tr()"


def check():
    problems = list(unmarked())
    for file, text in headers().items():
        if not file.exists() or file.read_text() != text:
            problems.append(f"{file.relative_to(ROOT)}: is out of date; run tools/translations.py")
    for file in sorted(FOLDER.glob("*.ts")):
        name, have = file.relative_to(ROOT), messages(file)
        with tempfile.TemporaryDirectory() as folder:
            copy = Path(folder) / file.name
            shutil.copy(file, copy)
            problems += [f"{name}: lupdate: {line}" for line in lupdate(copy)]
            want = messages(copy)
        problems += [f"{name}: [{c}] \"{s}\" is missing; run tools/translations.py" for c, s in want if (c, s) not in have]
        problems += [f"{name}: [{c}] \"{s}\" is in no source any more; run tools/translations.py"
                     for c, s in have if (c, s) not in want]
        for (context, source), (translation, finished) in have.items():
            if fault := faults_of(context, source, translation, finished):
                problems.append(f"{name}: [{context}] \"{source}\" {fault}")
    return problems


def main():
    if sys.argv[1:] == ["--check"]:
        problems = check()
        print("\n".join(problems) or "All texts of the window are translated.")
        return 1 if problems else 0
    for file, text in headers().items():
        file.write_text(text)
    said = [line for file in sorted(FOLDER.glob("*.ts")) for line in lupdate(file)]
    print("\n".join(said), end="\n" if said else "")
    return 0


if __name__ == "__main__":
    sys.exit(main())
