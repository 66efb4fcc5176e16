"""What a sweep is to do: the scenario and the rows, from SWEEP.toml."""

import csv
import dataclasses
import hashlib
import itertools
import pathlib
import random
import tomllib

import resect
from resect.sweep.settings import changed
from resect.sweep.toml_text import toml_text

MOST_ROWS = 1_000_000


@dataclasses.dataclass(frozen=True)
class Plan:
    """The rows of a sweep. A row is a dictionary of settings; all rows have the same keys, in the same order."""

    scenario: dict  # as tomllib gives it
    name: str  # of the scenario, for people
    keys: tuple
    rows: tuple
    files: tuple  # that were read

    def text(self, number):
        """The scenario of a row as TOML."""
        return toml_text(changed(self.scenario, self.rows[number], f"row {number}"))

    def setup(self, number):
        """Digest of the text: equal for equal operations."""
        return hashlib.sha256(self.text(number).encode()).hexdigest()[:16]


def _read_toml(path):
    try:
        with open(path, "rb") as file:
            return tomllib.load(file)
    except FileNotFoundError:
        raise resect.Error(f"{path}: there is no such file") from None
    except (OSError, tomllib.TOMLDecodeError, UnicodeDecodeError) as e:
        raise resect.Error(f"{path}: {e}") from None


def _scenario_path(name, folder):
    for path in (folder / name, pathlib.Path(name), *(pathlib.Path(resect.data_folder(), kind, f"{name}.toml")
                                                     for kind in ("scenarios", "tasks"))):
        if path.is_file():
            return path
    raise resect.Error(f"there is no scenario \"{name}\"; name a file, or one of {', '.join(resect.scenario_names())}")


def _with_paths(document, folder):
    """Files that lie beside the scenario get their whole path."""
    organs = document.get("organ", [])
    for table, keys in [(o, ("source", "vessels")) for o in (organs if isinstance(organs, list) else [organs])] + \
                       [(t, ("model",)) for t in document.get("tool", [])]:
        for key in keys:
            if isinstance(table.get(key), str) and (folder / table[key]).is_file():
                table[key] = str((folder / table[key]).resolve())
    return document


def number_or_text(text):
    """A cell of a table as the value that was meant."""
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            pass
    return {"true": True, "false": False}.get(text, text)


def _rows_of_file(path):
    try:
        with open(path, newline="", encoding="utf-8") as file:
            reader = csv.DictReader(file)
            return [{k: number_or_text(v) for k, v in row.items()} for row in reader]
    except (OSError, UnicodeDecodeError, csv.Error) as e:
        raise resect.Error(f"{path}: {e}") from None


def _random_rows(table, where):
    table = dict(table)
    count, seed = table.pop("count", None), table.pop("seed", 0)
    if not isinstance(count, int) or count < 1:
        raise resect.Error(f"{where}: [random] needs count, the number of rows")
    draw = random.Random(seed)
    rows = []
    for _ in range(count):
        row = {}
        for key, between in table.items():
            if not (isinstance(between, list) and len(between) == 2 and
                    all(isinstance(b, (int, float)) and not isinstance(b, bool) for b in between)):
                raise resect.Error(f"{where}: [random] {key} must be [least, greatest]")
            row[key] = float(f"{draw.uniform(*between):.9g}")  # as the table shows it
        rows.append(row)
    return rows


def read_plan(path):
    """Reads SWEEP.toml; raises resect.Error with one sentence if anything in it is wrong."""
    path = pathlib.Path(path)
    given = _read_toml(path)
    unknown = set(given) - {"scenario", "fixed", "vary", "random", "rows"}
    if unknown:
        raise resect.Error(f"{path}: unknown key {sorted(unknown)[0]}; use scenario, fixed, vary, random, rows")
    if not isinstance(given.get("scenario"), str):
        raise resect.Error(f"{path}: give scenario, the name of a scenario or a file")
    for name in ("fixed", "vary", "random"):
        if not isinstance(given.get(name, {}), dict):
            raise resect.Error(f"{path}: {name} must be a table, [{name}]")
    source = _scenario_path(given["scenario"], path.parent)
    scenario = changed(_with_paths(_read_toml(source), source.parent), given.get("fixed", {}), f"{path}: [fixed]")

    files = [path, source]
    vary = given.get("vary", {})
    for key, values in vary.items():
        if not isinstance(values, list) or not values:
            raise resect.Error(f"{path}: [vary] {key} must be a list of values")
    rows = [dict(zip(vary, values)) for values in itertools.product(*vary.values())]
    if "rows" in given:
        files.append(path.parent / str(given["rows"]))
        rows = [{**a, **b} for a in _rows_of_file(files[-1]) for b in rows]
    if "random" in given:
        rows = [{**a, **b} for a in rows for b in _random_rows(given["random"], path)]
    if not 0 < len(rows) <= MOST_ROWS:
        raise resect.Error(f"{path}: describes {len(rows)} operations; give 1 to {MOST_ROWS}")
    plan = Plan(scenario, given["scenario"], tuple(rows[0]), tuple(rows), tuple(files))
    for number in (0, len(rows) - 1):  # a mistake is told before the first operation, not in every row
        resect.Scenario.parse(plan.text(number), f"{path}: row {number}")
    return plan
