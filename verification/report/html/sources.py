"""The files a report is made from, as plain values: results of the criteria, cases, runs, histories."""

import json
import tomllib
from functools import cached_property

import numpy as np


def read_json(path):
    """The value of a JSON file; None when the file is not there."""
    if not path.is_file():
        return None
    try:
        return json.loads(path.read_text())
    except ValueError as error:
        raise ValueError(f"{path}: {error}") from None


class Table:
    """A CSV with one header line: columns by name as arrays."""

    def __init__(self, path):
        with path.open() as file:
            self.names = file.readline().strip().split(",")
            data = np.loadtxt(file, delimiter=",", ndmin=2)
        self.data = data if data.size else np.empty((0, len(self.names)))

    def __contains__(self, name):
        return name in self.names

    def __getitem__(self, name):
        return self.data[:, self.names.index(name)]

    @property
    def object_column(self):
        """Name of the column that says whose row it is, None for a table of one object."""
        return next((name for name in ("node", "rbody", "element") if name in self.names), None)

    def of(self, thing):
        """The rows of one node, body or element."""
        out = object.__new__(Table)
        out.names = self.names
        out.data = self.data if thing is None else self.data[self[self.object_column] == thing]
        return out

    def has_time(self, at):
        """Whether a row stands at this time; "end", "max" and "min" always have one."""
        return isinstance(at, str) or bool(np.any(np.abs(self["time"] - at) <= 1e-9 * max(abs(at), 1e-300)))

    def value(self, column, at):
        """A column at "end", "max", "min" or a time, linear between rows. None when there is none."""
        values, times = self[column], self["time"]
        if not len(values):
            return None
        if at in ("max", "min"):
            return float(values.max() if at == "max" else values.min())
        return float(values[-1]) if at == "end" else float(np.interp(at, times, values))


def table_or_none(path):
    return Table(path) if path.is_file() else None


class Case:
    """A folder of cases/, its runs and the results of its criteria."""

    def __init__(self, folder, records, runs_folder, optimized_folder):
        self.name = folder.name
        self.folder = folder
        toml = tomllib.loads((folder / "case.toml").read_text())
        self.statement, self.source = toml["statement"], toml["source"]
        self.features, self.covers = toml["features"], toml.get("covers", [])
        self.family = toml.get("family", "")
        self.deck = toml.get("deck", f"{self.name}_0000.rad")
        self.runs = {run["name"]: run for run in toml["run"]}
        self.criteria = {criterion["id"]: criterion for criterion in toml["criterion"]}
        self.records = records
        self.runs_folder = runs_folder / self.name
        self.optimized_folder = optimized_folder / self.name

    @property
    def failed(self):
        return [record for record in self.records if record["verdict"] == "failed"]

    @property
    def skipped(self):
        return [record for record in self.records if record["verdict"] not in ("ok", "failed")]

    @cached_property
    def run_json(self):
        """run.json of each run that was done."""
        found = {name: read_json(self.runs_folder / name / "run.json") for name in self.runs}
        return {name: run for name, run in found.items() if run is not None}

    def deck_of(self, run_name):
        return self.folder / self.runs[run_name].get("deck", self.deck)

    def files(self):
        """All files that decide its pictures. run.json is not among them: it holds wall times."""
        of_runs = [path for name in self.runs for folder in (self.runs_folder, self.optimized_folder)
                   for path in sorted((folder / name).glob("*.csv"))]
        return [*sorted(path for path in self.folder.iterdir() if path.suffix in (".rad", ".csv", ".toml")), *of_runs]


class Sources:
    """Everything a report is made from."""

    def __init__(self, options):
        self.options = options
        records = read_json(options.results)
        if records is None:
            raise ValueError(f"{options.results} is missing: scripts/verify makes it")
        self.records = records
        by_case = {}
        for record in records:
            by_case.setdefault(record["case"], []).append(record)
        folders = sorted(path.parent for path in options.cases.glob("*/case.toml"))
        absent = sorted(set(by_case) - {folder.name for folder in folders})
        if absent:
            raise ValueError(f"{options.results} has criteria of {', '.join(absent)}, which {options.cases} does not hold")
        self.cases = [Case(folder, by_case[folder.name], options.runs, options.optimized)
                      for folder in folders if folder.name in by_case]
        self.not_run = [folder.name for folder in folders if folder.name not in by_case]

    def beside(self, name):
        """A JSON file beside the report: traceability, mutation, accuracy, bench, lockstep, stability."""
        return read_json(self.options.out.parent / name)
