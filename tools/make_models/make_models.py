"""Writes the instruments (data/tools/*.iv, with a .toml beside each) and the room (data/room/*.iv, and field_*.ply,
what of the operative field stops tissue).

    python3 tools/make_models/make_models.py data            write the files
    python3 tools/make_models/make_models.py data --check    exit status 1 when one differs
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
from field import body, model as field
from hands import model as hands

INSTRUMENTS = (scalpel, hook, baton, scissors, suction, clip_applier, bipolar)
INSTRUMENTS += (gauze, inflow_clamp, pencil, aspirator, forceps)
ROOM = (table, toolbox, field, body, hands)


def all_files():
    """{path in the folder of data: bytes} of everything, in a fixed order."""
    result = {}
    for folder, modules in (("tools", INSTRUMENTS), ("room", ROOM)):
        for module in modules:
            for name, content in module.files().items():
                content = content.encode() if isinstance(content, str) else content
                result[f"{folder}/{name}"] = content
    return result


def read(path):
    if not os.path.exists(path):
        return None
    with open(path, "rb") as file:
        return file.read()


def write(path, content):
    """Under a temporary name first, so that no half-written file is ever seen."""
    with open(path + ".tmp", "wb") as file:
        file.write(content)
    os.replace(path + ".tmp", path)


def main():
    parser = argparse.ArgumentParser(
        description="Write the models of the instruments and the room."
    )
    parser.add_argument("folder", help="where the folders tools and room are, e.g. data")
    parser.add_argument("--check", action="store_true", help="compare only, write nothing")
    options = parser.parse_args()
    different = []
    for name, content in all_files().items():
        path = os.path.join(options.folder, name)
        if options.check:
            if read(path) != content:
                different.append(name)
        else:
            os.makedirs(os.path.dirname(path), exist_ok=True)
            write(path, content)
    for name in different:
        print(
            f"{name} in {options.folder} is not what make_models.py writes; run it without --check"
        )
    return 1 if different else 0


if __name__ == "__main__":
    sys.exit(main())
