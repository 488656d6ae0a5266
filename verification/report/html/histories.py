"""The curves of a case, and their differences from the measured histories."""

from dataclasses import dataclass, field

import numpy as np

from sources import table_or_none

FORCES = ("FNX", "FNY", "FNZ", "FTX", "FTY", "FTZ")
ENERGIES = ("CE_ELAST", "CE_FRIC", "CE_DAMP", "QFRIC")
MOST_LINES = 6


@dataclass
class Line:
    label: str
    x: np.ndarray
    y: np.ndarray
    colour: int = 0
    style: str = "run"  # run, other, measured, expected, tolerance


@dataclass
class Panel:
    title: str
    unit: str = ""
    lines: list = field(default_factory=list)
    log: bool = False


def rate(table, column):
    """Mean rate of an impulse between rows, at the middle of each: a force."""
    t, y = table["time"], table[column]
    keep = np.concatenate([[True], np.diff(t) > 0])
    t, y = t[keep], y[keep]
    return (t[1:] + t[:-1]) / 2, np.diff(y) / np.diff(t)


def large(table, columns, least=1e-9):
    """Those of the columns that are more than rounding beside the largest of them."""
    present = [name for name in columns if name in table and len(table.data)]
    sizes = {name: float(np.abs(table[name]).max()) for name in present}
    top = max(sizes.values(), default=0.0)
    return [name for name in present if sizes[name] > least * top]


def same(a, b, columns):
    """Whether two runs give visibly the same curve."""
    if a is None or b is None or a.data.shape != b.data.shape:
        return False
    return all(np.abs(a[c] - b[c]).max(initial=0) <= 1e-3 * np.abs(b[c]).max(initial=0) for c in columns)


class Histories:
    """The CSVs of a case, read once."""

    def __init__(self, case):
        self.case = case
        self.kept = {}

    def __call__(self, folder, file):
        path = folder / file
        if path not in self.kept:
            self.kept[path] = table_or_none(path)
        return self.kept[path]

    def run(self, name, file):
        return self(self.case.runs_folder / name, file)

    def measured(self, file):
        return self(self.case.folder, file)

    def interfaces(self, run):
        return sorted(path.name for path in (self.case.runs_folder / run).glob("interface_*.csv"))


def force_panels(histories, main_run, other_run):
    """Forces on the tool and energies of each interface, the measured ones as dots."""
    files = histories.interfaces(main_run)
    panels = []
    for title, unit, columns, force in (("force on the tool, mean over the output step", "force", FORCES, True),
                                        ("energy", "energy", ENERGIES, False)):
        panel = Panel(title, unit)
        for number, file in enumerate(files):
            table, other, seen = histories.run(main_run, file), histories.run(other_run, file), histories.measured(file)
            chosen = large(table, columns)
            if len(files) > 1:
                chosen = sorted(chosen, key=lambda c: -np.abs(table[c]).max())[:1]
            for column in chosen:
                colour = number if len(files) > 1 else columns.index(column)
                name = column
                label = f"interface {file[10:-4]} {name}" if len(files) > 1 else name
                curve = (lambda t, c=column: rate(t, c)) if force else (lambda t, c=column: (t["time"], t[c]))
                panel.lines.append(Line(label, *curve(table), colour))
                if other is not None and column in other and not same(table, other, [column]):
                    panel.lines.append(Line("", *curve(other), colour, "other"))
                if seen is not None and column in seen and len(seen.data) > 1:
                    panel.lines.append(Line("", *curve(seen), colour, "measured"))
        if panel.lines:
            panels.append(panel)
    return panels


def temperature_panel(histories, main_run, other_run):
    table, seen, other = (histories.run(main_run, "nodes.csv"), histories.measured("nodes.csv"), histories.run(other_run, "nodes.csv"))
    if table is None or "TEMP" not in table:
        return []
    change = {node: float(np.ptp(table.of(node)["TEMP"])) for node in np.unique(table["node"])}
    nodes = sorted(change, key=lambda n: (-change[n], n))[:3]
    if not nodes or change[nodes[0]] == 0:
        return []
    panel = Panel("temperature of the nodes that change most", "K")
    for colour, node in enumerate(sorted(nodes)):
        for source, style in ((table, "run"), (other, "other"), (seen, "measured")):
            if source is None or "TEMP" not in source or (style == "other" and same(table.of(node), source.of(node), ["TEMP"])):
                continue
            rows = source.of(node)
            if len(rows.data):
                panel.lines.append(Line(f"node {node:.0f}" if style == "run" else "", rows["time"], rows["TEMP"], colour, style))
    return [panel]


