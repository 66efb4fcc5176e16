"""python3 -m resect.sweep: runs a sweep, verifies its table, or writes a Slurm job array."""

import argparse
import os
import pathlib
import random
import re
import signal
import sys
import time

import resect
from resect.sweep import slurm, workers
from resect.sweep.operation import run_row, run_text
from resect.sweep.plan import read_plan
from resect.sweep.table import Journal, check_target, read_table, write_table


class Progress:
    """One line on a terminal, one line in ten seconds elsewhere."""

    def __init__(self, done, count, quiet):
        self.done = self.first = done
        self.count, self.quiet, self.begin, self.said = count, quiet, time.monotonic(), 0.0

    def tick(self):
        self.done += 1
        now = time.monotonic()
        terminal = sys.stderr.isatty()
        if self.quiet or (now - self.said < (0.2 if terminal else 10) and self.done < self.count):
            return
        self.said = now
        left = (now - self.begin) / (self.done - self.first) * (self.count - self.done)
        print(f"{self.done} of {self.count} operations, {left:.0f} s left", end="\r" if terminal else "\n",
              file=sys.stderr, flush=True)
        if terminal and self.done == self.count:
            print(file=sys.stderr)


def part_path(output, number, parts):
    return output.with_name(f"{output.stem}.part-{number}-of-{parts}.csv")


def jobs_of(plan, numbers):
    return [(n, plan.setup(n), plan.text(n)) for n in numbers]


def run(plan, given, output, journal_path, numbers, remove):
    """Runs those of the rows that the journal lacks; returns the exit status."""
    where = journal_path if journal_path.exists() else output
    journal = Journal(journal_path, plan, output)
    missing = [n for n in numbers if n not in journal.results]
    if len(missing) < len(numbers) and not given.quiet:
        print(f"{len(numbers) - len(missing)} of {len(numbers)} operations are in {where} already", file=sys.stderr)
    progress = Progress(len(numbers) - len(missing), len(numbers), given.quiet)
    jobs = jobs_of(plan, missing)
    if given.dask:
        results = workers.dask(jobs, given.dask, given.workers)
    elif given.workers == 1:
        results = map(run_row, jobs)
    else:
        results = workers.processes(jobs, given.workers)
    try:
        for result in results:
            journal.add(result)
            progress.tick()
    except KeyboardInterrupt:
        journal.close()
        if hasattr(results, "close"):
            results.close()
        print(f"\nstopped; {len(journal.results)} of {len(numbers)} operations are in {journal_path}; "
              "the same command goes on from there", file=sys.stderr)
        return 130
    except BaseException:
        journal.close()
        raise
    if output:
        write_table(output, plan, list(journal.results.values()))
    journal.close(remove)
    failed = [r for r in journal.results.values() if r["error"]]
    if failed and not given.quiet:
        print(f"{len(failed)} of {len(numbers)} operations could not be run; the first: {failed[0]['error']}",
              file=sys.stderr)
    return 1 if failed else 0


def collect(plan, output):
    """Joins the parts that a job array left into one table."""
    pattern = re.compile(re.escape(output.stem) + r"\.part-\d+-of-\d+\.csv")
    parts = sorted(p for p in output.parent.iterdir() if pattern.fullmatch(p.name))
    results = {}
    for part in parts:
        results.update(Journal(part, plan).results)
    missing = len(plan.rows) - len(results)
    if missing:
        raise resect.Error(f"{missing} of {len(plan.rows)} operations are in none of the {len(parts)} parts beside "
                           f"{output}; run those parts again, they go on where they were")
    write_table(output, plan, list(results.values()))
    for part in parts:
        part.unlink()


def verify(plan, table, count):
    """Runs some rows of a table again and compares the state hashes; returns the exit status."""
    if not pathlib.Path(table).is_file():
        raise resect.Error(f"{table} is not there yet; run the sweep first, without --verify")
    rows = {int(r["row"]): r for r in read_table(table)}
    done = [n for n, r in sorted(rows.items()) if n < len(plan.rows) and r["state_hash"]]
    if not done:
        raise resect.Error(f"{table}: has no results of this sweep")
    other = [n for n in done if rows[n]["setup"] != plan.setup(n)]
    if other:
        raise resect.Error(f"{table}: row {other[0]} is of another operation than the sweep describes now")
    chosen = sorted(random.Random(0).sample(done, min(count, len(done))))
    for n in chosen:
        found = run_text(plan.text(n), f"row {n}")
        if found["state_hash"] != rows[n]["state_hash"]:
            print(f"row {n}: the state is {found['state_hash']}, the table has {rows[n]['state_hash']}")
            return 1
    print(f"verified {len(chosen)} of {len(done)} operations, bit for bit")
    return 0


def parse(arguments):
    parser = argparse.ArgumentParser(prog="resect sweep", description="Run many operations that differ in some "
                                     "settings: one table in, one table out (docs/how-to/sweep.md).")
    parser.add_argument("plan", metavar="SWEEP.toml", help="what to run")
    parser.add_argument("-o", "--output", help="table for the results, .csv or .parquet; without it SWEEP.csv")
    parser.add_argument("--workers", type=int, default=len(os.sched_getaffinity(0)), help="processes; without it one a core")
    parser.add_argument("--dask", metavar="ADDRESS", help="run on Dask's workers: tcp://HOST:PORT of a scheduler, or local")
    parser.add_argument("--slurm", type=int, metavar="PARTS", nargs="?", const=20,
                        help="write and submit a Slurm job array of so many parts; without a number 20")
    parser.add_argument("--verify", type=int, metavar="N", help="run N rows of the table again and compare their bits")
    parser.add_argument("--part", metavar="I/N", help="run only part I, from 0, of N")
    parser.add_argument("--collect", action="store_true", help="join the parts into the table")
    parser.add_argument("--quiet", action="store_true", help="print no progress")
    return parser.parse_args(arguments)


def main(arguments=None):
    given = parse(arguments)
    if given.workers < 1:
        raise resect.Error(f"--workers is {given.workers}; give 1 or more")
    plan = read_plan(given.plan)
    output = pathlib.Path(given.output or pathlib.Path(given.plan).with_suffix(".csv")).absolute()
    check_target(output, plan.files)
    if given.verify is not None:
        return verify(plan, output, given.verify)
    if given.collect:
        collect(plan, output)
        return 0
    if given.slurm:
        script = slurm.write_script(given.plan, output, min(given.slurm, len(plan.rows)))
        print(slurm.submit(script, given.plan, output))
        return 0
    numbers = range(len(plan.rows))
    if given.part:
        match = re.fullmatch(r"(\d+)/(\d+)", given.part)
        if not match or int(match[1]) >= int(match[2]):
            raise resect.Error(f"--part is \"{given.part}\"; give I/N with I from 0 to N - 1, as 3/20")
        number, parts = int(match[1]), int(match[2])
        given.workers = 1
        return run(plan, given, None, part_path(output, number, parts), numbers[number::parts], remove=False)
    status = run(plan, given, output, output.with_name(output.stem + ".partial.csv"), numbers, remove=True)
    if status != 130 and not given.quiet:
        print(f"{len(plan.rows)} operations in {output}", file=sys.stderr)
    return status


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, signal.default_int_handler)  # ends as Ctrl-C does
    try:
        sys.exit(main())
    except resect.Error as e:
        print(f"resect: error: {e}", file=sys.stderr)
        sys.exit(1)
    except KeyboardInterrupt:
        sys.exit(130)
