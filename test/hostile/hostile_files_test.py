"""hostile_files_test.py RESECT FOLDER

Lets the program read models that ask for other files, under strace: nothing else is opened, no socket is made, and
nothing of the other files arrives.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import hostile_files

SKIPPED = 77
CALL = re.compile(r"^(?P<pid>\d+) +(?P<call>\w+)\((?P<arguments>.*)\) += (?P<result>-?\d+)")


def prepare(folder):
    shutil.rmtree(folder, ignore_errors=True)
    inner = folder / "models"
    inner.mkdir(parents=True)
    for place in [inner / "secret", folder / "above"]:
        place.with_suffix(".iv").write_bytes(hostile_files.secret_inventor())
        place.with_suffix(".bin").write_bytes(hostile_files.secret_buffer())
        place.with_suffix(".mtl").write_text("newmtl a\nmap_Kd secret.bin\n")
    (inner / ".hidden.bin").write_bytes(hostile_files.secret_buffer())
    (inner / "link.bin").symlink_to(folder / "above.bin")
    (inner / "folder.bin").mkdir()
    os.mkfifo(inner / "pipe.bin")
    files = hostile_files.hostile_files(inner)
    for name, content in files.items():
        (inner / name).write_bytes(content)
    return inner, sorted(files)


def check(program, folder, name, log):
    """A list of complaints."""
    run = subprocess.run(["strace", "-f", "-qq", "-e", "trace=file,network,process", "-o", log, program, "info", name],
                         cwd=folder, capture_output=True, timeout=60)
    output = run.stdout + run.stderr
    wrong = []
    if run.returncode not in (0, 1):
        wrong.append(f"exit status {run.returncode}")
    if b"4321.5" in output:
        wrong.append("the other file's numbers arrived")
    if run.returncode == 1 and (output.count(b"\n") != 1 or not output.startswith(b"resect: error: ")):
        wrong.append(f"not one sentence: {output!r}")
    main = None
    for line in log.read_text(errors="replace").splitlines():
        call = CALL.match(line)
        if not call:
            continue
        main = main or call["pid"]
        opens = call["call"] in ("open", "openat", "openat2", "creat") and int(call["result"]) >= 0
        path = (re.search(r'"((?:[^"\\]|\\.)*)"', call["arguments"]) or [None, ""])[1]
        if call["call"] in ("socket", "connect", "sendto") and int(call["result"]) >= 0:
            wrong.append(f"a socket: {line}")
        if call["call"] in ("execve", "execveat") and call["pid"] != main:
            wrong.append(f"a program started: {line}")
        if opens and pathlib.PurePath(path).name != name and (
                str(folder) in path or not path.startswith("/") or path in ("/etc/passwd", "/dev/zero")):
            wrong.append(f"another file opened: {line}")
    return [f"{name}: {complaint}" for complaint in wrong]


def main():
    program, folder = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    if not shutil.which("strace") or subprocess.run(["strace", "-o", os.devnull, "true"], capture_output=True).returncode:
        print("skipped: strace is missing or may not trace")
        return SKIPPED
    inner, names = prepare(folder)
    log = folder / "trace.txt"
    complaints = [c for name in names for c in check(program, inner, name, log)]

    # What is allowed still works, so that the refusals above say something.
    (inner / "own buffer.bin").write_bytes(hostile_files.secret_buffer())
    (inner / "honest.gltf").write_bytes(hostile_files.gltf("own%20buffer.bin"))
    honest = subprocess.run([program, "info", "honest.gltf"], cwd=inner, capture_output=True, text=True)
    if honest.returncode != 0 or "triangles       4" not in honest.stdout:
        complaints.append(f"honest.gltf is not read: {honest.stdout}{honest.stderr}")
    for complaint in complaints:
        print(complaint)
    print(f"{len(names)} hostile files, {len(complaints)} complaints")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
