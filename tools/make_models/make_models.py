"""Writes the instruments and the room (data/tools/*.iv and the .toml beside each instrument).

    python3 tools/make_models/make_models.py data/tools            write the files
    python3 tools/make_models/make_models.py data/tools --check    exit status 1 when one differs
"""

import argparse
import os
import sys

import aspirator
import baton
import bipolar
import clip_applier
import forceps
import gauze
import hook
import inflow_clamp
import pencil
import scalpel
import scissors
import suction
import table
import toolbox

INSTRUMENTS = (scalpel, hook, baton, scissors, suction, clip_applier, bipolar)
INSTRUMENTS += (gauze, inflow_clamp, pencil, aspirator, forceps)
ROOM = (table, toolbox)


def all_files():
    """{file name: text} of everything, in a fixed order."""
    result = {}
    for module in INSTRUMENTS + ROOM:
        result.update(module.files())
    return result


def read(path):
    if not os.path.exists(path):
        return None
    with open(path, encoding="utf-8", newline="") as file:
        return file.read()


def write(path, text):
    """Under a temporary name first, so that no half-written file is ever seen."""
    with open(path + ".tmp", "w", encoding="utf-8", newline="\n") as file:
        file.write(text)
    os.replace(path + ".tmp", path)


def main():
    parser = argparse.ArgumentParser(
        description="Write the models of the instruments and the room."
    )
    parser.add_argument("folder", help="where the files are, e.g. data/tools")
    parser.add_argument("--check", action="store_true", help="compare only, write nothing")
    options = parser.parse_args()
    different = []
    for name, text in all_files().items():
        path = os.path.join(options.folder, name)
        if options.check:
            if read(path) != text:
                different.append(name)
        else:
            os.makedirs(options.folder, exist_ok=True)
            write(path, text)
    for name in different:
        print(
            f"{name} in {options.folder} is not what make_models.py writes; run it without --check"
        )
    return 1 if different else 0


if __name__ == "__main__":
    sys.exit(main())
