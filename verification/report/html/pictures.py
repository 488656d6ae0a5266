"""The pictures of one case. Run in processes of their own: what goes in and out is plain."""

from pathlib import Path

import scene
from sources import table_or_none
from store import digest

HERE = Path(__file__).resolve().parent
CODE = digest(*(HERE / name for name in ("pictures.py", "scene.py", "histories.py", "curves.py", "laws.py", "sources.py")))
UNITS = {("Mg", "mm", "s"): {"force": "N", "energy": "mJ"}, ("kg", "m", "s"): {"force": "N", "energy": "J"},
         ("kg", "mm", "ms"): {"force": "kN", "energy": "J"}, ("g", "mm", "ms"): {"force": "N", "energy": "mJ"}}


def key(case):
    """Hash of everything that the pictures of a case show, its records' differences included."""
    records = [f"{record['id']} {record['tolerance']} {record['got']} {record.get('columns')}" for record in case.records]
    return digest(CODE, *case.files(), *records)


def units_of(summary):
    names = tuple(summary["units"][what] for what in ("mass", "length", "time"))
    mass, length, time = names
    return UNITS.get(names, {"force": f"{mass} {length}/{time}²", "energy": f"{mass} {length}²/{time}²"})


def draw_scene(case, program):
    """Of the first deck that is not refused."""
    for run in case.runs:
        found = scene.geometry(program, case.deck_of(run))
        if found is not None:
            return scene.draw(found, table_or_none(case.runs_folder / run / "rbody.csv"))
    return {"svg": "", "caption": "The deck is refused, as the case requires: there is no scene."}


def draw_case(case, program):
    import curves  # matplotlib takes a second to load, and is not needed when nothing changed
    import histories
    import laws

    out = {"scene": draw_scene(case, program), "curves": "", "runs": [], "optimized": None}
    panels, runs, out["optimized"] = histories.panels_of(case)
    if panels:
        summary = next(iter(case.run_json.values()))
        out["curves"] = curves.draw(panels, summary["units"]["time"], units_of(summary), case.name)
        out["runs"] = runs
        out["measured"] = any(line.style == "measured" for panel in panels for line in panel.lines)
        out["expected"] = any(line.style == "expected" for panel in panels for line in panel.lines)
        out["other"] = any(line.style == "other" for panel in panels for line in panel.lines)
        out["tolerance"] = any(line.style == "tolerance" for panel in panels for line in panel.lines)
    out["laws"] = laws.figure(case, program)
    return out


def draw_case_family(groups, salt):
    """Difference as a share of the tolerance for each criterion of a case family, one row for each case."""
    import curves
    import matplotlib.pyplot as plt

    kinds = ("ANALYTIC", "EXACT", "EXTERNAL", "CROSS", "REGRESSION")
    figure, axes = plt.subplots(figsize=(6.6, 0.6 + 0.17 * len(groups)), layout="constrained")
    for row, (_, points) in enumerate(groups):
        for kind, share in points:
            axes.plot(max(share, 1e-18), row, "o", ms=4, mfc="none", mew=0.9, color=curves.COLOURS[kinds.index(kind)])
    for kind in kinds:
        if any(k == kind for _, points in groups for k, _ in points):
            axes.plot([], [], "o", ms=4, mfc="none", mew=0.9, color=curves.COLOURS[kinds.index(kind)], label=kind)
    axes.axvline(1, color="#444444", lw=0.8)
    axes.set_xscale("log")
    axes.set_ylim(len(groups) - 0.4, -0.6)
    axes.set_yticks(range(len(groups)), [name for name, _ in groups])
    axes.set_xlabel("difference / tolerance (a criterion holds left of 1)")
    axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5))
    return curves.as_svg(figure, salt)
