"""The table of results: a journal while the sweep runs, a sorted table at its end."""

import csv
import os
import pathlib

import resect


def columns(plan, results):
    """Row, settings, results, and what proves them, in the order of the table."""
    found = {}
    for result in results:
        found.update(dict.fromkeys(result))
    own = ("row", "state_hash", "setup", "seconds", "error")
    return ["row", *plan.keys, *(c for c in found if c not in own and c not in plan.keys), *own[1:]]


def write_table(path, plan, results):
    """Writes the sorted table as .csv, or as .parquet where pyarrow is installed; complete or not at all."""
    path = pathlib.Path(path)
    names = columns(plan, results)
    rows = [{**plan.rows[r["row"]], **r} for r in sorted(results, key=lambda r: r["row"])]
    new = path.with_name(f".{path.name}.{os.getpid()}.tmp")
    try:
        if path.suffix == ".parquet":
            _write_parquet(new, names, rows)
        else:
            with open(new, "w", newline="", encoding="utf-8") as file:
                writer = csv.DictWriter(file, names, restval="", lineterminator="\n")
                writer.writeheader()
                writer.writerows(rows)
        os.replace(new, path)
    except OSError as e:
        raise resect.Error(f"{path}: cannot be written: {e.strerror}") from None
    finally:
        new.unlink(missing_ok=True)


def check_target(path, inputs):
    """Raises resect.Error if the table could not be written to this path at the end, or if it is one of the inputs."""
    path = pathlib.Path(path)
    if path.suffix not in (".csv", ".parquet"):
        raise resect.Error(f"{path}: a table is written as .csv or .parquet")
    if path.suffix == ".parquet":
        _pyarrow()
    if path.exists() and any(path.samefile(p) for p in inputs):
        raise resect.Error(f"{path}: is read by the sweep; name another table by --output")
    if not path.parent.is_dir() or not os.access(path.parent, os.W_OK):
        raise resect.Error(f"{path}: the folder {path.parent} is not there or cannot be written")


def _pyarrow():
    try:
        import pyarrow
        import pyarrow.parquet
        return pyarrow
    except ImportError:
        raise resect.Error("a table is written as .parquet by pyarrow, which is not installed; use .csv") from None


def _write_parquet(path, names, rows):
    arrow = _pyarrow()
    arrow.parquet.write_table(arrow.table({n: [r.get(n) for r in rows] for n in names}), path)


def read_table(path):
    """The rows of a .csv as dictionaries of texts. A last line that was torn off is left out."""
    try:
        with open(path, newline="", encoding="utf-8") as file:
            text = file.read()
    except (OSError, UnicodeDecodeError) as e:
        raise resect.Error(f"{path}: {e}") from None
    whole = text[:text.rfind("\n") + 1]
    return list(csv.DictReader(whole.splitlines(keepends=True)))


class Journal:
    """Results in the order in which they come: a valid .csv at every moment.

    Rows of an earlier sweep, interrupted or finished, are taken over if their setup is that of the plan. finished: path
    of the table that a finished sweep left, or None.
    """

    def __init__(self, path, plan, finished=None):
        self.path, self._plan = pathlib.Path(path), plan
        self.results = {}
        for earlier in (finished, self.path):
            if earlier and earlier.suffix == ".csv" and earlier.exists():
                for row in read_table(earlier):
                    result = self._own(row)
                    if result:
                        self.results[result["row"]] = result
        self._names = None
        self._file = None
        if self.results:
            self._begin(self.results.values())

    def _own(self, row):
        try:
            number = int(row["row"])
            if number >= len(self._plan.rows) or row["setup"] != self._plan.setup(number) or row["error"]:
                return None
            result = {k: v for k, v in row.items() if k not in self._plan.keys and v not in (None, "")}
            return {**result, "row": number, "error": ""}
        except (KeyError, TypeError, ValueError):
            return None

    def _begin(self, results):
        """Writes the journal anew with what is known; it is in place before the next result comes."""
        self._names = columns(self._plan, results)
        if self._file:
            self._file.close()
        new = self.path.with_name(f".{self.path.name}.{os.getpid()}.tmp")
        file = open(new, "w", newline="", encoding="utf-8")
        self._writer = csv.DictWriter(file, self._names, restval="", lineterminator="\n")
        self._writer.writeheader()
        self._file = file
        for result in self.results.values():
            self._write(result)
        file.flush()
        os.replace(new, self.path)

    def _write(self, result):
        self._writer.writerow({**self._plan.rows[result["row"]], **result})

    def add(self, result):
        self.results[result["row"]] = result
        try:
            if self._names is None or not set(result) <= set(self._names):
                self._begin(self.results.values())
                return
            self._write(result)
            self._file.flush()
        except OSError as e:
            raise resect.Error(f"{self.path}: cannot be written: {e.strerror}") from None

    def close(self, remove=False):
        if self._file:
            self._file.close()
        if remove:
            self.path.unlink(missing_ok=True)
