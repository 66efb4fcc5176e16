#!/usr/bin/env python3
"""Checks the rules for files.

A folder has at most 25 files; files of src/ have at most 400 lines and no name that says nothing; headers begin with a comment and
are included once; links between documents lead somewhere; nothing in the repository names a place on
somebody's machine. tools/file_rules.txt
lists the exceptions, each with its reason. Prints file:line for each breach and exits with 1.
"""

import re
import subprocess
import sys
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
MOST_LINES = 400
MOST_FILES = 25  # in one folder, without its sub-folders
EMPTY_NAMES = {"util", "utils", "common", "core", "manager", "helper", "helpers", "misc"}
# Absolute paths into a home, a temporary or a working folder.
MACHINE_PATH = re.compile(r"(?<![\w./}$-])/(home|root|tmp|work|Users)/\w")
# What a C library rounds in its own way, in layers that the state depends on; base/elementary.h has the same. Scores
# are printed with fewer digits than that.
MACHINE_MATHS = re.compile(r"std::(sin|cos|tan|asin|acos|atan2?|exp2?|expm1|log(2|10|1p)?|pow|cbrt|hypot|a?sinh|a?cosh|a?tanh|[lt]gamma|erfc?)\b"
                           r"|\bAngleAxis|\.slerp\(|\bangularDistance\b")
WITHOUT_STATE = {"formats", "skills", "inventor", "app", "cli"}
LINK = re.compile(r"\]\((?!https?:|mailto:|#)([^)#\s]+)")
TEXT = {".h", ".cpp", ".py", ".sh", ".md", ".txt", ".toml", ".cmake", ".json", ".glsl", ".vert", ".frag", ""}


def read_exceptions(path):
    """{file: reason} from lines "FILE: reason"."""
    exceptions = {}
    for number, line in enumerate(path.read_text().splitlines(), 1):
        if not line.strip() or line.startswith("#"):
            continue
        file, colon, reason = line.partition(": ")
        if not colon or not reason.strip():
            sys.exit(f"{path}:{number}: expected \"FILE: reason\"")
        exceptions[file] = reason
    return exceptions


def tracked_files(root):
    """Files that are or would be committed; all files where there is no git."""
    try:
        listed = subprocess.run(
            ["git", "-c", f"safe.directory={root}", "-C", str(root), "ls-files", "-co", "--exclude-standard"],
            capture_output=True, text=True, check=True).stdout.splitlines()
        return sorted(root / name for name in listed if (root / name).is_file())
    except (OSError, subprocess.CalledProcessError):
        return sorted(p for p in root.rglob("*") if p.is_file() and
                      not {"build", "output", ".git"} & set(p.relative_to(root).parts))


def breaches(file, name, lines, exceptions):
    """Yields (line number, sentence)."""
    parts = Path(name).parts
    if parts[0] == "src" and file.suffix in (".h", ".cpp"):
        if len(lines) > MOST_LINES and name not in exceptions:
            yield MOST_LINES + 1, f"{len(lines)} lines, more than {MOST_LINES}: one concept per file"
        for word in EMPTY_NAMES & set(re.split(r"[_./]", name)):
            yield 1, f'"{word}" in a name says nothing about what is inside'
        for number, line in enumerate(lines, 1):
            found = MACHINE_MATHS.search(line) if parts[1] not in WITHOUT_STATE and name not in exceptions else None
            if found:
                yield number, f"{found[0]} gives other bits on other machines: base/elementary.h, geometry/rotation.h"
        if file.suffix == ".h" and not lines[0].startswith("//"):
            yield 1, "a header begins with a comment: one sentence that says what it gives"
        if file.suffix == ".h" and "#pragma once" not in lines:
            yield 1, "#pragma once is missing"
    for number, line in enumerate(lines, 1):
        for target in LINK.findall(line) if file.suffix == ".md" else []:
            if not (file.parent / target).exists():
                yield number, f"the link to {target} leads nowhere"
        if MACHINE_PATH.search(line) and name not in exceptions:
            yield number, "names a place on one machine: " + line.strip()[:80]


def main():
    root = Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT
    exceptions = read_exceptions(root / "tools" / "file_rules.txt")
    broken, looked_at = 0, 0
    files = tracked_files(root)
    for folder, count in sorted(Counter(file.parent.relative_to(root) for file in files).items()):
        if count > MOST_FILES and str(folder) not in exceptions:
            print(f"{folder}:1: {count} files, more than {MOST_FILES} in one folder: part it by concept")
            broken += 1
    for file in files:
        name = str(file.relative_to(root))
        if file.suffix not in TEXT:
            continue
        looked_at += 1
        lines = file.read_text(errors="replace").splitlines() or [""]
        for number, sentence in breaches(file, name, lines, exceptions):
            print(f"{name}:{number}: {sentence}")
            broken += 1
    for name in exceptions:
        if not (root / name).exists():
            print(f"tools/file_rules.txt: there is no {name}")
            broken += 1
    if not broken:
        print(f"{looked_at} files keep the rules")
    return 1 if broken or not looked_at else 0


if __name__ == "__main__":
    sys.exit(main())