def value_panels(histories, most=3):
    """The curves that single values are taken from, with the expected values as rings."""
    groups = {}
    for criterion in histories.case.criteria.values():
        if "expected" in criterion:
            stem = criterion["file"].split("_")[0].removesuffix(".csv")
            groups.setdefault((stem, criterion["column"]), []).append(criterion)
    panels = []
    for (stem, column), criteria in sorted(groups.items(), key=lambda item: -len(item[1]))[:most]:
        panel = Panel({"interface": "interface", "nodes": "nodes", "rbody": "rigid body"}.get(stem, stem) + f": {column}", criteria[0]["unit"])
        drawn = {}
        for criterion in criteria:
            table = histories.run(criterion["run"], criterion["file"])
            if table is None or column not in table:
                continue
            key = (criterion["run"], criterion["file"], criterion.get("node"))
            rows = table.of(criterion.get("node"))
            if not len(rows.data):
                continue
            if key not in drawn:
                if len(drawn) == MOST_LINES:
                    continue
                drawn[key] = len(drawn)
                words = [w for w in (criterion["run"], f"interface {criterion['file'][10:-4]}" if stem == "interface" and len(histories.interfaces(criterion["run"])) > 1 else "",
                                     f"node {criterion['node']}" if criterion.get("node") is not None else "") if w]
                panel.lines.append(Line(", ".join(words), rows["time"], rows[column], drawn[key]))
            times = rows["time"]
            at = criterion["at"]
            when = times[-1] if at == "end" else times[rows[column].argmax()] if at == "max" else times[rows[column].argmin()] if at == "min" else at
            panel.lines.append(Line("", np.array([when]), np.array([criterion["expected"]]), drawn[key], "expected"))
        if any(len(line.x) > 1 for line in panel.lines):
            panels.append(panel)
    return panels


def scaled_difference(ours, reference, record):
    """(times, largest scaled difference of any column and object at each time of the reference)."""
    scales = {column["column"]: column["scale"] for column in record.get("columns", []) if column["scale"] > 0}
    which = reference.object_column
    worst = {}
    for thing in np.unique(reference[which]) if which else [None]:
        rows, mine = reference.of(thing), ours.of(thing) if ours.object_column else ours
        if not len(rows.data) or not len(mine.data):
            continue
        nearest = np.abs(mine["time"][:, None] - rows["time"][None, :]).argmin(axis=0) if len(mine.data) * len(rows.data) < 4e6 else \
            np.clip(np.searchsorted(mine["time"], rows["time"] - 1e-12 * mine["time"][-1]), 0, len(mine.data) - 1)
        for column, scale in scales.items():
            if column in rows and column in mine:
                for t, d in zip(rows["time"], np.abs(mine[column][nearest] - rows[column]) / scale):
                    worst[t] = max(worst.get(t, 0.0), d)
    times = np.array(sorted(worst))
    return times, np.array([worst[t] for t in times])


def difference_panel(histories, drawn):
    """Scaled differences from the measured histories, and of the optimized implementation from the reference."""
    panel = Panel("difference / largest value, and the tolerance", "-", log=True)
    colour = 0
    notes = []
    for record in histories.case.records:
        criterion = histories.case.criteria.get(record["id"], {})
        if "reference" not in criterion or not record.get("columns"):
            continue
        theirs = criterion["reference"]
        ours = histories.run(record["run"], criterion.get("ours", "nodes.csv" if theirs == "tool.csv" else theirs))
        seen = histories.measured(theirs)
        if ours is None or seen is None:
            continue
        if "nodes" in criterion:
            seen_rows = object.__new__(type(seen))
            seen_rows.names, seen_rows.data = seen.names, seen.data[np.isin(seen["node"], criterion["nodes"])]
            seen = seen_rows
        times, worst = scaled_difference(ours, seen, record)
        keep = np.ones(len(times), bool)
        keep &= times >= criterion.get("from", -np.inf)
        keep &= times <= criterion.get("until", np.inf)
        times, worst = times[keep], worst[keep]
        panel.lines.append(Line(record["id"], times[worst > 0], worst[worst > 0], colour))
        if len(times):
            panel.lines.append(Line("", times[[0, -1]], np.full(2, record["tolerance"]), colour, "tolerance"))
        colour += 1
    for name in drawn:
        for file in histories.interfaces(name):
            other = histories(histories.case.optimized_folder / name, file)
            ours = histories.run(name, file)
            if other is None or other.data.shape != ours.data.shape:
                continue
            scale = np.maximum(np.abs(ours.data).max(axis=0, initial=0), 1e-300)
            # A component that is only rounding beside the others has no scale of its own.
            columns = [ours.names.index(c) for group in (FORCES, ENERGIES) for c in large(ours, group)]
            if not columns:
                continue
            far = (np.abs(other.data - ours.data) / scale)[:, columns].max(axis=1, initial=0)
            panel.lines.append(Line(f"optimized, {name}", ours["time"][far > 0], far[far > 0], colour))
            notes.append(float(far.max(initial=0)))
            colour += 1
    return ([panel] if panel.lines else []), (max(notes) if notes else None)


def panels_of(case):
    """(panels, names of the runs drawn, largest difference of the optimized one or None)."""
    histories = Histories(case)
    done = [name for name in case.runs if (case.runs_folder / name).is_dir() and histories.interfaces(name)]
    if not done:
        return [], [], None
    main_run = next((name for name in done if case.runs[name].get("as_built", "") == "all"), done[0])
    other_run = next((name for name in ("documented", *done) if name in done and name != main_run), "")
    values = value_panels(histories)
    panels = force_panels(histories, main_run, other_run)
    if any(panel.title.endswith(ENERGIES) for panel in values):
        panels = [panel for panel in panels if panel.title != "energy"]  # it is among the values
    panels += temperature_panel(histories, main_run, other_run) + values
    differences, optimized = difference_panel(histories, [name for name in (main_run, other_run) if name])
    return panels + differences, [main_run, other_run] if other_run else [main_run], optimized
