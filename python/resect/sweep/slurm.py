"""The script of a Slurm job array that runs a sweep in parts."""

import pathlib
import shlex
import shutil
import subprocess
import sys

import resect

SCRIPT = """#!/bin/bash
#SBATCH --job-name=resect-sweep
#SBATCH --array=0-{last}
#SBATCH --cpus-per-task=1
#SBATCH --output={log}
# Each task of the array runs a part of the rows. A part that was cut off goes on where it was when it is run again.
exec {python} -m resect.sweep {plan} --output {output} --part "$SLURM_ARRAY_TASK_ID/{parts}" --quiet
"""


def write_script(plan, output, parts):
    """Writes OUTPUT.slurm.sh and returns its path."""
    output = pathlib.Path(output).resolve()
    script = output.with_name(output.name + ".slurm.sh")
    quote = lambda path: shlex.quote(str(path))
    script.write_text(SCRIPT.format(last=parts - 1, parts=parts, plan=quote(pathlib.Path(plan).resolve()),
                                    output=quote(output), log=quote(output.with_name(output.name + ".slurm-%a.log")),
                                    python=quote(sys.executable)))
    script.chmod(0o755)
    return script


def submit(script, plan, output):
    """Submits the array, and after it the job that joins the parts. Returns what sbatch said."""
    if not shutil.which("sbatch"):
        raise resect.Error(f"{script} is written, but sbatch is not installed here; submit it where Slurm is, then run "
                           f"resect sweep {plan} --output {output} --collect")
    array = subprocess.run(["sbatch", "--parsable", str(script)], capture_output=True, text=True)
    if array.returncode:
        raise resect.Error(f"sbatch refused {script}: {array.stderr.strip()}")
    number = array.stdout.strip().split(";")[0]
    collect = shlex.join([sys.executable, "-m", "resect.sweep", str(pathlib.Path(plan).resolve()), "--output",
                          str(pathlib.Path(output).resolve()), "--collect", "--quiet"])
    joined = subprocess.run(["sbatch", "--parsable", f"--dependency=afterany:{number}", "--job-name=resect-collect",
                             f"--output={pathlib.Path(output).resolve()}.slurm-collect.log", "--wrap", collect],
                            capture_output=True, text=True)
    if joined.returncode:
        raise resect.Error(f"sbatch refused the job that joins the parts: {joined.stderr.strip()}")
    return f"job {number}, then job {joined.stdout.strip().split(';')[0]} joins the parts into {output}"
