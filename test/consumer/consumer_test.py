#!/usr/bin/env python3
"""consumer_test.py CMAKE BUILD COMPILER: installs BUILD into a staging folder, builds a stranger's projects against the
package there and runs them: one on the component core, which looks at what it is linked with, and one on the component
full, if the package has it."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "support"))
from expected_states import ELASTIC  # noqa: E402

HERE = Path(__file__).resolve().parent
STRANGERS = ("Coin", "Qt", "GL", "assimp", "png", "X11")  # libraries that a headless step must not need


def run(*command, **settings):
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, **settings)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))} failed:\n{done.stdout[-3000:]}{done.stderr[-3000:]}")
    return done.stdout


def built(project, program, cmake, folder, staging, compiler):
    run(cmake, "-S", HERE / project, "-B", folder, f"-DCMAKE_PREFIX_PATH={staging}", f"-DCMAKE_CXX_COMPILER={compiler}",
        "-DCMAKE_BUILD_TYPE=Release")
    run(cmake, "--build", folder)
    return folder / program


def check_core(program, environment):
    said = run(program, env=environment)
    print(said, end="")
    found = re.fullmatch(r"Resect [\d.]+: (\d+) particles, at most ([\d.]+) N on the baton, state ([0-9a-f]{16})\n", said)
    if not found or int(found[1]) < 2000 or not 0.1 < float(found[2]) < 50:
        sys.exit("which is not what a pressed liver says")
    # The same bits as the program's, which reads the instruments through Inventor.
    if found[3] != ELASTIC["press"]:
        sys.exit(f"the program ends press with {ELASTIC['press']}")
    linked = run("ldd", program)
    for name in STRANGERS:
        if re.search(rf"lib{name}", linked):
            sys.exit(f"it is linked with lib{name}:\n{linked}")


def check_full(program, picture, environment):
    said = run(program, picture, env=environment)
    print(said, end="")
    found = re.match(r"(\d+) triangles cover (\d+) of 76800 pixels", said)
    if not found or int(found[1]) < 500 or not 1000 < int(found[2]) < 70000:
        sys.exit("which is not what a picture of scissors shows")
    if picture.read_bytes()[:4] != b"\x89PNG":
        sys.exit(f"{picture} is no picture")


def main():
    cmake, build, compiler = sys.argv[1], Path(sys.argv[2]), sys.argv[3]
    staging, core, full = build / "staging", build / "consumer", build / "consumer_full"
    for old in (staging, core, full):
        shutil.rmtree(old, ignore_errors=True)
    run(cmake, "--install", build, "--prefix", staging)
    quoted = [header for header in (staging / "include").rglob("*.h") if re.search(r'#include "', header.read_text())]
    if quoted:
        sys.exit(f"{quoted[0]} includes a header that is not installed under its name")
    environment = {**os.environ, "RESECT_DATA": str(staging / "share" / "resect")}
    check_core(built("project", "stepped_liver", cmake, core, staging, compiler), environment)
    if list(staging.rglob("resectFull.cmake")):
        check_full(built("project_full", "pictured_scissors", cmake, full, staging, compiler), full / "scissors.png",
                   environment)
    return 0


if __name__ == "__main__":
    sys.exit(main())
