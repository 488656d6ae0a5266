"""Each departure with the cases that show it: the number without it, with it, and the measured one."""

import json
import subprocess
import tempfile
from pathlib import Path

from histories import Histories


def listed(program):
    """Rows of type21 departures."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "departures.json"
        done = subprocess.run([program, "departures", "--json", out], capture_output=True, text=True)
        if done.returncode != 0:
            raise RuntimeError(f"type21 departures: exit code {done.returncode}: {done.stderr.strip()}")
        return json.loads(out.read_text())


def switch(case, row_id):
    """{run without it: run with it} and {run with it: run without it} of a case, by what the runs switch on."""
    sets = {name: run.get("as_built", "") for name, run in case.runs.items()}
    by_set = {text: name for name, text in sets.items()}
    off = {name: by_set.get("all") for name, text in sets.items() if text == f"all,-{row_id}"}
    on = {name: by_set.get("") for name, text in sets.items() if text == row_id}
    return off, on


def sizes(case, row_id):
    """Numbers of the criteria that test this departure and no other."""
    histories = Histories(case)
    off_runs, on_runs = switch(case, row_id)
    out = []
    for record in case.records:
        criterion = case.criteria[record["id"]]
        if "column" not in criterion or not isinstance(record["got"], (int, float)) or "differs_from" in criterion:
            continue
        run = criterion["run"]
        other = off_runs.get(run) or on_runs.get(run)
        if run not in off_runs and run not in on_runs:
            continue

        def taken(table):
            # Measured histories are thinned: what lies between their rows was not measured.
            if table is None or criterion["column"] not in table or not table.has_time(criterion["at"]):
                return None
            return table.of(criterion.get("node")).value(criterion["column"], criterion["at"])

        beside = taken(histories.run(other, criterion["file"])) if other else None
        if any(c["run"] == other and "expect_exit" in c for c in case.criteria.values()):
            beside = "refused"
        off, on = (record["got"], beside) if run in off_runs else (beside, record["got"])
        out.append({"case": case.name, "criterion": record["id"], "what": f"{criterion['column']}" + (f", node {criterion['node']}" if "node" in criterion else ""),
                    "at": criterion["at"], "unit": criterion["unit"], "off": off, "on": on, "measured": taken(histories.measured(criterion["file"]))})
    return out


def misses(case, row_id):
    """A departure that cannot be switched on: our number and the measured one, where the case gives their difference."""
    out = []
    for record in case.records:
        criterion = case.criteria[record["id"]]
        if "differs_from" not in criterion or f"departure {row_id}" not in case.covers:
            continue
        histories = Histories(case)
        node = criterion.get("node")
        ours, seen = (table.of(node).value(criterion["column"], criterion["at"]) if table is not None and table.has_time(criterion["at"]) else None
                      for table in (histories.run(criterion["run"], criterion.get("file", criterion["differs_from"])), histories.measured(criterion["differs_from"])))
        out.append({"case": case.name, "criterion": record["id"], "what": criterion["column"], "at": criterion["at"], "unit": criterion.get("unit", ""),
                    "off": ours, "on": None, "measured": seen})
    return out


def table(program, cases, most=3):
    """Rows of the atlas of departures."""
    rows = listed(program)
    for row in rows:
        showing = [case for case in cases if f"departure {row['id']}" in case.covers]
        row["cases"] = [case.name for case in showing]
        numbers = []
        for case in cases:
            numbers += sizes(case, row["id"]) if row["available"] else misses(case, row["id"])
        # Only numbers that differ show the size of the departure.
        row["numbers"] = [n for n in numbers if n["off"] != n["on"]][:most]
    return rows
