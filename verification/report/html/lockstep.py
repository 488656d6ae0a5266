"""Reference and optimized side by side, from build/report/lockstep.json (type21 lockstep --json)."""

from pathlib import Path

import curves
import words
from store import digest

HERE = Path(__file__).resolve().parent
MARKS = "os^Dv"


def largest(run):
    return max((quantity["largest_ulps"] for quantity in run["quantities"] if quantity["compared"]), default=0.0)


def draw(runs, allowed):
    """The largest difference of each quantity in each run, the runs ordered by the worst of them."""
    import matplotlib.pyplot as plt

    names = [quantity["name"] for quantity in runs[0]["quantities"]]
    figure, axes = plt.subplots(figsize=(6.6, 3.0), layout="constrained")
    for number, name in enumerate(names):
        points = [(place, quantity["largest_ulps"]) for place, run in enumerate(runs) for quantity in run["quantities"]
                  if quantity["name"] == name and quantity["compared"] and quantity["largest_ulps"] > 0]
        if points:
            axes.plot(*zip(*points), MARKS[number % len(MARKS)], ms=3.2, mfc="none", mew=0.9, color=curves.COLOURS[number], label=name)
    axes.axhline(allowed, color="#444444", lw=0.8)
    axes.annotate("allowed", (0.005, allowed), xycoords=("axes fraction", "data"), va="bottom", fontsize=8, color="#444444")
    axes.set_yscale("log")
    axes.set_xlabel("runs, the worst first")
    axes.set_title("largest difference in a run [ulp of the magnitudes that enter]")
    curves.legend_below(figure, axes, 5)
    return curves.as_svg(figure, "lockstep")


def note(found, runs):
    total = found["all"]
    text = (f"{words.plural(total['decisions'], 'decision')} of {words.plural(len(runs), 'run')} and {words.number(total['cycles'])} cycles were compared, "
            + ("none differs" if not total["different"] else f"{total['different']} DIFFER"))
    worst = max(runs, key=largest, default=None)
    if worst is not None:
        text += f"; numbers differ by at most {largest(worst):.3g} ulps ({worst['name']}); {found['ulps_allowed']:g} are allowed"
    return text + "."


def section(found, store):
    """None without a lockstep.json."""
    if not isinstance(found, dict) or not found.get("runs"):
        return None
    refused = [run["name"] for run in found["runs"] if run["refused"]]
    runs = sorted((run for run in found["runs"] if not run["refused"]), key=largest, reverse=True)
    if not runs:
        return None
    key = digest(HERE / "lockstep.py", HERE / "curves.py", repr([(run["name"], run["quantities"]) for run in runs]), repr(found["ulps_allowed"]))
    apart = [run for run in runs if run.get("free_runs_apart") is not None]
    return {"ok": found["ok"], "allowed": found["ulps_allowed"], "total": found["all"], "runs": runs, "refused": refused, "free": apart,
            "free_worst": max(apart, key=lambda run: run["free_runs_apart"], default=None),
            "bad": [run for run in found["runs"] if not run["ok"]],
            "figure": {"svg": store.get("lockstep", key, lambda: draw(runs, found["ulps_allowed"])), "title": "Largest difference of the two implementations in each run",
                       "note": note(found, runs)}}
